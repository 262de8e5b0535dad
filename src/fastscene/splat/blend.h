// Front-to-back blending of one splat onto one pixel (or 16 pixels at once, F = Lanes).
#pragma once

#include "fastscene/splat/project.h"

namespace fastscene::splat {

// Inlined by order what the inner loops call: the compiler gives up on it when there are many of them, and a call costs
// AVX2 its registers.

// Below this transmittance nothing behind changes an 8-bit picture; blending of a block of pixels stops. A tenth of it
// gives the same PSNR for an eighth more time.
inline constexpr float kOpaque = 1.f / 255;
// The outside shows in a pixel where at least this transmittance is left before its first splat.
inline constexpr float kOutsideShows = 0.5f;

template <class F>
struct PixelState {
    F transmittance{};
    Vec3<F> color;
};

// alpha at (dx, dy) from the splat's center, before the clamp at kMaxAlpha.
template <class F>
[[gnu::always_inline]] inline F raw_alpha(const Footprint<F>& s, F dx, F dy) {
    return exp2_fast(dx * (s.a * dx + s.b * dy) + (s.c * dy * dy + s.log2_opacity));
}
template <class F>
[[gnu::always_inline]] inline F shown_alpha(F raw) {
    return cut(raw, F(kMinAlpha), F(kMaxAlpha));
}
// Splats no more opaque than this never reach kMaxAlpha, whatever rounding does.
inline constexpr float kLog2NeverHeld = -0.0145f;
static_assert(kLog2NeverHeld < -0.01449957f);  // log2(kMaxAlpha)

// `raw` is the splat's raw_alpha() here. Returns the weight with which its color entered.
template <class F>
[[gnu::always_inline]] inline F blend(PixelState<F>& pixel, const Footprint<F>& s, F raw) {
    const F weight = shown_alpha(raw) * pixel.transmittance;
    pixel.transmittance = pixel.transmittance - weight;
    pixel.color += s.color * weight;
    return weight;
}

}  // namespace fastscene::splat
