#include "fastscene/rooms/layout_relations.h"

#include <algorithm>
#include <cmath>

namespace fastscene {
namespace {

// What a relation refers to: a piece, or an opening of the wall as a thin box that faces the room.
struct Place {
    Footprint box;
    Vec2f front;     // unit, into the room
    int index = -1;  // of the piece; -1: an opening
    int opening = -1;
};

Vec2f heading_of(float yaw) { return {std::sin(yaw), std::cos(yaw)}; }
// To the right of someone who looks at a thing with this front (x, y up and z towards him are right-handed).
Vec2f right_of_viewer(Vec2f front) { return {front.y, -front.x}; }

std::vector<Place> places_of(const Plan& plan, const std::vector<Placed>& placed, const std::string& kind,
                             const Placed& piece) {
    std::vector<Place> out;
    for (std::size_t i = 0; i < placed.size(); ++i)
        if (&placed[i] != &piece && (placed[i].wish.kind == kind || placed[i].piece.kind == kind))
            out.push_back({footprint_of(placed[i]), heading_of(placed[i].yaw), static_cast<int>(i), -1});
    if (kind == "skylight")
        for (const Skylight& k : plan.skylights) {
            const Vec2f inward = flat(plan.wall(k.wall).inward);
            const Vec2f at = Vec2f{k.wall == 1 ? plan.width / 2 : -plan.width / 2, (k.z0 + k.z1) / 2} +
                             inward * (plan.slope_run / 2);
            out.push_back(
                {{at, {(k.z1 - k.z0) / 2, plan.slope_run / 2}, std::atan2(inward.x, inward.y), plan.knee, plan.height},
                 inward,
                 -1,
                 -1});
        }
    for (const Block& b : plan.blocks)
        if (kind == "column" && b.kind == Block::Kind::column)
            out.push_back({{(b.low + b.high) * 0.5f, (b.high - b.low) * 0.5f, 0, 0, plan.height}, {0, -1}, -1, -1});
    for (const Opening& o : plan.openings) {
        if (!is_opening_of(o, kind)) continue;
        const WallFace face = plan.wall(o.wall);
        const Vec3f middle = face.point((o.u0 + o.u1) / 2, 0);
        out.push_back({{flat(middle), {(o.u1 - o.u0) / 2, 0.01f}, std::atan2(face.inward.x, face.inward.z), o.y0, o.y1},
                       flat(face.inward),
                       -1,
                       static_cast<int>(&o - plan.openings.data())});
    }
    return out;
}

float to_wall(const Plan& plan, const Footprint& box) {
    const float reach = std::min(box.half.x, box.half.y);
    return std::min(plan.width / 2 - std::abs(box.center.x), plan.depth / 2 - std::abs(box.center.y)) - reach;
}

// Which corner it stands in; -1: none.
int corner_of(const Plan& plan, const Footprint& box) {
    constexpr float kNear = 0.55f;
    if (plan.width / 2 - std::abs(box.center.x) - extent(box, {1, 0}) >= kNear ||
        plan.depth / 2 - std::abs(box.center.y) - extent(box, {0, 1}) >= kNear)
        return -1;
    return (box.center.x > 0 ? 1 : 0) + (box.center.y > 0 ? 2 : 0);
}

// How many of the same wish stand there already: several share corners and sides evenly.
template <class There>
int others_there(const std::vector<Placed>& placed, const Placed& piece, const PromptObject& wish, const There& there) {
    return static_cast<int>(std::count_if(placed.begin(), placed.end(), [&](const Placed& p) {
        return &p != &piece && p.wish.id == wish.id && there(footprint_of(p));
    }));
}

// The relation to one place.
bool holds(const std::string& relation, const Footprint& box, Vec2f front, const Placed& piece, const Place& at) {
    const Vec2f from = box.center - at.box.center;
    const float ahead = dot(from, at.front), aside = dot(from, right_of_viewer(at.front)),
                far = gap_between(box, at.box);
    const bool opening = at.index < 0;
    if (relation == "on" && piece.sill >= 0) return piece.sill == at.opening;
    if (relation == "on" && !opening && piece.on == at.index) return true;
    if (relation == "on") {
        // What is smaller than a rug lies with its middle on it; of a sofa the front legs do.
        const bool smaller = std::max(box.half.x, box.half.y) < std::min(at.box.half.x, at.box.half.y);
        return at.box.y1 < 0.08f && (smaller ? distance_to(at.box, box.center) < 0.01f : far < 0.05f);
    }
    if (relation == "under")
        return opening ? std::abs(aside) < at.box.half.x + 0.2f && ahead < 1.2f : far < 0.05f && box.y1 <= at.box.y1;
    if (relation == "above") return std::abs(aside) < at.box.half.x + 0.1f && box.y0 >= at.box.y1 - 0.02f && far < 0.3f;
    if (relation == "in front of") return ahead > at.box.half.y && std::abs(aside) < at.box.half.x + 0.3f && far < 1.5f;
    if (relation == "behind") return ahead < -at.box.half.y && far < 1.5f;
    // What lies on a bed lies towards its foot; of one along the wall, at an end.
    if (relation == "at the foot of" && piece.on == at.index && at.index >= 0)
        return ahead > 0.2f * at.box.half.y || std::abs(aside) > 0.35f * at.box.half.x;
    if (relation == "at the foot of")
        return ahead > at.box.half.y && std::abs(aside) < 0.6f * at.box.half.x && far < 0.5f;
    // Beside a window beds stand with their heads at its wall.
    const float deep = opening ? extent(box, at.front) : 0.f;
    if (relation == "on both sides of")
        return std::abs(aside) > 0.8f * at.box.half.x && std::abs(ahead) < at.box.half.y + 0.5f + deep &&
               far < (opening ? 0.75f : 0.7f);
    if (relation == "facing")
        return dot(front, at.box.center - box.center) > 0.87f * length(at.box.center - box.center);
    if (relation == "opposite")
        return ahead > at.box.half.y + 0.4f && dot(front, at.front) < -0.7f &&
               std::abs(aside) < at.box.half.x + extent(box, right_of_viewer(at.front)) + 0.2f;
    // Its middle lies beyond that side: what stands across the room, a little to one side, is not beside it.
    if (relation == "left of") return aside < -at.box.half.x && far < 1.8f;
    if (relation == "right of") return aside > at.box.half.x && far < 1.8f;
    if (relation == "around") return far < 0.9f;
    return far < (opening ? 0.85f : 0.65f);  // next to
}

bool is_between(const Footprint& box, const Place& a, const Place& b) {
    const Vec2f along = b.box.center - a.box.center;
    const float l = length(along);
    if (!(l > 0.2f)) return false;
    const Vec2f d = box.center - a.box.center;
    const float t = dot(d, along) / (l * l), off = std::abs(d.x * along.y - d.y * along.x) / l;
    return t > 0.12f && t < 0.88f && off < 0.9f;
}

}  // namespace

float gap_between(const Footprint& a, const Footprint& b) {
    float least = 1e9f;
    for (const auto& [one, other] : {std::pair{&a, &b}, {&b, &a}}) {
        const Vec2f front = heading_of(one->yaw), right{front.y, -front.x};
        for (const float i : {-1.f, 0.f, 1.f})
            for (const float j : {-1.f, 0.f, 1.f})
                least = std::min(
                    least, distance_to(*other, one->center + right * (i * one->half.x) + front * (j * one->half.y)));
    }
    return least;
}

bool is_opening_of(const Opening& o, std::string_view kind) {
    if (o.kind == Opening::Kind::window) return kind == "window" || kind == "bay_window";
    return kind == (o.kind == Opening::Kind::door ? "door" : "doorway");
}

std::optional<bool> stands_as_asked(const Plan& plan, const std::vector<Placed>& placed, const Placed& piece,
                                    const PromptObject& wish) {
    if (wish.relation.empty() || wish.relation == "in the next room") return {};
    const Footprint box = footprint_of(piece);
    const Vec2f front = heading_of(piece.yaw);
    if (wish.relation == "in the corner") {
        const int corner = corner_of(plan, box);
        constexpr int kCorners = 4;
        return corner >= 0 && others_there(placed, piece, wish, [&](const Footprint& f) {
                                  return corner_of(plan, f) == corner;
                              }) <= (wish.count - 1) / kCorners;
    }
    if (wish.relation == "in the middle")
        return std::abs(box.center.x) < 0.22f * plan.width && std::abs(box.center.y) < 0.22f * plan.depth;
    if (wish.relation == "far wall") return box.center.y > plan.depth / 2 - box.half.y - box.half.x - 0.4f;
    if (wish.relation == "against" && (wish.relation_to.empty() || wish.relation_to == "wall"))
        return to_wall(plan, box) < 0.2f;
    if (wish.relation_to == "wall") return piece.piece.mount == Mount::wall || to_wall(plan, box) < 0.25f;
    if (wish.relation_to == "floor") return box.y0 < 0.05f;
    if (wish.relation_to == "ceiling") return piece.piece.mount == Mount::ceiling || wish.relation == "under";
    const std::vector<Place> places = places_of(plan, placed, wish.relation_to, piece);
    if (wish.relation == "between") {
        const std::vector<Place> others = places_of(plan, placed, wish.relation_and, piece);
        if (places.empty() || others.empty() || (wish.relation_and == wish.relation_to && places.size() < 2)) return {};
        for (const Place& a : places)
            for (const Place& b : others)
                if (is_between(box, a, b)) return true;
        return false;
    }
    if (places.empty()) return {};
    const auto at = std::find_if(places.begin(), places.end(),
                                 [&](const Place& place) { return holds(wish.relation, box, front, piece, place); });
    if (at == places.end() || wish.relation != "on both sides of") return at != places.end();
    // As many on this side as on the other.
    const auto right = [&](const Footprint& f) {
        return dot(f.center - at->box.center, right_of_viewer(at->front)) > 0;
    };
    const int on_this = others_there(placed, piece, wish, [&](const Footprint& f) {
        return gap_between(f, at->box) < 0.75f && right(f) == right(box);
    });
    const int sides = 2 * static_cast<int>(places.size());
    return on_this <= (wish.count - 1) / sides;
}

}  // namespace fastscene
