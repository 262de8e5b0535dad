// The gradient of one tile, splat after splat, front to back once more. A vector is a 4x4 block of pixels; what a
// splat's blocks say is summed up in registers, lane by lane, and over the lanes once, when the splat's last block is done.
#pragma once

#include "fastscene/splat/blend_grad.h"
#include "fastscene/splat/isa_raster.h"

namespace fastscene::splat::FASTSCENE_ISA {

// A block on its way to the back, and what its pixels ask for.
struct BlockGrad {
    PixelGradState<Lanes> pixel;
    Lanes error;
};

inline BlockGrad first_state(const Frame& f, std::ptrdiff_t at) {
    const auto block = [&](const float* plane) { return load_block(plane + at, f.stride); };
    const auto blocks = [&](const auto& planes) { return Vec3<Lanes>{block(planes[0]), block(planes[1]), block(planes[2])}; };
    BlockGrad b;
    b.pixel.transmittance = Lanes(1.f);
    b.pixel.v = blocks(f.v);
    b.pixel.rest = dot(b.pixel.v, blocks(f.color));
    if (f.v_depth) {
        b.pixel.v_depth = block(f.v_depth);
        b.pixel.rest += b.pixel.v_depth * block(f.depth);
    }
    if (f.error[0]) b.error = block(f.error[0]) + block(f.error[1]) + block(f.error[2]);
    return b;
}

// A slot whose pixels are not yet added up: moments of g = dL/d(ln alpha) about the splat's center, color, weight, error, depth.
struct SlotSums {
    Lanes all[kSlotFloats];
};
// One block; `raw` is the splat's alpha there.
template <bool kDepth, bool kJudge>
[[gnu::always_inline]] inline void blend_back(BlockGrad& b, const Footprint<Lanes>& splat, const Vec2<Lanes>& d, Lanes raw, SlotSums& sums) {
    const BlendGrad<Lanes> grad = blend_grad<kDepth>(b.pixel, splat, raw);
    const Lanes gx = grad.g * d.x, gy = grad.g * d.y;
    Lanes* const s = sums.all;
    s[0] += grad.g, s[1] += gx, s[2] += gy;
    s[3] += gx * d.x, s[4] += gx * d.y, s[5] += gy * d.y;
    s[6] += grad.weight * b.pixel.v.x, s[7] += grad.weight * b.pixel.v.y, s[8] += grad.weight * b.pixel.v.z;
    if constexpr (kJudge) s[9] += grad.weight, s[10] += grad.weight * b.error;
    if constexpr (kDepth) s[11] += grad.weight * b.pixel.v_depth;
}

// All blocks that a splat touches, at least one.
template <bool kDepth, bool kJudge>
[[gnu::always_inline]] inline Lanes tile_gradient(const Record& s, std::uint32_t touched, float tile_x, float tile_y, const BlockPixels& grid,
                                                  BlockGrad* blocks) {
    const Footprint<Lanes> splat = spread(s);
    const Lanes from_x = grid.x + Lanes(tile_x - s.x), from_y = grid.y + Lanes(tile_y - s.y);
    alignas(64) static constexpr float kCorner[4] = {0, 4, 8, 12};
    const auto offset = [&](int block) { return Vec2<Lanes>{from_x + Lanes(kCorner[block % 4]), from_y + Lanes(kCorner[block / 4])}; };
    SlotSums sums;
    int block = __builtin_ctz(touched);
    Vec2<Lanes> d = offset(block);
    Lanes raw = raw_alpha(splat, d.x, d.y);
    // The next block's alpha is asked for before this block's gradient, which waits for its own: the processor sees only some
    // hundred operations ahead, and one block after the other would leave half of its units idle.
    while (touched &= touched - 1) {
        const int next = __builtin_ctz(touched);
        const Vec2<Lanes> next_d = offset(next);
        const Lanes next_raw = raw_alpha(splat, next_d.x, next_d.y);
        blend_back<kDepth, kJudge>(blocks[block], splat, d, raw, sums);
        block = next, d = next_d, raw = next_raw;
    }
    blend_back<kDepth, kJudge>(blocks[block], splat, d, raw, sums);
    return sums12(sums.all);
}

template <bool kDepth, bool kJudge>
inline void backward_tile(const Frame& f, int tile) {
    const FlushDenormals flush;
    const int column = tile % f.tiles_x, row = tile / f.tiles_x;
    const BlockPixels grid = block_pixels();
    BlockGrad blocks[16];
    for (int block = 0; block < 16; ++block)
        blocks[block] = first_state(f, (row * kTile + block / 4 * 4) * f.stride + column * kTile + block % 4 * 4);
    if (const int next = tile + 1; next < f.tiles_x * f.tiles_y) {
        const std::ptrdiff_t corner = next / f.tiles_x * kTile * f.stride + next % f.tiles_x * kTile;
        for (int c = 0; c < 3; ++c) {
            fetch_tile<0>(f.color[c] + corner, f.stride);
            fetch_tile<0>(f.v[c] + corner, f.stride);
            if constexpr (kJudge) fetch_tile<0>(f.error[c] + corner, f.stride);
        }
    }
    constexpr std::uint32_t kAhead = 8;  // records fetched before their turn: they lie in the splats' order, not in this one
    const std::uint32_t end = f.tile_begin[tile + 1];
    for (std::uint32_t i = f.tile_begin[tile]; i < end; ++i) {
        __builtin_prefetch(&f.records[f.list[i + kAhead < end ? i + kAhead : i]]);
        const std::uint32_t record = f.list[i];
        const Record& s = f.records[record];
        Lanes sums;
        if (f.masks[i]) sums = tile_gradient<kDepth, kJudge>(s, f.masks[i], static_cast<float>(column * kTile), static_cast<float>(row * kTile), grid, blocks);
        const std::size_t slot = f.piece_slot[record >> f.piece_shift] + s.first_slot +
                                 static_cast<std::size_t>(row - s.tile_y) * s.tiles_wide + static_cast<std::size_t>(column - s.tile_x);
        store12(sums, f.slots + slot * kSlotFloats);
    }
}

inline void backward_any(const Frame& f, int tile) {
    const bool judge = f.error[0];
    if (f.v_depth)
        judge ? backward_tile<true, true>(f, tile) : backward_tile<true, false>(f, tile);
    else
        judge ? backward_tile<false, true>(f, tile) : backward_tile<false, false>(f, tile);
}

}  // namespace fastscene::splat::FASTSCENE_ISA
