// Where to look first: the direction of the preview and of the viewer's first glance.
#pragma once

#include <vector>

#include "fastscene/pipeline/run_folder.h"
#include "fastscene/scene/panorama.h"

namespace fastscene {

// Wide enough for half a room, narrow enough to keep its corners straight.
inline constexpr float kPreviewFovDeg = 105.f;
// Furniture stands below eye height.
inline constexpr float kPreviewPitchDeg = -14.f;

// World directions (any length) from panorama 0 to the middles of what the prompt asked for, as room.json has them.
std::vector<Vec3f> requested_directions(const RunFolder& folder);

// The yaw in degrees, of 24 all around, with the most to see: what was asked for, detail, and depth. `first` has range.
float best_yaw_deg(const Panorama& first, const std::vector<Vec3f>& requested);

}  // namespace fastscene
