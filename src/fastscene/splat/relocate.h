// Density control with a fixed number of splats, in the spirit of Kheradmand et al. 2024 ("3D Gaussian
// Splatting as Markov Chain Monte Carlo"): splats that show next to nothing move to where there is most
// error to explain. No opacity reset and no limit on size on screen or in the world: both take for granted
// that the cameras stand around the scene, and ours stand in its middle.
#pragma once

#include <cstdint>

#include "fastscene/splat/engine.h"

namespace fastscene::splat {

struct Relocation {
    double useless_fraction = 0.03;  // of all splats: the ones with the least blending weight
};

// Moves the dead and the useless, each onto a splat drawn by its error, which becomes two along its
// longest axis; clears the statistics. Returns how many moved.
std::int64_t relocate(Cloud& cloud, const Relocation& how, std::uint64_t seed, int step);

// Up to `wanted` new splats (as far as there is memory), each the second half of a splat drawn by its error. Call it
// before relocate(), which clears the statistics.
std::int64_t grow(Cloud& cloud, std::int64_t wanted, std::uint64_t seed, int step);

// Pushes positions about, most where splats are faint (Kheradmand et al., equation 9): `size_m` standard deviations of
// a splat times its shape.
void add_noise(Cloud& cloud, float size_m, std::uint64_t seed, int step);

// Splat `to` becomes the second half of splat `from`; both start with fresh moments.
void split(Cloud& cloud, std::int64_t from, std::int64_t to);

}  // namespace fastscene::splat
