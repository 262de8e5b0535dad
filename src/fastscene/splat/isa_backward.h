// Backward pass of one tile: splat after splat, front to back again. A vector is a 4x4 block of pixels. The
// contributions of a splat's blocks are accumulated per lane in registers and reduced over the lanes once, after its
// last block.
#pragma once

#include "fastscene/splat/blend_grad.h"
#include "fastscene/splat/isa_raster.h"

namespace fastscene::splat::FASTSCENE_ISA {

// The state of a block during the pass, and its pixels' incoming gradients.
struct alignas(512) BlockGrad {  // a power of two, so that addressing is a shift
    PixelGradState<Lanes> pixel;
    Lanes error;
    Lanes open;  // 1 where the outside is visible, else 0; set at the first splat of the outside
};

inline void start(BlockGrad& b, const Frame& f, std::ptrdiff_t at) {
    const auto block = [&](const float* plane) { return load_block(plane + at, f.stride); };
    const Vec3<Lanes> v{block(f.v[0]), block(f.v[1]), block(f.v[2])},
        color{block(f.color[0]), block(f.color[1]), block(f.color[2])};
    Lanes rest = dot(v, color);
    if (f.v_depth) {
        b.pixel.v_depth = block(f.v_depth);
        rest += b.pixel.v_depth * block(f.depth);
    }
    if (f.v_transmittance) rest += block(f.v_transmittance) * block(f.transmittance);
    b.pixel.transmittance = Lanes(1.f), b.pixel.v = v, b.pixel.rest = rest;
    if (f.error[0]) b.error = block(f.error[0]) + block(f.error[1]) + block(f.error[2]);
}

// A gradient slot before its lanes are summed: moments of g = dL/d(ln alpha) about the splat's center, color, weight,
// error, depth.
struct SlotSums {
    Summand all[kSlotFloats]{};

