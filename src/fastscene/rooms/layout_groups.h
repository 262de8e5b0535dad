// Groups of pieces that recipes lay by name: a bed with what stands by it, a sofa and what it faces, …
#pragma once

#include <span>

#include "fastscene/rooms/layout_recipe.h"

namespace fastscene::furnishing {

std::span<const StepKind> group_kinds();

}  // namespace fastscene::furnishing
