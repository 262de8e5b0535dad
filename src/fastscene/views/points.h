// Points: surface samples from range maps, from which the splats start.
#pragma once

#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/outside.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/view.h"

namespace fastscene {

// `count` samples: half of them spread evenly over the surface that is seen, half where the picture has edges.
// From the pixels of panorama 0 and of others that were given (nothing in them is carried or invented), and from what
// walked ones invented.
// The outside: from `outside` in every direction in which it can be seen; where that is null or empty, from what the
// panoramas saw of it, gone on behind frames and walls.
std::vector<SurfacePoint> sample_points(const std::vector<Panorama>& panoramas, int count, const Run& run,
                                        const Outside* outside = nullptr);
// `count` points of a sphere behind everything, so that nothing is left transparent: behind the outside, and wherever
// surfaces leave a gap. In each direction it has the color of `outside` where that is known, else the one that panorama 0
// sees there.
std::vector<SurfacePoint> backdrop_points(const std::vector<Panorama>& panoramas, int count,
                                          const Outside* outside = nullptr);

}  // namespace fastscene
