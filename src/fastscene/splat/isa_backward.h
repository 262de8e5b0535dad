// The gradient of one tile, splat after splat, front to back once more. A vector is a 4x4 block of pixels; what a
// splat's blocks say is summed up in registers, lane by lane, and over the lanes once, when the splat's last block is done.
#pragma once

#include <initializer_list>

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
    b.error = block(f.error[0]) + block(f.error[1]) + block(f.error[2]);
    return b;
}

// The slot of one splat at one tile (kSlotFloats): moments of g = dL/d(ln alpha) about the splat's center, then color, weight, error, depth.
template <bool kDepth>
[[gnu::always_inline]] inline Lanes tile_gradient(const Record& s, std::uint32_t touched, float tile_x, float tile_y, const BlockPixels& grid,
                                                  BlockGrad* blocks) {
    const Footprint<Lanes> splat = spread(s);
    const Lanes from_x = grid.x + Lanes(tile_x - s.x), from_y = grid.y + Lanes(tile_y - s.y);
    alignas(64) static constexpr float kCorner[4] = {0, 4, 8, 12};
    Lanes one, x, y, xx, xy, yy, red, green, blue, weight, error, depth;
    // The next block's alpha is asked for before this block's gradient, which waits for its own: the processor sees only some
    // hundred operations ahead, and one visit after the other would leave half of its units idle.
    const auto offset = [&](int block) { return Vec2<Lanes>{from_x + Lanes(kCorner[block % 4]), from_y + Lanes(kCorner[block / 4])}; };
    int block = __builtin_ctz(touched);
    Vec2<Lanes> d = offset(block);
    Lanes raw = raw_alpha(splat, d.x, d.y);
    for (;;) {
        touched &= touched - 1;
        const int next = __builtin_ctz(touched | 1u << 15);
        const Vec2<Lanes> next_d = offset(next);
        const Lanes next_raw = raw_alpha(splat, next_d.x, next_d.y);
        BlockGrad& b = blocks[block];
        const BlendGrad<Lanes> grad = blend_grad<kDepth>(b.pixel, splat, raw);
        const Lanes gx = grad.g * d.x, gy = grad.g * d.y;
        one += grad.g, x += gx, y += gy;
        xx += gx * d.x, xy += gx * d.y, yy += gy * d.y;
        red += grad.weight * b.pixel.v.x, green += grad.weight * b.pixel.v.y, blue += grad.weight * b.pixel.v.z;
        weight += grad.weight;
        error += grad.weight * b.error;
        if constexpr (kDepth) depth += grad.weight * b.pixel.v_depth;
        if (!touched) break;
        block = next, d = next_d, raw = next_raw;
    }
    const Lanes all[kSlotFloats] = {one, x, y, xx, xy, yy, red, green, blue, weight, error, depth};
    return sums12(all);
}

template <bool kDepth>
inline void backward_tile(const Frame& f, int tile) {
    const FlushDenormals flush;
    const int column = tile % f.tiles_x, row = tile / f.tiles_x;
    const BlockPixels grid = block_pixels();
    BlockGrad blocks[16];
    for (int block = 0; block < 16; ++block)
        blocks[block] = first_state(f, (row * kTile + block / 4 * 4) * f.stride + column * kTile + block % 4 * 4);
    if (const int next = tile + 1; next < f.tiles_x * f.tiles_y) {
        const std::ptrdiff_t corner = next / f.tiles_x * kTile * f.stride + next % f.tiles_x * kTile;
        for (int c = 0; c < 3; ++c)
            for (const float* plane : std::initializer_list<const float*>{f.color[c], f.v[c], f.error[c]}) fetch_tile<0>(plane + corner, f.stride);
    }
    constexpr std::uint32_t kAhead = 8;  // records fetched before their turn: they lie in the splats' order, not in this one
    const std::uint32_t end = f.tile_begin[tile + 1];
    for (std::uint32_t i = f.tile_begin[tile]; i < end; ++i) {
        __builtin_prefetch(&f.records[f.list[i + kAhead < end ? i + kAhead : i]]);
        const std::uint32_t record = f.list[i];
        const Record& s = f.records[record];
        Lanes sums;
        if (f.masks[i]) sums = tile_gradient<kDepth>(s, f.masks[i], static_cast<float>(column * kTile), static_cast<float>(row * kTile), grid, blocks);
        const std::size_t slot = f.piece_slot[record / static_cast<std::uint32_t>(f.records_a_piece)] + s.first_slot +
                                 static_cast<std::size_t>(row - s.tile_y) * s.tiles_wide + static_cast<std::size_t>(column - s.tile_x);
        store12(sums, f.slots + slot * kSlotFloats);
    }
}

inline void backward_any(const Frame& f, int tile) { f.v_depth ? backward_tile<true>(f, tile) : backward_tile<false>(f, tile); }

}  // namespace fastscene::splat::FASTSCENE_ISA
