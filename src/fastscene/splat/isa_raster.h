// Forward pass of one tile, front to back. A vector is a 4x4 block of pixels; of each splat only the blocks that its
// ellipse actually touches are visited.
#pragma once

#include "fastscene/splat/isa_alpha.h"

namespace fastscene::splat::FASTSCENE_ISA {

// A 4x4 block of a plane, rows one after the other.
inline Lanes load_block(const float* p, std::ptrdiff_t stride) {
#if FASTSCENE_WIDE
    __m512 r = _mm512_castps128_ps512(_mm_loadu_ps(p));
    r = _mm512_insertf32x4(r, _mm_loadu_ps(p + stride), 1);
    r = _mm512_insertf32x4(r, _mm_loadu_ps(p + 2 * stride), 2);
    return Lanes(_mm512_insertf32x4(r, _mm_loadu_ps(p + 3 * stride), 3));
#else
    typedef float Row __attribute__((vector_size(16)));
    Row row[4];
    for (int i = 0; i < 4; ++i) __builtin_memcpy(row + i, p + i * stride, sizeof(Row));
    // Assembled in registers: a load that spans two recent stores stalls.
    const auto both = [](Row a, Row b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7); };
    return {both(row[0], row[1]), both(row[2], row[3])};
#endif
}
inline void store_block(Lanes x, float* p, std::ptrdiff_t stride) {
    alignas(64) float rows[kBlock];
    x.store(rows);
    for (int i = 0; i < 4; ++i) __builtin_memcpy(p + i * stride, rows + 4 * i, 16);
}

// Prefetches a tile's rows of a plane (one cache line each): they are too far apart for the hardware prefetcher.
template <int kWrite>
inline void fetch_tile(const float* corner, std::ptrdiff_t stride) {
    for (int y = 0; y < kTile; ++y) __builtin_prefetch(corner + y * stride, kWrite);
}

// Which of the tile's 16 blocks contain a pixel center with alpha >= kMinAlpha (conservatively). The exponent is
// concave, so its maximum over the rectangle of pixel centers lies on the column or row nearest to the splat's center.
inline std::uint16_t touched_blocks(const Record& s, float tile_x, float tile_y, const BlockPixels& grid) {
    const Lanes left = Lanes(tile_x + 0.5f - s.x) + (grid.x - Lanes(0.5f)) * Lanes(4.f), right = left + Lanes(3.f);
    const Lanes top = Lanes(tile_y + 0.5f - s.y) + (grid.y - Lanes(0.5f)) * Lanes(4.f), bottom = top + Lanes(3.f);
    const auto exponent = [&](Lanes dx, Lanes dy) {
        return dx * (Lanes(s.a) * dx + Lanes(s.b) * dy) + Lanes(s.c) * dy * dy;
    };
    const Lanes near_x = min(max(Lanes(0.f), left), right), near_y = min(max(Lanes(0.f), top), bottom);
    const Lanes best_y = min(max(near_x * Lanes(s.dy_per_dx), top), bottom);
    const Lanes best_x = min(max(near_y * Lanes(s.dx_per_dy), left), right);
    const Lanes most = max(exponent(near_x, best_y), exponent(best_x, near_y));
    constexpr float kLeast = static_cast<float>(-kLog2Of255) - 1e-3f;  // margin: rounding must not lose a pixel
    return static_cast<std::uint16_t>((most >= Lanes(kLeast - s.log2_opacity)).bits());
}

