// Real-ESRGAN's generator (Wang et al. 2018, 2021): super-resolution by a factor of 1, 2 or 4. Keys as in BasicSR.
// Private to nn/ (torch).
#pragma once

#include "fastscene/nn/scope.h"

namespace fastscene::nn {

struct RrdbConfig {
    std::int64_t features = 64, blocks = 23, growth = 32, scale = 4;
};
// x [N, 3, H, W] in [0, 1], sides divisible by 2 at scale 2 and by 4 at scale 1 -> [N, 3, scale H, scale W].
at::Tensor rrdbnet(const Scope& s, const RrdbConfig& config, const at::Tensor& x);

}  // namespace fastscene::nn
