// Alpha of a splat at the pixels of a tile, 16 at a time (a 4x4 block).
#pragma once

#include "fastscene/splat/blend.h"
#include "fastscene/splat/kernel.h"
#include "fastscene/splat/lanes.h"

namespace fastscene::splat::FASTSCENE_ISA {

inline Footprint<Lanes> spread(const Record& r) {
    return {r.x, r.y, r.a, r.b, r.c, r.log2_opacity, {r.color[0], r.color[1], r.color[2]}, r.depth_z};
}

struct BlockPixels {
    Lanes x, y;  // pixel centers relative to the block's corner
};
inline BlockPixels block_pixels() {
    alignas(64) float x[kBlock], y[kBlock];
    for (int i = 0; i < kBlock; ++i) x[i] = static_cast<float>(i % 4) + 0.5f, y[i] = static_cast<float>(i / 4) + 0.5f;
    return {Lanes::load(x), Lanes::load(y)};
}

#if FASTSCENE_WIDE

// One exponential per pixel, for a single register per block.
struct TileAlpha {
    TileAlpha() = default;
    TileAlpha(const Record&, float, float) {}
    Lanes raw(std::size_t, const Footprint<Lanes>& splat, const Vec2<Lanes>& d) const {
        return raw_alpha(splat, d.x, d.y);
    }
};

#else

// Needs half as many exponentials. About the center m of a block, with (i, j) the pixel's offset from it, the exponent
// is e(m) + de/dx i + de/dy j + (a i^2 + b i j + c j^2), so alpha is a product of three factors: one per column, one
// per row, and one that is the same in all blocks of the splat. The eight columns and rows of a block fill one vector.
// Wherever alpha matters, all factors stay in the range of exp2_near(): a, b and c are bounded by the screen-space
// low-pass (at least kLeastLowPassPx2).
struct TileAlpha {
    Half curve_lo, curve_hi;                   // 2^(a i^2 + b i j + c j^2)
    float slope_x[16], slope_y[16], half[16];  // per block: de/dx, de/dy and e / 2 at its center

    TileAlpha() = default;
    [[gnu::always_inline]] TileAlpha(const Record& s, float tile_x, float tile_y) {
        constexpr Half ii = {2.25f, 0.25f, 0.25f, 2.25f, 2.25f, 0.25f, 0.25f, 2.25f},
                       ij = {2.25f, 0.75f, -0.75f, -2.25f, 0.75f, 0.25f, -0.25f, -0.75f};
        constexpr Half jj = {2.25f, 2.25f, 2.25f, 2.25f, 0.25f, 0.25f, 0.25f, 0.25f};
        curve_lo = exp2_near(s.a * ii + s.b * ij + s.c * jj);
        curve_hi = __builtin_shuffle(curve_lo, HalfBits{7, 6, 5, 4, 3, 2, 1, 0});  // mirrored at the center
        constexpr Half columns = {2, 6, 10, 14, 2, 6, 10, 14}, rows = {2, 2, 2, 2, 6, 6, 6, 6};
        const Half x = columns + eight(tile_x - s.x), two_a_x = (2 * s.a) * x, b_x = s.b * x;
        for (int i = 0; i < 2; ++i) {
            const Half y = rows + eight(tile_y + static_cast<float>(8 * i) - s.y), dx = two_a_x + s.b * y,
                       dy = b_x + (2 * s.c) * y;
            Half middle = (dx * x + dy * y) * 0.25f + eight(0.5f * s.log2_opacity);
            // Splats that extend far beyond the picture lose precision here, but must stay in range.
            constexpr float kFaintest = -60;
            middle = min(max(middle, eight(kFaintest)), eight(0));
            __builtin_memcpy(slope_x + 8 * i, &dx, sizeof dx);
            __builtin_memcpy(slope_y + 8 * i, &dy, sizeof dy);
            __builtin_memcpy(half + 8 * i, &middle, sizeof middle);
        }
    }
    [[gnu::always_inline]] Lanes raw(std::size_t block, const Footprint<Lanes>&, const Vec2<Lanes>&) const {
        // Rows 0 and 2, columns 0 and 1; rows 1 and 3, columns 2 and 3: the layout with the fewest shuffles.
        constexpr Half place = {-1.5f, 0.5f, -1.5f, -0.5f, -0.5f, 1.5f, 0.5f, 1.5f};
        const Half slope = alternate_pairs(eight(slope_y[block]), eight(slope_x[block]));
        const Half factor = exp2_near(slope * place + eight(half[block]));
        const Half column = __builtin_shuffle(factor, HalfBits{2, 3, 6, 7, 2, 3, 6, 7});
        const Half row_lo = __builtin_shuffle(factor, HalfBits{0, 0, 0, 0, 4, 4, 4, 4}),
                   row_hi = __builtin_shuffle(factor, HalfBits{1, 1, 1, 1, 5, 5, 5, 5});
        return {curve_lo * column * row_lo, curve_hi * column * row_hi};
    }
};

#endif

}  // namespace fastscene::splat::FASTSCENE_ISA
