// The walk as published (the paper's PNVI driver) and the two ablations of its last table.
#pragma once

#include "fastscene/walk/walk.h"

namespace fastscene {

// params.kind: "paper", "paper-direct" or "paper-far". Panorama 0 comes first (the official program drops it); then one
// panorama a step, direction by direction. Returns what the record should say.
Json walk_as_published(const Panorama& first, const WalkParams& params, const Run& run, const TakePanorama& take,
                       const RangeEstimator& estimate);

}  // namespace fastscene
