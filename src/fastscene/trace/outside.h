// What stands before the sky outside the windows: a garden, a street, a shore, mountains, a wood. It is so far away
// that it depends on the direction alone.
#pragma once

#include "fastscene/scene/room.h"

namespace fastscene {

// Radiance from a direction (world frame, unit; y is down) in which the bare sky has the radiance `sky_color`.
Vec3f outside_radiance(const Sky& sky, Vec3f direction, Vec3f sky_color);

}  // namespace fastscene
