// One tile of the picture, front to back. A vector is a 4x4 block of pixels; of each splat only the
// blocks that its ellipse really touches are visited.
#pragma once

#include "fastscene/splat/blend.h"
#include "fastscene/splat/kernel.h"
#include "fastscene/splat/lanes.h"

namespace fastscene::splat::FASTSCENE_ISA {

inline Footprint<Lanes> spread(const Record& r) {
    return {r.x, r.y, r.a, r.b, r.c, r.log2_opacity, {r.color[0], r.color[1], r.color[2]}, r.depth_z};
}

// A 4x4 block of a plane, rows one after the other.
inline Lanes load_block(const float* p, std::ptrdiff_t stride) {
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__)
    __m512 r = _mm512_castps128_ps512(_mm_loadu_ps(p));
    r = _mm512_insertf32x4(r, _mm_loadu_ps(p + stride), 1);
    r = _mm512_insertf32x4(r, _mm_loadu_ps(p + 2 * stride), 2);
    return Lanes(_mm512_insertf32x4(r, _mm_loadu_ps(p + 3 * stride), 3));
#else
    float rows[kBlock];
    for (int i = 0; i < 4; ++i) __builtin_memcpy(rows + 4 * i, p + i * stride, 16);
    return Lanes::load(rows);
#endif
}
inline void store_block(Lanes x, float* p, std::ptrdiff_t stride) {
    alignas(64) float rows[kBlock];
    x.store(rows);
    for (int i = 0; i < 4; ++i) __builtin_memcpy(p + i * stride, rows + 4 * i, 16);
}

// Asks for a tile's rows of a plane (a line each) before they are needed: rows lie far apart, so the processor does not foresee them.
template <int kWrite>
inline void fetch_tile(const float* corner, std::ptrdiff_t stride) {
    for (int y = 0; y < kTile; ++y) __builtin_prefetch(corner + y * stride, kWrite);
}

struct BlockPixels {
    Lanes x, y;  // pixel centers relative to the block's corner
};
inline BlockPixels block_pixels() {
    alignas(64) float x[kBlock], y[kBlock];
    for (int i = 0; i < kBlock; ++i) x[i] = static_cast<float>(i % 4) + 0.5f, y[i] = static_cast<float>(i / 4) + 0.5f;
    return {Lanes::load(x), Lanes::load(y)};
}

// Which of the tile's 16 blocks hold a pixel center with alpha >= kMinAlpha (or nearly). The exponent is
// concave: its largest value on the rectangle of pixel centers lies on the column or the row of that
// rectangle nearest to the splat's center.
inline std::uint16_t touched_blocks(const Record& s, float tile_x, float tile_y, const BlockPixels& grid) {
    const Lanes left = Lanes(tile_x + 0.5f - s.x) + (grid.x - Lanes(0.5f)) * Lanes(4.f), right = left + Lanes(3.f);
    const Lanes top = Lanes(tile_y + 0.5f - s.y) + (grid.y - Lanes(0.5f)) * Lanes(4.f), bottom = top + Lanes(3.f);
    const auto exponent = [&](Lanes dx, Lanes dy) { return dx * (Lanes(s.a) * dx + Lanes(s.b) * dy) + Lanes(s.c) * dy * dy; };
    const Lanes near_x = min(max(Lanes(0.f), left), right), near_y = min(max(Lanes(0.f), top), bottom);
    const Lanes best_y = min(max(near_x * Lanes(s.dy_per_dx), top), bottom);
    const Lanes best_x = min(max(near_y * Lanes(s.dx_per_dy), left), right);
    const Lanes most = max(exponent(near_x, best_y), exponent(best_x, near_y));
    constexpr float kLeast = static_cast<float>(-kLog2Of255) - 1e-3f;  // rounding must not lose a pixel
    return static_cast<std::uint16_t>((most >= Lanes(kLeast - s.log2_opacity)).bits());
}

// sets[block] = which of the chunk's splats touch the block.
inline void transpose_masks(const std::uint16_t* masks, std::uint64_t* sets) {
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__)
    const __m512i low = _mm512_loadu_si512(masks), high = _mm512_loadu_si512(masks + 32);
    for (int i = 0; i < 16; ++i) {
        const __m512i bit = _mm512_set1_epi16(static_cast<short>(1u << i));
        sets[i] = _mm512_test_epi16_mask(low, bit) | static_cast<std::uint64_t>(_mm512_test_epi16_mask(high, bit)) << 32;
    }
