// The trainer's settings with "automatic" resolved by what the scene is made from.
#pragma once

#include "fastscene/depth/depth.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/splat/splat.h"
#include "fastscene/walk/walk.h"

namespace fastscene {

// Reflections are worth harmonics where views of a known room show them as they are; what was warped or painted knows
// nothing of them.
SplatParams splat_of(const SceneSource& source, const DepthParams& depth, const WalkParams& walk, SplatParams params);

}  // namespace fastscene
