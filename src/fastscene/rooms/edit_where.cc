// Whether a thing is where its wish says, as people mean it.
#include <algorithm>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {
namespace {

// Chairs around a table are drawn up to it.
bool is_drawn_up(const std::vector<Placed>& all, const Placed& piece, const std::string& kind) {
    constexpr float kReach = 0.45f;  // metres from a table's edge to a chair's front
    return std::any_of(all.begin(), all.end(), [&](const Placed& p) {
        constexpr float kTurnedTo = 0.6f;  // cosine: to the side at which it stands, or to the middle
        const Vec2f at = footprint_of(piece).center, front = flat(front_of(piece.yaw));
        const Vec2f to = footprint_of(p).center - at;
        const Vec2f ahead = at + front * (kReach + piece.piece.size_m.z / 2);
        return &p != &piece && (p.piece.kind == kind || p.wish.kind == kind) &&
               distance_to(footprint_of(p), at) < kReach + piece.piece.size_m.z / 2 &&
               (dot(front, to) > kTurnedTo * length(to) || distance_to(footprint_of(p), ahead) < 0.01f);
    });
}

}  // namespace

bool is_below(const Footprint& box, const Footprint& window) {
    constexpr float kAtWall = 0.35f, kShare = 0.5f;  // metres; of what is narrower
    const auto axes = axes_of(window);
    const Vec2f to = box.center - window.center;
    const float off = dot(to, axes[1]) - extent(box, axes[1]), wide = extent(box, axes[0]);
    const float along = std::min(dot(to, axes[0]) + wide, window.half.x) -
                        std::max(dot(to, axes[0]) - wide, -window.half.x);
    return off < kAtWall && along > kShare * 2 * std::min(wide, window.half.x);
}

bool is_below_its_window(const Plan& plan, const std::vector<Placed>& all, const Placed& piece,
                         const PromptObject& wish) {
    if (wish.relation != "under" || noun_of(wish.relation_to).empty() || piece.piece.mount != Mount::floor) return true;
    const std::vector<Footprint> windows = anchors_of(plan, all, wish.relation_to);
    const Footprint box = footprint_of(piece);
    return std::any_of(windows.begin(), windows.end(), [&](const Footprint& window) { return is_below(box, window); });
}

bool is_before_its_opening(const Plan& plan, const std::vector<Placed>& all, const Placed& piece,
                           const PromptObject& wish) {
    if (wish.relation != "in front of" || noun_of(wish.relation_to).empty() || piece.piece.mount != Mount::floor)
        return true;
    constexpr float kShare = 0.5f;  // of what is narrower
    const Footprint box = footprint_of(piece);
    const std::vector<Footprint> openings = anchors_of(plan, all, wish.relation_to);
    return std::any_of(openings.begin(), openings.end(), [&](const Footprint& o) {
        const auto axes = axes_of(o);
        const float at = dot(box.center - o.center, axes[0]), wide = extent(box, axes[0]);
        return std::min(at + wide, o.half.x) - std::max(at - wide, -o.half.x) > kShare * 2 * std::min(wide, o.half.x);
    });
}

