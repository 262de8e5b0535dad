// Density control with a fixed number of splats (after Kheradmand et al. 2024, "3D Gaussian Splatting as
// Markov Chain Monte Carlo"): splats that show nothing move onto ones that have much error to explain.
#pragma once

#include <cstdint>

#include "fastscene/splat/engine.h"

namespace fastscene::splat {

// Opacity and scale factor of each of `copies` splats that lie in one place and together should look like one
// splat of this opacity (equation 9 there).
struct SharedLook {
    float opacity, scale;
};
SharedLook shared_look(float opacity, int copies);

// Moves the dead and clears the statistics. Returns how many moved.
std::int64_t relocate(Cloud& cloud, std::uint64_t seed, int step);

}  // namespace fastscene::splat
