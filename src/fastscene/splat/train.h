// The knobs of training that no user needs, in one place so that experiments can turn them.
#pragma once

#include "fastscene/splat/splat.h"

namespace fastscene::splat {

struct TrainTuning {
    // Adam step sizes at the start; each falls exponentially to `end` times its start.
    float scale = 1.2e-2f, rotation = 3e-3f, sh0 = 1e-2f;
    float mean_end = 0.05f, other_end = 0.2f;
    // Of the splats, each time. 0: only the dead move. Started from dense surface points there is nothing
    // to densify: moving 3 % of the splats cost 0.1 dB at held-out poses.
    float relocate_fraction = 0.f;
    int relocate_every = 100;     // steps; at least one round of the views
    float relocate_until = 0.7f;  // of the run
    float growth = 0.05f;         // of the splats there are, each time, until there are `count`
    float noise = 0.f;            // of the positions, in step sizes (mcmc): with dense starting points it only blurs
    float rest = 1e-2f / 4;       // the higher bands; a twentieth of sh0's, as published, is for runs ten times as long
    int rest_every = 2;           // steps between two of the higher bands: they are most of the memory traffic
};

FittedSplats fit(const ViewSet& views, const SplatParams& params, const TrainTuning& tuning, const Run& run);

}  // namespace fastscene::splat
