// Weights that nobody named but `models pull` has brought: with them the flags that name weights may be left out.
#pragma once

#include "fastscene/pipeline/request.h"

namespace fastscene {

// Fills in what is empty where the settings, up to the request's last stage, ask for a network: Diffusion360's folder
// when the panorama is painted or made larger, EGformer's file where depth has to be estimated, AOT-GAN's where it
// paints holes; a note says which. Throws UsageError, with the command that helps, when a painter was asked for by name
// and its weights are neither named nor in the cache.
void use_cached_weights(SceneRequest& request, const Run& run);

}  // namespace fastscene
