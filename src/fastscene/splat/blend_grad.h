// The gradient of blend(), walking front to back once more. Behind splat i lies
//   rest_i = sum_{j > i} w_j (v . c_j) + T_end (v . background),   v = dL/d(pixel color),
// (a loss of T_end itself, dL/d T_end, adds to v . background), and dL/d alpha_i = T_i (v . c_i) - rest_i / (1 -
// alpha_i). Starting from v . (final color), rest needs only one subtraction a splat, so nothing has to be stored by
// the forward pass.
#pragma once

#include "fastscene/splat/blend.h"

namespace fastscene::splat {

//
// With kDepth the depth sum, sum_i w_i z_i, is a fourth color: v_depth = dL/d(depth sum).
template <class F>
struct PixelGradState {
    F transmittance{}, rest{};
    Vec3<F> v;
    F v_depth{};
};
template <class F>
struct BlendGrad {
    F g;       // dL/d(ln alpha)
    F weight;  // blending weight; dL/d(splat color) = weight * v
};

// The expensive part of blend_grad() that depends on alpha only.
template <class F>
[[gnu::always_inline]] inline F odds_of(F alpha) {
    return quotient(alpha, F(1) - alpha);
}

// The gradient of one splat with the blended `alpha`, whose odds_of() are `odds`. kHeld: alpha may have been clamped at
// kMaxAlpha.
template <bool kDepth = false, bool kHeld = true, class F>
[[gnu::always_inline]] inline BlendGrad<F> blend_grad(PixelGradState<F>& pixel, const Footprint<F>& s, F alpha,
                                                      F odds) {
    const F weight = alpha * pixel.transmittance;
    F vc = dot(pixel.v, s.color);
    if constexpr (kDepth) vc = vc + pixel.v_depth * s.depth_z;
    pixel.rest = pixel.rest - weight * vc;
    const F slope = weight * vc - pixel.rest * odds;
    pixel.transmittance = pixel.transmittance - weight;
    if constexpr (kHeld)  // a clamped alpha has no gradient
        return {select(alpha < F(kMaxAlpha), slope, F(0)), weight};
    else return {slope, weight};
}

}  // namespace fastscene::splat
