// The gradient of one tile. Pixels are lanes while blending; 16 splats' results are then turned around
// so that splats are lanes, which makes the sums over the 16 pixels plain additions.
#pragma once

#include "fastscene/splat/blend_grad.h"
#include "fastscene/splat/isa_raster.h"

namespace fastscene::splat::FASTSCENE_ISA {

// Up to 16 splats' gradients at the 16 pixels of one block.
struct Batch {
    alignas(64) float g[16][16], weight[16][16];
    alignas(64) float center_dx[16], center_dy[16];  // block center - splat center
    int index[16];                                   // place in the chunk
    int count = 0;
};
// dL/d color and the error at the 16 pixels, to be read one pixel at a time.
struct BlockTargets {
    alignas(64) float v[3][16], error[16], v_depth[16];
};

// Moments of g about the block's center: pixel offsets are -1.5, -0.5, 0.5, 1.5 both ways.
struct Moments {
    Lanes one, x, y, xx, xy, yy;
};
inline Moments moments_of(const Lanes* g) {
    Lanes one[4], x[4], xx[4];
    for (int row = 0; row < 4; ++row) {
        const Lanes outer = g[4 * row] + g[4 * row + 3], inner = g[4 * row + 1] + g[4 * row + 2];
        one[row] = outer + inner;
        x[row] = (g[4 * row + 3] - g[4 * row]) * Lanes(1.5f) + (g[4 * row + 2] - g[4 * row + 1]) * Lanes(0.5f);
        xx[row] = outer * Lanes(2.25f) + inner * Lanes(0.25f);
    }
    const auto sum = [](const Lanes* r) { return (r[0] + r[3]) + (r[1] + r[2]); };
    const auto first = [](const Lanes* r) { return (r[3] - r[0]) * Lanes(1.5f) + (r[2] - r[1]) * Lanes(0.5f); };
    const auto second = [](const Lanes* r) { return (r[0] + r[3]) * Lanes(2.25f) + (r[1] + r[2]) * Lanes(0.25f); };
    return {sum(one), sum(x), first(one), sum(xx), first(x), second(one)};
}

// Kept out of line: inside the blending loop it would take that loop's registers.
template <bool kDepth>
[[gnu::noinline]] inline void flush_batch(Batch& batch, const BlockTargets& target, float (*sums)[16]) {
    for (int i = batch.count; i < 16; ++i) {
        Lanes(0.f).store(batch.g[i]), Lanes(0.f).store(batch.weight[i]);
        batch.center_dx[i] = batch.center_dy[i] = 0;
    }
    Lanes pixels[16];
    load_transposed16(batch.g, pixels);
    const Moments m = moments_of(pixels);
    const Lanes dx = Lanes::load(batch.center_dx), dy = Lanes::load(batch.center_dy);
    load_transposed16(batch.weight, pixels);
    Lanes out[16];
    out[0] = m.one;
    out[1] = m.x + dx * m.one;
    out[2] = m.y + dy * m.one;
    out[3] = m.xx + dx * (m.x + out[1]);
    out[4] = m.xy + dx * m.y + dy * out[1];
    out[5] = m.yy + dy * (m.y + out[2]);
    for (int pixel = 0; pixel < 16; ++pixel) {
        const Lanes w = pixels[pixel];
        for (int c = 0; c < 3; ++c) out[6 + c] += w * Lanes(target.v[c][pixel]);
        out[9] += w;
        out[10] += w * Lanes(target.error[pixel]);
        if constexpr (kDepth) out[11] += w * Lanes(target.v_depth[pixel]);
    }
    alignas(64) float rows[16][16];
    for (int i = 0; i < 16; ++i) out[i].store(rows[i]);
    load_transposed16(rows, out);
    for (int i = 0; i < batch.count; ++i) {
        float* sum = sums[batch.index[i]];
        (Lanes::load(sum) + out[i]).store(sum);
    }
    batch.count = 0;
}

// All splats of `set` at one block; pixel state goes on to the next chunk.
template <bool kDepth>
[[gnu::always_inline]] inline void backward_block(const Chunk& chunk, std::uint64_t set, float corner_x, float corner_y, const BlockPixels& grid,
                           const BlockTargets& target, PixelGradState<Lanes>& pixel_state, Batch& batch, float (*sums)[16]) {
    const Lanes px = grid.x + Lanes(corner_x), py = grid.y + Lanes(corner_y);
    PixelGradState<Lanes> pixel = pixel_state;
    for (; set; set &= set - 1) {
        const int index = __builtin_ctzll(set);
        const Record& s = chunk.records[index];
        const BlendGrad<Lanes> grad = blend_grad<kDepth>(pixel, spread(s), px - Lanes(s.x), py - Lanes(s.y));
        const int i = batch.count++;
        grad.g.store(batch.g[i]);
        grad.weight.store(batch.weight[i]);
        batch.center_dx[i] = corner_x + 2.f - s.x;
        batch.center_dy[i] = corner_y + 2.f - s.y;
        batch.index[i] = index;
        if (batch.count == 16) flush_batch<kDepth>(batch, target, sums);
    }
    if (batch.count) flush_batch<kDepth>(batch, target, sums);
    pixel_state = pixel;
}

inline void write_slots(const Frame& f, const Chunk& chunk, int tile_column, int tile_row, const float (*sums)[16]) {
    for (int i = 0; i < chunk.count; ++i) {
        const Record& r = chunk.records[i];
        const std::size_t slot = r.first_slot + static_cast<std::size_t>(tile_row - r.tile_y) * r.tiles_wide +
                                 static_cast<std::size_t>(tile_column - r.tile_x);
        __builtin_memcpy(f.slots + slot * kSlotFloats, sums[i], kSlotFloats * sizeof(float));
    }
}

template <bool kDepth>
inline void backward_tile(const Frame& f, int tile) {
    const FlushDenormals flush;
    const int column = tile % f.tiles_x, row = tile / f.tiles_x;
    const BlockPixels grid = block_pixels();
    PixelGradState<Lanes> state[16];
    BlockTargets targets[16];
    for (int block = 0; block < 16; ++block) {
        const std::ptrdiff_t at = (row * kTile + block / 4 * 4) * f.stride + column * kTile + block % 4 * 4;
        PixelGradState<Lanes>& s = state[block];
        s.v = {load_block(f.v[0] + at, f.stride), load_block(f.v[1] + at, f.stride), load_block(f.v[2] + at, f.stride)};
        s.transmittance = Lanes(1.f);
        s.rest = dot(s.v, Vec3<Lanes>{load_block(f.color[0] + at, f.stride), load_block(f.color[1] + at, f.stride),
                                      load_block(f.color[2] + at, f.stride)});
        BlockTargets& t = targets[block];
        if constexpr (kDepth) {
            s.v_depth = load_block(f.v_depth + at, f.stride);
            s.rest += s.v_depth * load_block(f.depth + at, f.stride);
            s.v_depth.store(t.v_depth);
        }
        s.v.x.store(t.v[0]), s.v.y.store(t.v[1]), s.v.z.store(t.v[2]);
        (load_block(f.error[0] + at, f.stride) + load_block(f.error[1] + at, f.stride) + load_block(f.error[2] + at, f.stride)).store(t.error);
    }
    Chunk chunk;
    Batch batch;
    alignas(64) float sums[kChunk][16];
    const std::uint32_t end = f.tile_begin[tile + 1];
    for (std::uint32_t begin = f.tile_begin[tile]; begin < end; begin += kChunk) {
        chunk.gather(f, begin, end);
        __builtin_memset(chunk.masks, 0, sizeof chunk.masks);
        __builtin_memcpy(chunk.masks, f.masks + begin, static_cast<std::size_t>(chunk.count) * sizeof(std::uint16_t));
        transpose_masks(chunk.masks, chunk.sets);
        __builtin_memset(sums, 0, sizeof sums);
        for (int block = 0; block < 16; ++block)
            if (chunk.sets[block])
                backward_block<kDepth>(chunk, chunk.sets[block], static_cast<float>(column * kTile + block % 4 * 4),
                               static_cast<float>(row * kTile + block / 4 * 4), grid, targets[block], state[block], batch, sums);
        write_slots(f, chunk, column, row, sums);
    }
}

inline void backward_any(const Frame& f, int tile) { f.v_depth ? backward_tile<true>(f, tile) : backward_tile<false>(f, tile); }

}  // namespace fastscene::splat::FASTSCENE_ISA
