// Weights that the program carries inside (models/ in the sources): they are there wherever the program runs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fastscene/nn/weights.h"

namespace fastscene {

// By the file's name without ending: "egformer-rooms".
std::vector<std::string> shipped_names();
bool is_shipped(std::string_view name);
// Throws Error naming what there is.
Weights shipped_weights(std::string_view name);

}  // namespace fastscene
