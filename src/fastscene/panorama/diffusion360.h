// Panorama backend "diffusion360": the paper's text-to-panorama, painted by networks whose weights the user brings.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/panorama/panorama.h"

namespace fastscene {

// Everything that can be known before anything is computed: components, names and shapes of all tensors, memory. Throws Error or UsageError.
void check_diffusion360(const PaintingSource& source, const PanoramaParams& params, const Run& run);
// Names of the files, their sizes and beginnings: other weights, another run.
std::string diffusion360_identity(const std::filesystem::path& weights);

}  // namespace fastscene
