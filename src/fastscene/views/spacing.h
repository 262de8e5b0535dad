// How far apart points lie: the size that a splat started from each of them should have.
#pragma once

#include <vector>

#include "fastscene/math/vec.h"

namespace fastscene {

// Root mean square distance of each point to its three nearest others (Kerbl et al. 2023); to fewer where there are
// fewer, 0 for a point alone.
std::vector<float> spacings(const std::vector<Vec3f>& points);

}  // namespace fastscene