    void moments(Lanes g, const Vec2<Lanes>& d) {
#if FASTSCENE_WIDE
        const Lanes gx = g * d.x, gy = g * d.y;
        all[0] += g, all[1] += gx, all[2] += gy;
        all[3] += gx * d.x, all[4] += gx * d.y, all[5] += gy * d.y;
#else
        // Both halves have the same columns.
        const Half both = g.lo + g.hi, x = d.x.lo, gx = both * x, gy_lo = g.lo * d.y.lo, gy_hi = g.hi * d.y.hi,
                   gy = gy_lo + gy_hi;
        all[0] += both, all[1] += gx, all[2] += gy;
        all[3] += gx * x, all[4] += gy * x, all[5] += gy_lo * d.y.lo, all[5] += gy_hi * d.y.hi;
#endif
    }
    void add(int i, Lanes a, Lanes b) {
#if FASTSCENE_WIDE
        all[i] += a * b;
#else
        all[i] += a.lo * b.lo, all[i] += a.hi * b.hi;
#endif
    }
    void add(int i, Lanes a) {
#if FASTSCENE_WIDE
        all[i] += a;
#else
        all[i] += a.lo + a.hi;
#endif
    }
};
// One block. kOutside: of a splat of the outside, which is trained only where it is visible.
template <bool kDepth, bool kJudge, bool kHeld, bool kOutside>
[[gnu::always_inline]] inline void blend_back(BlockGrad& b, const Footprint<Lanes>& splat, const Vec2<Lanes>& d,
                                              Lanes alpha, Lanes odds, SlotSums& sums) {
    BlendGrad<Lanes> grad = blend_grad<kDepth, kHeld>(b.pixel, splat, alpha, odds);
    const Lanes shown = grad.weight;  // density control counts it wherever the splat is visible
    if constexpr (kOutside) grad.g = grad.g * b.open, grad.weight = grad.weight * b.open;
    sums.moments(grad.g, d);
    sums.add(6, grad.weight, b.pixel.v.x), sums.add(7, grad.weight, b.pixel.v.y), sums.add(8, grad.weight, b.pixel.v.z);
    if constexpr (kJudge) sums.add(9, shown), sums.add(10, shown, b.error);
    if constexpr (kDepth) sums.add(11, grad.weight, b.pixel.v_depth);
}

// All blocks that a splat touches, at least one.
template <bool kDepth, bool kJudge, bool kHeld, bool kOutside>
[[gnu::always_inline]] inline Lanes tile_gradient(const Record& s, std::uint32_t touched, float tile_x, float tile_y,
                                                  const BlockPixels& grid, BlockGrad* blocks) {
    const Footprint<Lanes> splat = spread(s);
    const Lanes from_x = grid.x + Lanes(tile_x - s.x), from_y = grid.y + Lanes(tile_y - s.y);
    alignas(64) static constexpr float kCornerX[16] = {0, 4, 8, 12, 0, 4, 8, 12, 0, 4, 8, 12, 0, 4, 8, 12};
    alignas(64) static constexpr float kCornerY[16] = {0, 0, 0, 0, 4, 4, 4, 4, 8, 8, 8, 8, 12, 12, 12, 12};
    const auto offset = [&](std::size_t block) {
        return Vec2<Lanes>{from_x + Lanes(kCornerX[block]), from_y + Lanes(kCornerY[block])};
    };
    const TileAlpha alphas(s, tile_x, tile_y);
    SlotSums sums;
    // First all alphas, then the gradient, which has a serial dependency: the processor reorders only a few hundred
    // instructions, and going block by block would leave half of its units idle.
    alignas(64) float shown[16][2 * kLanes];
    int count = 0;
    for (std::uint32_t bits = touched; bits; bits &= bits - 1, ++count) {
        const auto block = static_cast<std::size_t>(__builtin_ctz(bits));
        const Lanes raw = alphas.raw(block, splat, offset(block)),
                    alpha = kHeld ? shown_alpha(raw) : above(raw, Lanes(kMinAlpha));
        alpha.store(shown[count]), odds_of(alpha).store(shown[count] + kLanes);
    }
    count = 0;
    for (std::uint32_t bits = touched; bits; bits &= bits - 1, ++count) {
        const auto block = static_cast<std::size_t>(__builtin_ctz(bits));
        blend_back<kDepth, kJudge, kHeld, kOutside>(blocks[block], splat, offset(block), Lanes::load(shown[count]),
                                                    Lanes::load(shown[count] + kLanes), sums);
    }
    return sums12(sums.all);
}

template <bool kDepth, bool kJudge>
inline void backward_tile(const Frame& f, int tile) {
    const FlushDenormals flush;
    const int column = tile % f.tiles_x, row = tile / f.tiles_x;
    const BlockPixels grid = block_pixels();
    BlockGrad blocks[16];
    for (int block = 0; block < 16; ++block)
        start(blocks[block], f, (row * kTile + block / 4 * 4) * f.stride + column * kTile + block % 4 * 4);
    if (const int next = tile + 1; next < f.tiles_x * f.tiles_y) {
        const std::ptrdiff_t corner = next / f.tiles_x * kTile * f.stride + next % f.tiles_x * kTile;
        for (int c = 0; c < 3; ++c) {
            fetch_tile<0>(f.color[c] + corner, f.stride);
            fetch_tile<0>(f.v[c] + corner, f.stride);
            if constexpr (kJudge) fetch_tile<0>(f.error[c] + corner, f.stride);
        }
    }
    // Prefetches records, then the slots they refer to: they are stored in splat order, not in this order.
    constexpr std::uint32_t kRecordAhead = 8, kSlotAhead = 2;
    const std::uint32_t end = f.tile_begin[tile + 1];
    const auto slot_of = [&](std::uint32_t record) {
        const Record& s = f.records[record];
        const std::size_t slot = f.piece_slot[record >> f.piece_shift] + s.first_slot +
                                 static_cast<std::size_t>(row - s.tile_y) * s.tiles_wide +
                                 static_cast<std::size_t>(column - s.tile_x);
        return f.slots + slot * kSlotFloats;
    };
    bool outside = false;
    for (std::uint32_t i = f.tile_begin[tile]; i < end; ++i) {
        __builtin_prefetch(&f.records[f.list[i + kRecordAhead < end ? i + kRecordAhead : i]]);
        __builtin_prefetch(slot_of(f.list[i + kSlotAhead < end ? i + kSlotAhead : i]), 1);
        const std::uint32_t record = f.list[i];
        const Record& s = f.records[record];
        Lanes sums;
        if (!outside && s.depth_z > f.outside_m) {
            outside = true;
            for (BlockGrad& b : blocks)
                b.open = select(b.pixel.transmittance > Lanes(kOutsideVisible), Lanes(1.f), Lanes(0.f));
        }
        const auto gradient = [&]<bool kHeld, bool kOutside>() __attribute__((always_inline)) {
            return tile_gradient<kDepth, kJudge, kHeld, kOutside>(s, f.masks[i], static_cast<float>(column * kTile),
                                                                  static_cast<float>(row * kTile), grid, blocks);
        };
        if (f.masks[i]) {
            if (outside) sums = gradient.template operator()<true, true>();
            else if (FASTSCENE_WIDE || s.log2_opacity > kLog2NeverHeld)
                sums = gradient.template operator()<true, false>();
            else sums = gradient.template operator()<false, false>();
        }
        store12(sums, slot_of(record));
    }
}

inline void backward_any(const Frame& f, int tile) {
    const bool judge = f.error[0];
    if (f.v_depth) judge ? backward_tile<true, true>(f, tile) : backward_tile<true, false>(f, tile);
    else judge ? backward_tile<false, true>(f, tile) : backward_tile<false, false>(f, tile);
}

}  // namespace fastscene::splat::FASTSCENE_ISA
