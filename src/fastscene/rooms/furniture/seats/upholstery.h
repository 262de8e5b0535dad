// Padded bodies along a curve.
#pragma once

#include <functional>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Where a padded body's middle runs, and how wide (along `across`) and thick (across both) it is there.
struct Padding {
    std::function<Vec3f(float)> path;  // t in [0, 1]
    Vec3f across;
    std::function<Vec2f(float)> section;  // metres: width, thickness
    float round_m = 0.05f, wrinkle_m = 0.002f;
    int steps = 28;
    std::uint32_t seed = 0;
};

float eased(float from, float to, float x);

// A body of upholstery along a curve, with rounded edges and ends.
Mesh padded_body(const Padding& how);

// A curve through points, by its share.
std::function<Vec3f(float)> curve_through(std::vector<Vec2f> points, std::function<Vec3f(Vec2f)> place);

void bolster(Kit& k, int mat, Vec3f from, float far, float r);

}  // namespace fastscene::furniture
