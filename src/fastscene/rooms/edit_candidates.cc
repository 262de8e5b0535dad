// Places on the floor that satisfy a wish: a fine grid, backs at walls, sides of what the place is named by.
#include <algorithm>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {

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

namespace {

// Backs at walls, every few centimetres along them.
void add_at_walls(const Plan& plan, Vec3f size, std::vector<Candidate>& out, float off_wall = 0.01f) {
    constexpr float kStep = 0.06f;  // metres
    for (const WallFace& face : plan.faces()) {
        const Vec2f inward = flat(face.inward);
        for (float u = size.x / 2; u <= face.length - size.x / 2; u += kStep)
            out.push_back({flat(face.point(u, 0)) + inward * (size.z / 2 + off_wall), std::atan2(inward.x, inward.y)});
    }
}

// Everywhere on the floor, square to the room. A square piece needs only one yaw.
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

// Beside a bed is at its head.
float off_head(Layout& layout, Vec2f at) {
    const PromptObject& wish = layout.spec().objects[0];
    float least = 1e9f;
    for (const Placed& bed : layout.placed())
        if (is_one_of(wish.relation, {"next to", "left of", "right of", "on both sides of"}) &&
            has_role(bed.piece.kind, Role::bed) &&
            (bed.piece.kind == wish.relation_to || bed.wish.kind == wish.relation_to))
            least = std::min(least, std::max(0.f, dot(at - flat(bed.position), flat(front_of(bed.yaw)))));
    return least < 1e8f ? 0.5f * least : 0.f;
}

// Beside a seat is at its arms, else behind it, else off its front.
float off_arms(Layout& layout, Vec2f at) {
    const PromptObject& wish = layout.spec().objects[0];
    if (wish.relation != "next to") return 0;
    constexpr float kBehind = 0.3f, kAhead = 0.6f;  // metres that it may be further off at an arm
    float least = 1e9f;
    for (const Placed& seat : layout.placed()) {
        if ((seat.piece.kind != wish.relation_to && seat.wish.kind != wish.relation_to) ||
            !has_role(seat.piece.kind, Role::seat))
            continue;
        const float ahead = dot(at - flat(seat.position), flat(front_of(seat.yaw)));
        const float half = seat.piece.size_m.z / 2;
        least = std::min(least, ahead > half ? kAhead : ahead < -half ? kBehind : 0.f);
    }
    return least < 1e8f ? least : 0.f;
}

bool looks_at(const std::string& relation) {
    return relation == "facing" || relation == "opposite" || relation == "in front of";
}

}  // namespace

bool is_rug(const Piece& piece) {
    constexpr float kFlat = 0.03f;  // metres: higher, nobody steps on it
    return piece.size_m.y < kFlat;
}

bool is_beside(const std::vector<Placed>& all, const Placed& piece, const PromptObject& wish) {
    const bool stands = piece.piece.mount == Mount::floor || piece.piece.mount == Mount::surface;
    const bool both = wish.relation == "on both sides of" && noun_of(wish.relation_to).empty();
    if ((!is_one_of(wish.relation, {"left of", "right of"}) && !both) || !stands) return true;
    constexpr float kOfHalf = 0.8f, kAhead = 0.5f;  // of its width; metres before or behind it
    constexpr float kMostBefore = 0.5f;             // of half its width
    bool known = false;
    const bool beside = std::any_of(all.begin(), all.end(), [&](const Placed& at) {
        if (&at == &piece || (at.piece.kind != wish.relation_to && at.wish.kind != wish.relation_to)) return false;
        known = true;
        const Vec3f to = piece.position - at.position, half = at.piece.size_m * 0.5f;
        const float aside = std::abs(dot(to, right_of(at.yaw))), ahead = dot(to, front_of(at.yaw));
        // With most of it before its front it is not beside that.
        const Footprint box = footprint_of(piece);
        const float wide = extent(box, flat(right_of(at.yaw)));
        const bool before = (at.piece.against_wall || at.on >= 0) && ahead > half.z &&
                            aside + kMostBefore * wide < half.x + wide;
        return aside > kOfHalf * half.x && std::abs(ahead) < half.z + kAhead && !before;
    });
    return beside || !known;  // windows have no such sides
}