#else
    for (int i = 0; i < 16; ++i) sets[i] = 0;
    for (int k = 0; k < kChunk; ++k)
        for (std::uint32_t bits = masks[k]; bits; bits &= bits - 1) sets[__builtin_ctz(bits)] |= std::uint64_t{1} << k;
#endif
}

// One chunk of a tile's list, copied together so that the inner loops run in the first-level cache.
struct Chunk {
    Record records[kChunk];
    alignas(64) std::uint16_t masks[kChunk];
    std::uint64_t sets[16];
    int count;

    void gather(const Frame& f, std::uint32_t begin, std::uint32_t end) {
        count = end - begin < kChunk ? static_cast<int>(end - begin) : kChunk;
        for (int i = 0; i < count; ++i) records[i] = f.records[f.list[begin + static_cast<std::uint32_t>(i)]];
    }
};

template <bool kDepth>
inline void forward_tile(const Frame& f, int tile) {
    const FlushDenormals flush;
    const int tile_x = tile % f.tiles_x * kTile, tile_y = tile / f.tiles_x * kTile;
    const BlockPixels grid = block_pixels();
    PixelState<Lanes> state[16];
    Lanes depth[16];
    for (auto& s : state) s.transmittance = Lanes(1.f);
    std::uint32_t open = 0xffff;  // blocks that still let light through
    Chunk chunk;
    const std::ptrdiff_t corner = tile_y * f.stride + tile_x;
    for (float* plane : {f.color[0], f.color[1], f.color[2], f.transmittance}) fetch_tile<1>(plane + corner, f.stride);

    const std::uint32_t end = f.tile_begin[tile + 1];
    for (std::uint32_t begin = f.tile_begin[tile]; begin < end; begin += kChunk) {
        if (!open) {  // the backward pass reads the masks: nothing more is touched
            __builtin_memset(f.masks + begin, 0, (end - begin) * sizeof(std::uint16_t));
            break;
        }
        chunk.gather(f, begin, end);
        __builtin_memset(chunk.masks, 0, sizeof chunk.masks);
        for (int i = 0; i < chunk.count; ++i)
            chunk.masks[i] = static_cast<std::uint16_t>(
                open & touched_blocks(chunk.records[i], static_cast<float>(tile_x), static_cast<float>(tile_y), grid));
        __builtin_memcpy(f.masks + begin, chunk.masks, static_cast<std::size_t>(chunk.count) * sizeof(std::uint16_t));
        transpose_masks(chunk.masks, chunk.sets);

        for (std::uint32_t blocks = open; blocks; blocks &= blocks - 1) {
            const int block = __builtin_ctz(blocks);
            const Lanes px = grid.x + Lanes(static_cast<float>(tile_x + block % 4 * 4));
            const Lanes py = grid.y + Lanes(static_cast<float>(tile_y + block / 4 * 4));
            PixelState<Lanes> pixel = state[block];
            Lanes z = depth[block];
            for (std::uint64_t bits = chunk.sets[block]; bits; bits &= bits - 1) {
                const Record& s = chunk.records[__builtin_ctzll(bits)];
                const Lanes weight = blend(pixel, spread(s), px - Lanes(s.x), py - Lanes(s.y));
                if constexpr (kDepth) z += weight * Lanes(s.depth_z);
            }
            state[block] = pixel;
            depth[block] = z;
            if (!(pixel.transmittance >= Lanes(kOpaque)).bits()) open &= ~(1u << block);
        }
    }

    for (int block = 0; block < 16; ++block) {
        const std::ptrdiff_t at = (tile_y + block / 4 * 4) * f.stride + tile_x + block % 4 * 4;
        const PixelState<Lanes>& s = state[block];
        store_block(s.color.x + s.transmittance * Lanes(f.background[0]), f.color[0] + at, f.stride);
        store_block(s.color.y + s.transmittance * Lanes(f.background[1]), f.color[1] + at, f.stride);
        store_block(s.color.z + s.transmittance * Lanes(f.background[2]), f.color[2] + at, f.stride);
        store_block(s.transmittance, f.transmittance + at, f.stride);
        if constexpr (kDepth) store_block(depth[block], f.depth + at, f.stride);
    }
}
inline void forward_any(const Frame& f, int tile) { f.depth ? forward_tile<true>(f, tile) : forward_tile<false>(f, tile); }

}  // namespace fastscene::splat::FASTSCENE_ISA
