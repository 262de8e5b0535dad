// Points: surface samples from range maps, which initialize the splats.
#pragma once

#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/outside.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/view.h"
#include "fastscene/views/views.h"

namespace fastscene {

// Samples of the surfaces and of the outside, half uniform, half at picture edges: `params.points` over the visible
// surface, from the given panoramas (whose pixels are all observed), and from what walked ones invented; and
// `params.outside_density` per square degree of the outside. The outside comes from `outside`, in all directions where
// it is visible; if that is null or empty, from the panoramas' own views of it, continued behind frames and walls.
std::vector<SurfacePoint> sample_points(const std::vector<Panorama>& panoramas, const ViewsParams& params,
                                        const Run& run, const Outside* outside = nullptr);
// `count` points on a sphere behind everything, so that no pixel stays transparent where surfaces leave a gap. Colored
// by `outside` in and near the directions where it is visible, elsewhere by what panorama 0 sees.
std::vector<SurfacePoint> backdrop_points(const std::vector<Panorama>& panoramas, int count,
                                          const Outside* outside = nullptr);

}  // namespace fastscene
