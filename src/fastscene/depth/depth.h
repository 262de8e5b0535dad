// Depth stage: equirectangular color -> range along each ray, in metres. Paper: panoramic depth.
// Backends: "exact" (the room behind a panorama from a prompt is asked) and "image" (a range map of the
// user's, panorama/panorama.h). A network that estimates it has its own issue.
#pragma once

#include "fastscene/base/run.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// Range as seen from the world's origin (panorama 0); +inf where the ray leaves the room. Needs no gathered light.
ImageF exact_range(const TracedRoom& room, EquirectSize size, const Run& run);

}  // namespace fastscene
