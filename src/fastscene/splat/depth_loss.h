// The optional regularizer of depth: the depth a pixel shows is held to that of a target.
#pragma once

#include <cmath>

namespace fastscene::splat {

// Of one pixel, with sum = sum_i w_i z_i over its splats and T what they let through. The target lies behind them, so
// that only where light is stopped counts, not how much of it:
//   loss = |sum + T depth - depth| / depth = |sum_i w_i (z_i - depth)| / depth.
// A target of 0 or less is unknown.
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
