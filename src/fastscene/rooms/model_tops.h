// Where things can stand on a model whose builder is unknown: its flat tops, found from its triangles.
#pragma once

#include <vector>

#include "fastscene/rooms/furniture.h"

namespace fastscene {

// Level tops of a piece that stands on the floor, in its frame, the largest first: rectangles of its height map that
// are flat within a centimetre and have nothing above them. At most two, each of at least 0.2 m x 0.15 m, between 0.25
// and 1.4 m above the floor.
std::vector<Surface> tops_of(const Piece& piece);

}  // namespace fastscene
