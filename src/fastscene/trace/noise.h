// Lattice noise for C++ callers (kernel/noise.h).
#pragma once

#include "fastscene/trace/kernel/noise.h"

namespace fastscene {

using kernel::lattice_hash, kernel::lattice_unit, kernel::mix, kernel::unit_clamp, kernel::smooth_step,
    kernel::floor_int, kernel::noise2, kernel::noise3, kernel::detail_fade, kernel::fbm2, kernel::fbm3,
    kernel::line_cover, kernel::edge_cover, kernel::Voronoi, kernel::voronoi2;

}  // namespace fastscene
