// What is seen through a window, and what shines in.
#pragma once

#include "fastscene/scene/room.h"

namespace fastscene {

// Radiance from a direction (world frame, unit; y is down): the sky's gradient and clouds, hills and houses on the horizon,
// the ground. The sun's disc is not in it: it is sampled by itself.
Vec3f sky_radiance(const Sky& sky, Vec3f direction);

}  // namespace fastscene
