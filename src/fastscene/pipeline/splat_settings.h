// Resolves the trainer's "automatic" settings by the scene's source.
#pragma once

#include "fastscene/depth/depth.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/splat/splat.h"
#include "fastscene/walk/walk.h"

namespace fastscene {

// View-dependent color pays off for rendered views of a known room; warped and inpainted views do not contain
// reflections.
SplatParams splat_of(const SceneSource& source, const DepthParams& depth, const WalkParams& walk, SplatParams params);

}  // namespace fastscene
