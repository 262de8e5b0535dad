// Chooses the direction of the preview and of the viewer's initial view.
#pragma once

#include <vector>

#include "fastscene/pipeline/run_folder.h"
#include "fastscene/scene/panorama.h"

namespace fastscene {

// Wide enough for half a room, narrow enough to limit distortion in the corners.
inline constexpr float kPreviewFovDeg = 105.f;
// Most furniture is below eye height.
inline constexpr float kPreviewPitchDeg = -14.f;

// World directions (any length) from panorama 0 to the centers of the objects that the prompt asked for, from
// room.json.
std::vector<Vec3f> requested_directions(const RunFolder& folder);

// The best yaw in degrees, of 24: requested objects, detail and depth count. `first` has range.
float best_yaw_deg(const Panorama& first, const std::vector<Vec3f>& requested);

}  // namespace fastscene
