// Initial points for captures without any, by plane sweeping: positions on whose color the views agree.
#pragma once

#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/view.h"

namespace fastscene {

// At most `count` points in the views' world, metres. Rays through random pixels are searched between the two distances
// for a position where other views show the same patch (plane sweep: Collins, CVPR 1996). A ray without a distinct best
// distance, as on a uniform wall, copies that of the nearest confident one of similar color in its view, or gives no
// point. Empty if the views hardly agree anywhere: all from one position, or of nothing. Deterministic in run.seed.
std::vector<SurfacePoint> swept_points(const ViewSet& set, int count, float nearest_m, float farthest_m,
                                       const Run& run);

}  // namespace fastscene