// sets[block] = which of the chunk's splats touch the block.
inline void transpose_masks(const std::uint16_t* masks, std::uint64_t* sets) {
#if FASTSCENE_WIDE
    const __m512i low = _mm512_loadu_si512(masks), high = _mm512_loadu_si512(masks + 32);
    for (int i = 0; i < 16; ++i) {
        const __m512i bit = _mm512_set1_epi16(static_cast<short>(1u << i));
        sets[i] = _mm512_test_epi16_mask(low, bit) | static_cast<std::uint64_t>(_mm512_test_epi16_mask(high, bit))
                                                         << 32;
    }
#elif defined(__AVX2__)
    // One byte per splat, for blocks 0..7 and 8..15; movemask extracts the top bits of all bytes, then the next bits
    // are shifted up.
    const auto load = [&](int i) { return _mm256_load_si256(reinterpret_cast<const __m256i*>(masks) + i); };
    const auto bytes = [](__m256i a, __m256i b) { return _mm256_permute4x64_epi64(_mm256_packus_epi16(a, b), 0xd8); };
    const __m256i low_byte = _mm256_set1_epi16(0xff);
    for (int i = 0; i < 16; ++i) sets[i] = 0;
    for (int part = 0; part < 2; ++part) {
        const __m256i a = load(2 * part), b = load(2 * part + 1);
        __m256i low = bytes(_mm256_and_si256(a, low_byte), _mm256_and_si256(b, low_byte));
        __m256i high = bytes(_mm256_srli_epi16(a, 8), _mm256_srli_epi16(b, 8));
        const auto topmost = [&](__m256i x) {
            return std::uint64_t{static_cast<std::uint32_t>(_mm256_movemask_epi8(x))} << (32 * part);
        };
        for (int i = 7; i >= 0; --i) {
            sets[i] |= topmost(low), sets[i + 8] |= topmost(high);
            low = _mm256_add_epi8(low, low), high = _mm256_add_epi8(high, high);
        }
    }
#else
    for (int i = 0; i < 16; ++i) sets[i] = 0;
    for (int k = 0; k < kChunk; ++k)
        for (std::uint32_t bits = masks[k]; bits; bits &= bits - 1) sets[__builtin_ctz(bits)] |= std::uint64_t{1} << k;
#endif
}

// A chunk of a tile's list, copied so that the inner loops run in the L1 cache.
struct Chunk {
    Record records[kChunk];
    TileAlpha alphas[kChunk];
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
    std::uint32_t open = 0xffff;  // blocks that are not opaque yet
    Chunk chunk;
    const std::ptrdiff_t corner = tile_y * f.stride + tile_x;
    for (float* plane : {f.color[0], f.color[1], f.color[2], f.transmittance}) fetch_tile<1>(plane + corner, f.stride);

    const std::uint32_t end = f.tile_begin[tile + 1];
    for (std::uint32_t begin = f.tile_begin[tile]; begin < end; begin += kChunk) {
        if (!open) {  // the backward pass reads the masks: mark the rest as untouched
            __builtin_memset(f.masks + begin, 0, (end - begin) * sizeof(std::uint16_t));
            break;
        }
        chunk.gather(f, begin, end);
        __builtin_memset(chunk.masks, 0, sizeof chunk.masks);
        for (int i = 0; i < chunk.count; ++i) {
            const Record& s = chunk.records[i];
            chunk.masks[i] = static_cast<std::uint16_t>(
                open & touched_blocks(s, static_cast<float>(tile_x), static_cast<float>(tile_y), grid));
            chunk.alphas[i] = TileAlpha(s, static_cast<float>(tile_x), static_cast<float>(tile_y));
        }
        __builtin_memcpy(f.masks + begin, chunk.masks, static_cast<std::size_t>(chunk.count) * sizeof(std::uint16_t));
        transpose_masks(chunk.masks, chunk.sets);

        for (std::uint32_t blocks = open; blocks; blocks &= blocks - 1) {
            const int block = __builtin_ctz(blocks);
            const Lanes px = grid.x + Lanes(static_cast<float>(tile_x + block % 4 * 4));
            const Lanes py = grid.y + Lanes(static_cast<float>(tile_y + block / 4 * 4));
            PixelState<Lanes> pixel = state[block];
            Lanes z = depth[block];
            for (std::uint64_t bits = chunk.sets[block]; bits; bits &= bits - 1) {
                const int i = __builtin_ctzll(bits);
                const Record& s = chunk.records[i];
                const Footprint<Lanes> splat = spread(s);
                const Lanes weight = blend(
                    pixel, splat,
                    chunk.alphas[i].raw(static_cast<std::size_t>(block), splat, {px - splat.x, py - splat.y}));
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
inline void forward_any(const Frame& f, int tile) {
    f.depth ? forward_tile<true>(f, tile) : forward_tile<false>(f, tile);
}

}  // namespace fastscene::splat::FASTSCENE_ISA
