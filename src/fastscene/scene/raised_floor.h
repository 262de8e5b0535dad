// The parts of a room's floor that are raised: objects of their own, boxes whose tops one walks on.
#pragma once

#include <algorithm>
#include <cmath>

#include "fastscene/scene/room.h"

namespace fastscene {

inline constexpr const char *kTier = "tier", *kTierStep = "tier_step";  // RoomObject::kind
inline constexpr float kStepNose_m = 0.012f;  // how far what one treads on juts out over the riser below
inline bool is_raised_floor(const RoomObject& object) { return object.kind == kTier || object.kind == kTierStep; }
inline bool has_raised_floor(const Room& room) {
    return std::any_of(room.objects.begin(), room.objects.end(), is_raised_floor);
}

// The floor at a point (x, z) of the room: the highest that there is, world y.
inline float floor_at(const Room& room, Vec2f point) {
    float floor = room.max_corner.y;
    for (const RoomObject& object : room.objects) {
        if (!is_raised_floor(object)) continue;
        const Vec3f p = inverse(object.world_from_object) * Vec3f{point.x, 0, point.y};
        if (std::fabs(p.x) <= object.size_m.x / 2 + kStepNose_m && std::fabs(p.z) <= object.size_m.z / 2 + kStepNose_m)
            floor = std::min(floor, (object.world_from_object * Vec3f{0, object.size_m.y, 0}).y);
    }
    return floor;
}

}  // namespace fastscene
