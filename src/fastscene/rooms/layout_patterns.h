// Patterns in which several types of rooms are furnished: rows with aisles, tables on a grid, a counter with the
// server's side free, runs along walls, a piece at the end of the axis, lamps on a grid.
#pragma once

#include <span>

#include "fastscene/rooms/layout_recipe.h"

namespace fastscene::furnishing {

std::span<const StepKind> pattern_kinds();

}  // namespace fastscene::furnishing
