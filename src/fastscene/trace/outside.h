// The view outside the windows: a garden, a street, a coast, mountains, a forest. It is far enough away to depend on
// direction alone.
#pragma once

#include "fastscene/scene/room.h"

namespace fastscene {

// Radiance from a direction (world frame, unit, y down), given the radiance `sky_color` of the bare sky there.
Vec3f outside_radiance(const Sky& sky, Vec3f direction, Vec3f sky_color);

}  // namespace fastscene