Footprint leg_room(const Placed& seat) {
    constexpr float kLegs_m = 0.45f, kKnees_m = 1.f;
    constexpr float kArm = 0.06f;  // of its width: before an armrest nobody has legs
    const float half = seat.piece.size_m.x * (0.5f - kArm);
    const Vec3f at = seat.position + front_of(seat.yaw) * (seat.piece.size_m.z / 2 + kLegs_m / 2);
    return {flat(at), {half, kLegs_m / 2}, seat.yaw, seat.position.y, seat.position.y + kKnees_m};
}

bool is_before_seat(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p) {
    if (!is_one_of(wish.relation, {"next to", "left of", "right of", "on both sides of"})) return false;
    if (p.piece.mount != Mount::floor || p.flat || p.on >= 0) return false;
    // What one sits at, or lays the feet on, stands there.
    if (has_role(p.piece.kind, Role::centerpiece) || is_rug(p.piece)) return false;
    return std::any_of(all.begin(), all.end(), [&](const Placed& seat) {
        return &seat != &p && (seat.piece.kind == wish.relation_to || seat.wish.kind == wish.relation_to) &&
               has_role(seat.piece.kind, Role::seat) && overlap(footprint_of(p), leg_room(seat));
    });
}

bool is_ahead_of_seat(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p) {
    if (wish.relation != "next to" || p.piece.mount != Mount::floor || p.flat || p.on >= 0) return false;
    bool ahead = false;
    for (const Placed& seat : all) {
        if (&seat == &p || (seat.piece.kind != wish.relation_to && seat.wish.kind != wish.relation_to)) continue;
        if (!has_role(seat.piece.kind, Role::seat)) return false;
        const Vec2f front = flat(front_of(seat.yaw));
        const Footprint box = footprint_of(p);
        if (dot(box.center - flat(seat.position), front) - extent(box, front) < seat.piece.size_m.z / 2) return false;
        ahead = true;
    }
    return ahead;
}

bool is_at_foot(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p) {
    constexpr float kNarrow_m = 0.7f, kOfLength = 0.05f;
    if (!p.piece.against_wall || p.piece.size_m.x > kNarrow_m) return false;
    if (!is_one_of(wish.relation, {"next to", "left of", "right of", "on both sides of", "between"})) return false;
    return std::any_of(all.begin(), all.end(), [&](const Placed& bed) {
        return has_role(bed.piece.kind, Role::bed) && !has_role(bed.piece.kind, Role::along_wall) &&
               (bed.piece.kind == wish.relation_to || bed.wish.kind == wish.relation_to) &&
               dot(p.position - bed.position, front_of(bed.yaw)) > kOfLength * bed.piece.size_m.z;
    });
}

bool is_before_front(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p) {
    if (wish.relation != "next to" || p.piece.mount != Mount::floor || p.flat || p.on >= 0 || !p.piece.against_wall)
        return false;
    bool before = false;
    for (const Placed& at : all) {
        if (&at == &p || (at.piece.kind != wish.relation_to && at.wish.kind != wish.relation_to)) continue;
        if (!at.piece.against_wall || at.piece.mount != Mount::floor) return false;
        const Vec2f to = footprint_of(p).center - flat(at.position), front = flat(front_of(at.yaw));
        if (dot(to, front) < at.piece.size_m.z / 2 || std::abs(dot(to, flat(right_of(at.yaw)))) > at.piece.size_m.x / 2)
            return false;
        before = true;
    }
    return before;
}

bool is_off_wall_of_door(const Plan& plan, const PromptObject& wish, const Placed& p) {
    if (wish.relation != "next to" || p.piece.mount != Mount::floor || p.flat || p.on >= 0) return false;
    constexpr float kAtWall_m = 0.2f;
    const Footprint box = footprint_of(p);
    bool known = false;
    for (const Opening& o : plan.openings) {
        if (o.kind == Opening::Kind::window || !is_opening_of(o, wish.relation_to)) continue;
        const WallFace face = plan.wall(o.wall);
        known = true;
        if (dot(box.center - flat(face.origin), flat(face.inward)) - extent(box, flat(face.inward)) < kAtWall_m)
            return false;
    }
    return known;
}

