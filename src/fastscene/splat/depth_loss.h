// Optional depth regularizer: pulls each pixel's rendered depth towards a target depth.
#pragma once

#include <cmath>

namespace fastscene::splat {

// For one pixel, with sum = sum_i w_i z_i over its splats and T the remaining transmittance. The target is placed
// behind them as a background, so that opacity is neither rewarded nor penalized: loss = |sum + T depth - depth| /
// depth = |sum_i w_i (z_i - depth)| / depth. Targets <= 0 are unknown.
template <class F>
struct DepthLoss {
    F total{};  // sum + T depth
    F loss{};
    F v{};  // dL/d(total)
};
template <class F>
DepthLoss<F> depth_loss(F sum, F transmittance, F depth) {
    if (!(depth > F(0))) return {sum, F(0), F(0)};
    const F total = sum + transmittance * depth, inv = F(1) / depth, relative = total * inv - F(1);
    return {total, std::abs(relative), relative > F(0) ? inv : -inv};
}

}  // namespace fastscene::splat
