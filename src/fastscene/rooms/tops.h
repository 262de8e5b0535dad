// Flat tops of pieces that were built without one for other things to stand on: a bench, a trunk, a toy box. Furnishing
// leaves them free; an edit may set something down there.
#pragma once

#include <optional>

#include "fastscene/rooms/furniture.h"

namespace fastscene {

// The largest level rectangle that nothing of the piece stands above; nothing: it has none worth the name.
std::optional<Surface> flat_top(const Piece& piece);
// Gives a piece without tops that one.
void add_flat_top(Piece& piece);

}  // namespace fastscene
