// Training parameters that are not exposed to users, in one place for experiments.
#pragma once

#include "fastscene/splat/splat.h"

namespace fastscene::splat {

struct TrainTuning {
    // Adam's initial learning rates; each decays exponentially to `end` times its start.
    float scale = 1.2e-2f, rotation = 3e-3f, sh0 = 1e-2f;
    float mean_end = 0.05f, other_end = 0.2f;
    // Share of the splats relocated each time. 0: only dead ones move. Starting from dense surface points there is
    // nothing to densify: relocating 3 % cost 0.1 dB at held-out poses.
    float relocate_fraction = 0.f;
    int relocate_every = 100;     // steps; at least one epoch
    float relocate_until = 0.7f;  // share of the run
    float growth = 0.05f;         // share of the current count added each time, until there are `count`
    float noise = 0.f;            // position noise in step sizes (mcmc): starting from dense points it only blurs
    float rest = 1e-2f / 4;  // SH degrees >= 1; the published value, a twentieth of sh0's, suits runs ten times as long
    int rest_every = 2;      // update SH degrees >= 1 every this many steps: they dominate memory traffic
};

FittedSplats fit(const ViewSet& views, const SplatParams& params, const TrainTuning& tuning, const Run& run,
                 const StepListener& on_step = {}, const Splats* begin = nullptr);

}  // namespace fastscene::splat
