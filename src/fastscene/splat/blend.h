// Front-to-back alpha blending of one splat onto one pixel (or 16 pixels at once, F = Lanes).
#pragma once

#include "fastscene/splat/project.h"

namespace fastscene::splat {

// Forces inlining of what the inner loops call: the compiler's heuristic gives up when there are many calls, and with
// AVX2 each call spills registers.

// Once the transmittance is below this, further splats do not change an 8-bit picture; blending of a block of pixels
// stops. A smaller threshold (1e-4) gives the same PSNR and takes an eighth more time.
inline constexpr float kOpaque = 1.f / 255;
// The outside is visible in a pixel if at least this transmittance remains before its first splat.
inline constexpr float kOutsideVisible = 0.5f;

template <class F>
struct PixelState {
    F transmittance{};
    Vec3<F> color;
};

// alpha at (dx, dy) from the splat's center, before clamping at kMaxAlpha.
template <class F>
[[gnu::always_inline]] inline F raw_alpha(const Footprint<F>& s, F dx, F dy) {
    return exp2_fast(dx * (s.a * dx + s.b * dy) + (s.c * dy * dy + s.log2_opacity));
}
template <class F>
[[gnu::always_inline]] inline F shown_alpha(F raw) {
    return cut(raw, F(kMinAlpha), F(kMaxAlpha));
}
// log2 of an opacity that stays below kMaxAlpha even with rounding: such splats need no clamp.
inline constexpr float kLog2NeverHeld = -0.0145f;
static_assert(kLog2NeverHeld < -0.01449957f);  // log2(kMaxAlpha)

// `raw` is the splat's raw_alpha() at this pixel. Returns the blending weight of its color.
template <class F>
[[gnu::always_inline]] inline F blend(PixelState<F>& pixel, const Footprint<F>& s, F raw) {
    const F weight = shown_alpha(raw) * pixel.transmittance;
    pixel.transmittance = pixel.transmittance - weight;
    pixel.color += s.color * weight;
    return weight;
}

}  // namespace fastscene::splat
