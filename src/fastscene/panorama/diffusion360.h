// Panorama backend "diffusion360": the paper's text-to-panorama, painted by networks whose weights the user brings.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/panorama/panorama.h"

namespace fastscene {

// Everything that can be known before anything is computed: components, names and shapes of all tensors, memory. Throws
// Error or UsageError.
void check_diffusion360(const PaintingSource& source, const PanoramaParams& params, const Run& run);
// The same for a picture of this width that is made larger.
void check_enlarging(const PaintingSource& source, const PanoramaParams& params, int width, const Run& run);
// Of the files that painting opens, or that making the picture larger opens besides (`to` as params.diffusion.upscale):
// names and contents (base/content_identity.h). Other weights are another run; whatever else lies in the folder counts
// for nothing. Throws Error when one is missing.
std::string diffusion360_identity(const std::filesystem::path& weights, bool from_photo);
std::string enlarger_identity(const std::filesystem::path& weights, const std::string& to);

}  // namespace fastscene