namespace {

// Where a thing would stand that is pushed up to another: at each of its sides, along it.
void add_at_sides(const Footprint& anchor, Vec3f size, std::vector<Candidate>& out) {
    constexpr float kStep = 0.1f;  // metres
    const auto axes = axes_of(anchor);
    for (const float gap : {0.02f, 0.08f, 0.2f})
        for (const bool beside : {true, false})
            for (const float side : {1.f, -1.f}) {
                const Vec2f out_by = axes[beside ? 0 : 1] * side, along = axes[beside ? 1 : 0];
                const float reach = beside ? anchor.half.y : anchor.half.x;
                const float off = (beside ? anchor.half.x + size.x / 2 : anchor.half.y + size.z / 2) + gap;
                for (float t = -reach; t <= reach + 1e-3f; t += kStep) {
                    const Vec2f at = anchor.center + out_by * off + along * t;
                    out.push_back({at, anchor.yaw});
                    if (!beside && side > 0) out.push_back({at, std::remainder(anchor.yaw + kPi, 2 * kPi)});
                }
            }
}

// From edge to edge.
float off_box(const Footprint& anchor, const Footprint& box) {
    const Vec2f to = anchor.center - box.center;
    const Vec2f way = length(to) > 1e-3f ? to * (1 / length(to)) : Vec2f{0, 1};
    return std::max(0.f, distance_to(anchor, box.center) - extent(box, way));
}

// How far it is from the room's nearest corner, or from that one.
float off_corner(const Plan& plan, const Footprint& box, const std::optional<Vec2f>& corner) {
    float least = 1e9f;
    for (const float x : {plan.width / 2, -plan.width / 2})
        for (const float z : {plan.depth / 2, -plan.depth / 2}) {
            if (corner && length(Vec2f{x, z} - *corner) > 1.f) continue;
            least = std::min(least, std::max(std::abs(x - box.center.x) - extent(box, {1, 0}),
                                             std::abs(z - box.center.y) - extent(box, {0, 1})));
        }
    return std::max(0.f, least);
}

}  // namespace

std::vector<Placed> grown(std::vector<Placed> all, const PromptObject& wish, float by) {
    for (Placed& p : all)
        for (const std::string* kind : {&wish.relation_to, &wish.relation_and})
            if (!kind->empty() && (p.piece.kind == *kind || p.wish.kind == *kind)) {
                p.piece.size_m.x += 2 * by, p.piece.size_m.z += 2 * by;
                break;
            }
    return all;
}

namespace {

constexpr float kOfCorner = 1.6f;  // metres: further off it is in another one

// A chair around a table is turned to the side at which it stands; false: it stands beyond a corner.
bool faces_side(const std::vector<Footprint>& anchors, Candidate& c, Placed& p) {
    for (const Footprint& a : anchors) {
        const auto axes = axes_of(a);
        const Vec2f to = c.at - a.center;
        const float x = dot(to, axes[0]), z = dot(to, axes[1]);
        constexpr float kDrawnUp = 0.3f;  // metres from its edge; further off there is another row before it
        const float deep = p.piece.size_m.z / 2 + kDrawnUp;
        const bool beside = std::abs(x) > a.half.x && std::abs(x) < a.half.x + deep && std::abs(z) < a.half.y;
        const bool before = std::abs(z) > a.half.y && std::abs(z) < a.half.y + deep && std::abs(x) < a.half.x;
        if (!beside && !before) continue;
        const Vec2f in = beside ? axes[0] * std::copysign(1.f, -x) : axes[1] * std::copysign(1.f, -z);
        c.yaw = p.yaw = std::atan2(in.x, in.y);
        return true;
    }
    return false;
}

}  // namespace

// A chair in front of a desk is drawn up to it.
bool is_drawn_up_before(const std::vector<Placed>& all, const PromptObject& wish, const Placed& p) {
    constexpr float kReach_m = 0.35f, kOfHalf = 0.6f;
    if (wish.relation != "in front of" || !has_role(wish.kind, Role::work_seat)) return true;
    return std::none_of(all.begin(), all.end(), [&](const Placed& desk) {
        if ((desk.piece.kind != wish.relation_to && desk.wish.kind != wish.relation_to) ||
            !has_role(desk.piece.kind, Role::work_place))
            return false;
        const Vec3f to = p.position - desk.position;
        return std::abs(dot(to, right_of(desk.yaw))) > kOfHalf * desk.piece.size_m.x / 2 ||
               std::abs(dot(to, front_of(desk.yaw))) > desk.piece.size_m.z / 2 + p.piece.size_m.z / 2 + kReach_m;
    });
}

