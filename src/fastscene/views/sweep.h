// Where a capture has no points to start from: places on whose color its views agree.
#pragma once

#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/view.h"

namespace fastscene {

// At most `count` points in the views' world, metres. Rays through pixels drawn by lot are followed between the two
// distances; something stands where the other views show what this one does (plane sweep: Collins, CVPR 1996). A ray
// that no distance explains better than others, as on an even wall, takes that of the nearest sure one of its color in
// its picture; without one it gives no point. Empty where views are hardly sure of anything: those of one place,
// pictures of nothing. Deterministic in run.seed.
std::vector<SurfacePoint> swept_points(const ViewSet& set, int count, float nearest_m, float farthest_m,
                                       const Run& run);

}  // namespace fastscene
