// Whether one comes to the front of things: a cabinet cannot be opened that faces the side of a shower.
#include <algorithm>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

// Most of what is before its front, at arm's length, is taken by something that stays there.
bool is_walled_up(const Plan& plan, const std::vector<Placed>& all, std::size_t count, std::size_t index) {
    const Placed& p = all[index];
    const bool opens = p.piece.mount == Mount::floor && !p.flat && p.on < 0 && p.piece.against_wall &&
                       p.piece.clearance_front_m > 0 && !has_role(p.piece.kind, Role::seat) &&
                       !has_role(p.piece.kind, Role::bed);
    if (!opens) return false;
    constexpr float kAhead_m = 0.2f, kLow_m = 0.2f;  // what is lower nobody stumbles over
    constexpr int kSamples = 9;
    int taken = 0;
    for (int k = 0; k < kSamples; ++k) {
        const float across = ((static_cast<float>(k) + 0.5f) / kSamples - 0.5f) * p.piece.size_m.x;
        const Vec2f at = flat(p.position + right_of(p.yaw) * across +
                              front_of(p.yaw) * (p.piece.size_m.z / 2 + kAhead_m));
        bool blocked = std::abs(at.x) > plan.width / 2 || std::abs(at.y) > plan.depth / 2;
        for (std::size_t i = 0; i < count && !blocked; ++i) {
            const Placed& other = all[i];
            blocked = i != index && other.piece.mount == Mount::floor && !other.flat && other.on < 0 &&
                      other.piece.size_m.y > kLow_m && !has_role(other.piece.kind, Role::seat) &&
                      distance_to(footprint_of(other), at) < 1e-3f;
        }
        taken += blocked ? 1 : 0;
    }
    return 2 * taken > kSamples;
}

// The legs of whoever sits there have no room.
bool has_no_leg_room(const std::vector<Placed>& all, std::size_t before, std::size_t index) {
    const Placed& seat = all[index];
    if (!has_role(seat.piece.kind, Role::seat) || seat.piece.mount != Mount::floor || seat.on >= 0) return false;
    constexpr float kLow_m = 0.2f, kBack_m = 0.05f, kCounter_m = 0.85f;  // one sits before no counter
    Placed near = seat;
    near.position = seat.position - front_of(seat.yaw) * kBack_m;
    const Footprint legs = shrunk(leg_room(near), 0.05f);
    for (std::size_t i = std::max(before, index + 1); i < all.size(); ++i) {
        const Placed& p = all[i];
        const bool sat_at = is_sat_at(p.piece.kind) && p.piece.size_m.y < kCounter_m;
        if (p.piece.mount == Mount::floor && !p.flat && p.on < 0 && p.piece.size_m.y > kLow_m && !sat_at &&
            !has_role(p.piece.kind, Role::seat) && overlap(footprint_of(p), legs))
            return true;
    }
    return false;
}

}  // namespace

bool blocks_fronts(const Plan& plan, const std::vector<Placed>& all, std::size_t before) {
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool was_walled_up = i < before && is_walled_up(plan, all, before, i);
        if (i < before && has_no_leg_room(all, before, i)) return true;
        if (!was_walled_up && is_walled_up(plan, all, all.size(), i)) return true;
    }
    return false;
}

std::vector<int> Editor::goes_before(int seat) const {
    std::vector<int> out;
    if (!has_role(placed(seat).piece.kind, Role::seat)) return out;
    for (int i = 0; i < static_cast<int>(room_.furnished.placed.size()); ++i) {
        const Placed& p = placed(i);
        if (p.with == seat && p.piece.mount == Mount::floor && p.on < 0 &&
            (p.flat || has_role(p.piece.kind, Role::centerpiece)))
            out.push_back(i);
    }
    return out;
}

}  // namespace fastscene::editing