// The places on the floor that satisfy the wish, the best first; `further`: metres that it may be off.
std::vector<Candidate> Editor::candidates_for(Layout& layout, const EditStep& step, const Piece& piece,
                                              float further) const {
    const PromptObject& wish = layout.spec().objects[0];
    const bool flat_one = is_rug(piece);
    const bool of_corner = wish.relation == "in the corner" && step.position.has_value();
    std::vector<Candidate> all;
    const std::vector<Footprint> anchors = anchors_of(plan(), layout.placed(), wish.relation_to);
    const bool at_opening = !noun_of(wish.relation_to).empty() && wish.relation == "next to" && !flat_one;
    if (piece.against_wall || at_opening) add_at_walls(plan(), piece.size_m, all);
    // Before a radiator it is below the window still.
    if (wish.relation == "under" && !noun_of(wish.relation_to).empty())
        for (const float off : {0.14f, 0.22f, 0.3f}) add_at_walls(plan(), piece.size_m, all, off);
    if (!piece.against_wall) add_on_floor(plan(), piece.size_m, flat_one ? step.yaw : std::nullopt, all);
    if (!flat_one && noun_of(wish.relation_to).empty())
        for (const Footprint& a : anchors) add_at_sides(a, piece.size_m, all);
    const std::vector<Placed> near = further > 0 ? grown(layout.placed(), wish, further) : layout.placed();
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
            // What nobody sits in stands square to the room.
            if (looks_at(wish.relation) && !has_role(piece.kind, Role::seat))
                c.yaw = std::round(c.yaw / (kPi / 2)) * (kPi / 2);
            c.cost = wish.relation == "between" ? off_middle(layout.placed(), wish, c.at)
                                                : nearest + off_head(layout, c.at) + off_arms(layout, c.at);
        } else if (of_corner && length(c.at - *step.position) > kOfCorner + further) return true;
        else if (wish.relation == "in the middle") c.cost = length(c.at);
        else if (step.position) {
            constexpr float kThere = 2.2f;  // metres: further off it is not there
            c.cost = length(c.at - *step.position);
            if (wish.relation.empty() && c.cost > kThere + further) return true;
        }
        if (looks_at(wish.relation) && piece.against_wall)
            for (const WallFace& face : plan().faces())
                if (dot(flat(face.inward), middle - c.at) > 0.7f * length(middle - c.at))
                    c.yaw = std::atan2(face.inward.x, face.inward.z);
        p.position = {c.at.x, 0, c.at.y}, p.yaw = c.yaw;
        const Footprint box = footprint_of(p);
        if (!plan().holds(box) || is_at_foot(layout.placed(), wish, p)) return true;
        if (is_before_seat(layout.placed(), wish, p) || is_before_front(layout.placed(), wish, p)) return true;
        if (wish.relation == "between" && !piece.against_wall && std::isfinite(c.cost) &&
            c.cost > kOffMiddle_m + further)
            return true;
        if (further == 0 && is_off_wall_of_door(plan(), wish, p)) return true;
        if (wish.relation == "around" && has_role(wish.kind, Role::seat) && !faces_side(anchors, c, p)) return true;
        if (!is_beside(layout.placed(), p, wish) || !is_drawn_up_before(layout.placed(), wish, p)) return true;
        if (step.wall >= 0 && wall_behind(plan(), p) != step.wall) return true;
        if (!is_below_its_window(plan(), layout.placed(), p, wish)) return true;
        if (further == 0 && !is_before_its_opening(plan(), layout.placed(), p, wish)) return true;
        for (const Footprint& a : anchors) c.off = std::min(c.off, off_box(a, box));
        if (wish.relation == "in the corner")
            c.off = off_corner(plan(), box, step.position), c.cost += further > 0 ? c.off : 0.f;
        if (stands_as_asked(plan(), layout.placed(), p, wish).value_or(wish.relation.empty())) return false;
        if (!(further > 0)) return true;
        constexpr float kInCorner = 0.55f, kAtOpening = 0.85f;  // metres, as stands_as_asked() has them
        constexpr float kStillCorner = 0.25f;                   // of what it may be further off elsewhere
        if (wish.relation == "in the corner") return c.off > kInCorner + kStillCorner * further;
        if (wish.relation == "next to" && c.off < kAtOpening + further && !anchors.empty()) return false;
        return !stands_as_asked(plan(), near, p, wish).value_or(false);
    });
    std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    return all;
}

}  // namespace fastscene::editing
