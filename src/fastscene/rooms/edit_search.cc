// Free places where the layout's own search finds none: a fine grid about what the place is said by, and small shifts.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/validate.h"

namespace fastscene::editing {
namespace {

constexpr float kFlat = 0.03f;    // metres: no higher, it is a rug
constexpr int kMostChecks = 200;  // of the whole room: a fraction of a second

std::set<std::string> texts_of(const std::vector<Fault>& faults) {
    std::set<std::string> out;
    for (const Fault& f : faults) out.insert(f.text);
    return out;
}

struct Candidate {
    Vec2f at;
    float yaw = 0;
    float cost = 0;
};

// The boxes of what a place is said by: things, or openings as thin boxes.
std::vector<Footprint> anchors_of(const Plan& plan, const std::vector<Placed>& placed, const std::string& kind) {
    std::vector<Footprint> out;
    if (kind.empty()) return out;
    for (const Placed& p : placed)
        if (p.piece.kind == kind || p.wish.kind == kind) out.push_back(footprint_of(p));
    for (const Opening& o : plan.openings) {
        if (!is_opening_of(o, kind)) continue;
        const WallFace face = plan.wall(o.wall);
        out.push_back({flat(face.point((o.u0 + o.u1) / 2, 0)),
                       {(o.u1 - o.u0) / 2, 0.01f},
                       std::atan2(face.inward.x, face.inward.z),
                       o.y0,
                       o.y1});
    }
    return out;
}

// Backs at walls, every few centimetres along them.
void add_at_walls(const Plan& plan, Vec3f size, std::vector<Candidate>& out) {
    constexpr float kStep = 0.06f, kOffWall = 0.01f;  // metres
    for (const WallFace& face : plan.faces()) {
        const Vec2f inward = flat(face.inward);
        for (float u = size.x / 2; u <= face.length - size.x / 2; u += kStep)
            out.push_back({flat(face.point(u, 0)) + inward * (size.z / 2 + kOffWall), std::atan2(inward.x, inward.y)});
    }
}

// Everywhere on the floor, square to the room; what is as deep as wide needs but one yaw.
void add_on_floor(const Plan& plan, Vec3f size, std::optional<float> own, std::vector<Candidate>& out) {
    constexpr float kStep = 0.12f;  // metres
    const bool square = std::abs(size.x - size.z) < 0.1f * size.x;
    const float far_x = std::floor(plan.width / 2 / kStep) * kStep, far_z = std::floor(plan.depth / 2 / kStep) * kStep;
    for (float x = -far_x; x <= far_x + 1e-3f; x += kStep)
        for (float z = -far_z; z <= far_z + 1e-3f; z += kStep) {
            if (own) out.push_back({{x, z}, *own});
            // Its back to the nearer wall, its front to the room.
            const bool side = plan.width / 2 - std::abs(x) < plan.depth / 2 - std::abs(z);
            const float along_x = x > 0 ? -kPi / 2 : kPi / 2, along_z = z > 0 ? kPi : 0.f;
            out.push_back({{x, z}, side ? along_x : along_z});
            if (!square) out.push_back({{x, z}, side ? along_z : along_x});
        }
}

bool looks_at(const std::string& relation) {
    return relation == "facing" || relation == "opposite" || relation == "in front of";
}

}  // namespace

// For one thing that stands on the floor; the nearest place first.
bool Editor::search_finely(Layout& layout, const EditStep& step) const {
    const PromptObject& wish = layout.spec().objects[0];
    static constexpr std::array<std::string_view, 11> kBySearch{"next to",  "in front of",   "behind",       "left of",
                                                                "right of", "between",       "opposite",     "facing",
                                                                "against",  "in the corner", "in the middle"};
    const bool known = std::find(kBySearch.begin(), kBySearch.end(), wish.relation) != kBySearch.end();
    if (!known || wish.count > 1 || step.elsewhere || !layout.why_not(wish.kind).empty()) return false;
    const PieceRequest request = layout.request(wish.kind, &wish);
    const Piece piece = make_piece(request);
    if (piece.mount != Mount::floor) return false;
    // A chair before a table is drawn up to it, or it is not at the table.
    if (wish.relation == "in front of" && has_role(wish.kind, Role::work_seat)) return false;
    const bool flat_one = piece.size_m.y < kFlat;
    std::vector<Candidate> all;
    if (piece.against_wall) add_at_walls(plan(), piece.size_m, all);
    else add_on_floor(plan(), piece.size_m, flat_one ? step.yaw : std::nullopt, all);
    const std::vector<Footprint> anchors = anchors_of(plan(), layout.placed(), wish.relation_to);
    Placed p;
    p.piece = piece;
    p.flat = flat_one;
    std::erase_if(all, [&](Candidate& c) {
        float nearest = 1e9f;
        Vec2f middle{};
        for (const Footprint& a : anchors)
            if (const float far = distance_to(a, c.at); far < nearest) nearest = far, middle = a.center;
        if (!anchors.empty()) {
            if (looks_at(wish.relation)) c.yaw = std::atan2(middle.x - c.at.x, middle.y - c.at.y);
            c.cost = nearest;
        } else if (wish.relation == "in the middle") c.cost = length(c.at);
        else if (step.position) c.cost = length(c.at - *step.position);
        if (looks_at(wish.relation) && piece.against_wall)
            for (const WallFace& face : plan().faces())
                if (dot(flat(face.inward), middle - c.at) > 0.7f * length(middle - c.at))
                    c.yaw = std::atan2(face.inward.x, face.inward.z);
        p.position = {c.at.x, 0, c.at.y}, p.yaw = c.yaw;
        return !stands_as_asked(plan(), layout.placed(), p, wish).value_or(false) || !plan().holds(footprint_of(p));
    });
    std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    if (flat_one)
        return std::any_of(all.begin(), all.end(), [&](const Candidate& c) {
            const std::size_t mark = layout.mark();
            if (!layout.lay(c.at, c.yaw, request, wish)) return false;
            // It may have been pushed off a wall.
            if (stands_as_asked(plan(), layout.placed(), layout.placed().back(), wish).value_or(false)) return true;
            layout.undo(mark);
            return false;
        });
    const std::set<std::string> before = texts_of(room_faults(plan(), layout.placed(), room_.furnished.camera));
    int checks = 0;
    for (const bool with_clearance : {true, false})
        for (const Candidate& c : all) {
            const std::size_t mark = layout.mark();
            if (!layout.stand_at(piece, c.at, c.yaw, wish, {}, with_clearance)) continue;
            const auto now = texts_of(room_faults(plan(), layout.placed(), room_.furnished.camera));
            if (std::includes(before.begin(), before.end(), now.begin(), now.end())) return true;
            layout.undo(mark);
            if (++checks == kMostChecks) return false;
        }
    return false;
}

// Whether a thing with this box would reach into nothing that it does not reach into now; a first look, before all
// is checked.
bool Editor::stands_clear(int index, const Footprint& box, const std::vector<int>& along) const {
    constexpr float kTouch = 0.01f;  // metres
    if (!plan().holds(shrunk(box, kTouch))) return false;
    std::vector<int> moving{index};
    moving.insert(moving.end(), along.begin(), along.end());
    const std::vector<int> all = with_riders(moving);
    const Footprint now = footprint_of(placed(index));
    for (int i = 0; i < static_cast<int>(room_.furnished.placed.size()); ++i) {
        if (placed(i).flat || std::find(all.begin(), all.end(), i) != all.end() || i == placed(index).on) continue;
        const Footprint other = footprint_of(placed(i));
        if (overlap(shrunk(box, kTouch), shrunk(other, kTouch)) && !overlap(shrunk(now, kTouch), shrunk(other, kTouch)))
            return false;
    }
    return true;
}

}  // namespace fastscene::editing
