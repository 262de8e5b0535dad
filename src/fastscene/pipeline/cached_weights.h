// Uses weights fetched by `models pull` if no flag names any.
#pragma once

#include "fastscene/pipeline/request.h"

namespace fastscene {

// Fills in empty weight paths for the networks that the request's stages need: Diffusion360's folder for generating or
// upscaling the panorama, a depth network's file, AOT-GAN's for inpainting; a note reports each. Throws
// UsageError, with the command that helps, if a network was requested by name but its weights are neither given nor
// cached.
void use_cached_weights(SceneRequest& request, const Run& run);
// The same for estimating range alone. Without a file in the cache built-in weights may apply.
void use_cached_depth_weights(DepthParams& depth, const Run& run);

}  // namespace fastscene
