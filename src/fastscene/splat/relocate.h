// Density control with a fixed number of splats, in the spirit of Kheradmand et al. 2024 ("3D Gaussian Splatting as
// Markov Chain Monte Carlo"): splats that contribute almost nothing move to where the error is largest. No opacity
// resets and no limits on screen-space or world size: both assume cameras around the scene, and ours stand in its
// middle.
#pragma once

#include <cstdint>

#include "fastscene/splat/engine.h"

namespace fastscene::splat {

struct Relocation {
    // share of all splats to move besides the dead ones: those with the least blending weight
    double useless_fraction = 0.03;
};

// Moves dead and useless splats, each onto a splat sampled by its error, which is split in two along its longest axis;
// clears the statistics. Returns the number moved.
std::int64_t relocate(Cloud& cloud, const Relocation& how, std::uint64_t seed, int step);

// Adds up to `wanted` splats (within the capacity), each the second half of a splat sampled by its error. Call it
// before relocate(), which clears the statistics.
std::int64_t grow(Cloud& cloud, std::int64_t wanted, std::uint64_t seed, int step);

// Adds noise to positions, stronger for faint splats (Kheradmand et al., equation 9): `size_m` is its standard
// deviation relative to the splat's shape.
void add_noise(Cloud& cloud, float size_m, std::uint64_t seed, int step);

// Splits splat `from`, its second half stored at `to`; both get zeroed moments.
void split(Cloud& cloud, std::int64_t from, std::int64_t to);

}  // namespace fastscene::splat
