// Points: surface samples from range maps, which initialize the splats.
#pragma once

#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/outside.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/view.h"

namespace fastscene {

// `count` samples: half uniform over the visible surface, half at picture edges. From the given panoramas (whose pixels
// are all observed), and from what walked ones invented. The outside comes from `outside`, in all directions where it
// is visible; if that is null or empty, from the panoramas' own views of it, continued behind frames and walls.
std::vector<SurfacePoint> sample_points(const std::vector<Panorama>& panoramas, int count, const Run& run,
                                        const Outside* outside = nullptr);
// `count` points on a sphere behind everything, so that no pixel stays transparent where surfaces leave a gap. Colored
// by `outside` in and near the directions where it is visible, elsewhere by what panorama 0 sees.
std::vector<SurfacePoint> backdrop_points(const std::vector<Panorama>& panoramas, int count,
                                          const Outside* outside = nullptr);

}  // namespace fastscene
