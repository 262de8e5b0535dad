// Leaves and pots of plants.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A leaf's green, a little other each time.
Material foliage(Kit& k, Vec3f tone, float scale);

// A leaf from `base` in direction `out` (unit, horizontal), rising by `lift`, bending down by `droop`.
Mesh blade(Vec3f base, Vec3f out, float length, float width, float lift, float droop, float point);

float flower_pot(Kit& k, int mat, float r, float h);

}  // namespace fastscene::furniture
