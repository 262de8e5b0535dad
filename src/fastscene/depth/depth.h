// Depth stage: equirectangular color -> range along each ray, in metres. Paper: panoramic depth.
// Backends: "exact" (the room behind a panorama from a prompt is asked) and "image" (a range map of the
// user's, panorama/panorama.h). A network that estimates it has its own issue.
#pragma once

#include <string_view>

#include "fastscene/base/run.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// Range as seen from the world's origin (panorama 0); +inf where the ray leaves the room. Needs no gathered light.
ImageF exact_range(const TracedRoom& room, EquirectSize size, const Run& run);

// The panorama with a range map from elsewhere. Sizes must be equal. 0 is "unknown" and is filled smoothly from its
// surroundings; +inf is sky. Throws Error naming `source` for NaN, negative values or nothing known at all.
Panorama with_range(Panorama panorama, ImageF range, std::string_view source = "range map");

}  // namespace fastscene
