// Free space: how far a viewpoint may move without hitting a surface seen by panorama 0.
#pragma once

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"

namespace fastscene {

// The minimum range within `cone_cosine` of the unit direction (about 26 degrees: a step needs space on its sides,
// too).
float free_distance(const ImageF& range, Vec3f direction, float cone_cosine = 0.9f);
// The same for a narrow cone straight ahead (6 degrees): what a step would collide with.
inline float distance_ahead(const ImageF& range, Vec3f direction) { return free_distance(range, direction, 0.9945f); }
// Maximum share of that distance to move, which keeps cameras out of walls.
inline constexpr float kMostOfTheWay = 0.9f;

}  // namespace fastscene