bool is_where_asked(const Plan& plan, const std::vector<Placed>& all, const Placed& piece, const PromptObject& wish) {
    if (wish.relation == "around" && has_role(piece.piece.kind, Role::seat) &&
        !is_drawn_up(all, piece, wish.relation_to))
        return false;
    // A chair in front of a desk is drawn up to it.
    if (!is_drawn_up_before(all, wish, piece)) return false;
    // A desk by a window stands at its wall, not in the room before it.
    if (wish.relation == "next to" && wish.relation_to == "window" && piece.piece.mount == Mount::floor &&
        !piece.flat && !has_role(piece.piece.kind, Role::seat) && !has_role(piece.piece.kind, Role::bed) &&
        (piece.piece.against_wall || has_role(piece.piece.kind, Role::work_place))) {
        constexpr float kAtWall_m = 0.45f;
        const Footprint box = footprint_of(piece);
        const auto windows = anchors_of(plan, all, wish.relation_to);
        if (std::none_of(windows.begin(), windows.end(), [&](const Footprint& window) {
                const Vec2f in = axes_of(window)[1];
                return dot(box.center - window.center, in) - extent(box, in) < kAtWall_m;
            }))
            return false;
    }
    if (!is_beside(all, piece, wish) || is_at_foot(all, wish, piece) || is_before_seat(all, wish, piece)) return false;
    if (is_off_wall_of_door(plan, wish, piece) || is_before_front(all, wish, piece)) return false;
    // Between two chairs is not at the side of both.
    if (wish.relation == "between" && piece.piece.mount == Mount::floor && !piece.flat && !piece.piece.against_wall)
        if (const float off = off_middle(all, wish, footprint_of(piece).center, &piece);
            std::isfinite(off) && off > kOffMiddle_m)
            return false;
    // A cabinet stands on no counter.
    constexpr float kLow = 0.7f;  // metres
    if (piece.on >= 0 && piece.piece.made_mount == Mount::floor && piece.piece.size_m.y > kLow) return false;
    // A lamp behind a chair stands on no dresser across the room.
    constexpr float kBy = 0.8f;  // metres from edge to edge
    if (piece.on >= 0 && is_one_of(wish.relation, {"next to", "behind", "in front of", "left of", "right of"}) &&
        noun_of(wish.relation_to).empty()) {
        float least = 1e9f;
        for (const Footprint& a : anchors_of(plan, all, wish.relation_to))
            least = std::min(least, distance_to(a, footprint_of(piece).center));
        if (least > kBy && least < 1e8f) return false;
    }
    // Nothing stands "around a table" on top of a bookshelf.
    constexpr float kHigh = 1.4f;  // metres
    if (piece.on >= 0 && piece.position.y > kHigh &&
        is_one_of(wish.relation, {"next to", "around", "in front of", "between"}))
        return false;
    // A rug under a chair reaches below its middle.
    if (piece.flat && wish.relation == "under" && noun_of(wish.relation_to).empty()) {
        const Footprint rug = footprint_of(piece);
        const auto anchors = anchors_of(plan, all, wish.relation_to);
        const bool below = std::any_of(anchors.begin(), anchors.end(), [&](const Footprint& a) {
            const bool smaller = std::max(a.half.x, a.half.y) < std::max(rug.half.x, rug.half.y);
            return smaller ? distance_to(rug, a.center) < 0.01f : gap_between(rug, a) < 0.05f;
        });
        if (!below) return false;
    }
    if (!is_below_its_window(plan, all, piece, wish) || !is_before_its_opening(plan, all, piece, wish)) return false;
    return stands_as_asked(plan, all, piece, wish).value_or(wish.relation.empty());
}

bool is_at_an_end(const std::vector<Placed>& all, const PromptObject& wish, Vec2f at) {
    return std::any_of(all.begin(), all.end(), [&](const Placed& table) {
        if (table.piece.kind != wish.relation_to && table.wish.kind != wish.relation_to) return false;
        const bool wide = table.piece.size_m.x >= table.piece.size_m.z;
        const Vec3f along = wide ? right_of(table.yaw) : front_of(table.yaw),
                    across = wide ? front_of(table.yaw) : right_of(table.yaw);
        const Vec2f d = at - flat(table.position);
        const float half_long = std::max(table.piece.size_m.x, table.piece.size_m.z) / 2,
                    half_short = std::min(table.piece.size_m.x, table.piece.size_m.z) / 2;
        constexpr float kBeyond_m = 0.55f, kOfHalf = 0.6f;
        const float beyond = std::abs(dot(d, flat(along))) - half_long;
        return beyond > 0 && beyond < kBeyond_m && std::abs(dot(d, flat(across))) < kOfHalf * half_short;
    });
}

}  // namespace fastscene::editing
