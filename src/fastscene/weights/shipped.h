// Weights built into the program (models/ in the source tree), available wherever it runs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fastscene/weights/weights.h"

namespace fastscene {

// File names without extension: "egformer-rooms".
std::vector<std::string> shipped_names();
bool is_shipped(std::string_view name);
// Throws Error listing the available names.
Weights shipped_weights(std::string_view name);

}  // namespace fastscene
