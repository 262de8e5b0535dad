// The knobs of training that no user needs, in one place so that experiments can turn them.
#pragma once

#include "fastscene/splat/splat.h"

namespace fastscene::splat {

struct TrainTuning {
    // Adam step sizes at the start; each falls exponentially to `end` times its start.
    float scale = 8e-3f, rotation = 3e-3f, logit = 0.05f, sh0 = 1e-2f;
    float mean_end = 0.1f, other_end = 0.2f;
    bool relocate = true;
    int relocate_every = 100;
    float relocate_until = 0.7f;       // of the run
};

FittedSplats fit(const ViewSet& views, const SplatParams& params, const TrainTuning& tuning, const Run& run);

}  // namespace fastscene::splat
