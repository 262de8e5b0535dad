// Free space: how far a viewpoint may move, as far as panorama 0 can tell.
#pragma once

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"

namespace fastscene {

// The least range within `cone_cosine` of the unit direction (about 26 degrees: a step needs room to its sides too).
float free_distance(const ImageF& range, Vec3f direction, float cone_cosine = 0.9f);
// The same straight ahead (6 degrees): what a step would run into.
inline float distance_ahead(const ImageF& range, Vec3f direction) { return free_distance(range, direction, 0.9945f); }
// The share of that distance that may be gone: nobody looks from within a wall.
inline constexpr float kMostOfTheWay = 0.9f;

}  // namespace fastscene
