// Points: surface samples from range maps, from which the splats start.
#pragma once

#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/view.h"

namespace fastscene {

// `count` samples: half of them spread evenly over the surface that is seen, half where the picture has edges.
// From panorama 0's pixels, and from what the later ones invented.
std::vector<SurfacePoint> sample_points(const std::vector<Panorama>& panoramas, int count, const Run& run);

}  // namespace fastscene
