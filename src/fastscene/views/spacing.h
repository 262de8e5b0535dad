// Point spacing: the initial size of the splat at each point.
#pragma once

#include <vector>

#include "fastscene/math/vec.h"

namespace fastscene {

// Root mean square distance of each point to its three nearest neighbours (Kerbl et al. 2023), or to fewer if there are
// fewer; 0 for a single point.
std::vector<float> spacings(const std::vector<Vec3f>& points);

}  // namespace fastscene
