// The walk as published (the paper's PNVI driver) and the two ablations of its last table.
#pragma once

#include "fastscene/walk/walk.h"

namespace fastscene {

// params.kind: "paper", "paper-direct" or "paper-far". Emits panorama 0 first (the official program drops it), then one
// panorama per step, direction by direction. Returns the record for stage.json.
Json walk_as_published(const Panorama& first, const WalkParams& params, const Run& run, const TakePanorama& take,
                       const RangeEstimator& estimate);

}  // namespace fastscene
