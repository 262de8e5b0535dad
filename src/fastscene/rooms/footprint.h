// Footprints: upright boxes turned about the vertical axis, in the room frame of plan.h.
#pragma once

#include <array>

#include "fastscene/math/vec.h"

namespace fastscene {

struct Footprint {
    Vec2f center, half;  // x, z
    float yaw = 0, y0 = 0, y1 = 0;
};

inline Vec2f flat(Vec3f v) { return {v.x, v.z}; }
// What a thing turned by `yaw` has at its front (+z) and at its right (+x).
Vec3f front_of(float yaw);
Vec3f right_of(float yaw);
float yaw_of(Vec3f front);

// Whether the boxes share a volume (separating axes). Touching is none.
bool overlap(const Footprint& a, const Footprint& b);
// Distance on the floor from a point to the box; 0 inside.
float distance_to(const Footprint& box, Vec2f point);
// The same for many points, with axes_of(box).
float distance_to(const Footprint& box, const std::array<Vec2f, 2>& axes, Vec2f point);
// Half the extent of a box along a unit axis on the floor.
float extent(const Footprint& box, Vec2f axis);
std::array<Vec2f, 2> axes_of(const Footprint& box);
std::array<Vec2f, 4> corners_of(const Footprint& box);
// The box made smaller by this much on every side.
Footprint shrunk(Footprint box, float by);
// Whether the segment from a to b passes through the box.
bool passes(const Footprint& box, Vec3f a, Vec3f b);

}  // namespace fastscene
