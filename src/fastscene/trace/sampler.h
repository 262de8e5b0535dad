// Sampler: low-discrepancy numbers in [0, 1) for the paths of a pixel.
//
// The first two Sobol dimensions with hash-based Owen scrambling, one scrambled and shuffled copy per pair of
// dimensions (Burley 2020, "Practical hash-based Owen scrambling"): any aligned power of two of consecutive samples is
// well stratified in every pair.
#pragma once

#include <algorithm>
#include <cstdint>

#include "fastscene/base/random.h"
#include "fastscene/math/vec.h"

namespace fastscene {

// Veach's power heuristic for one sample of each strategy: the weight of the sample with the pdf `mine`.
inline float power_heuristic(float mine, float other) {
    return mine * mine / std::max(1e-20f, mine * mine + other * other);
}

class Sampler {
  public:
    // Paths of one pixel share `key` and differ in `index`.
    Sampler(std::uint64_t key, std::uint32_t index) : key_(key), index_(index) {}

    Vec2f next2() {
        const std::uint64_t h = mix64(key_ + 0x632be59bd9b4e019ull * ++dimension_);
        const std::uint32_t i = scrambled(reversed(index_), static_cast<std::uint32_t>(h));
        const std::uint32_t n = reversed(i);
        return {unit(scrambled_value(reversed(n), static_cast<std::uint32_t>(h >> 32))),
                unit(scrambled_value(sobol_second(n), static_cast<std::uint32_t>(mix64(h))))};
    }
    float next() { return next2().x; }

  private:
    static constexpr std::uint32_t reversed(std::uint32_t x) {
        x = x << 16 | x >> 16;
        x = (x & 0x00ff00ffu) << 8 | (x & 0xff00ff00u) >> 8;
        x = (x & 0x0f0f0f0fu) << 4 | (x & 0xf0f0f0f0u) >> 4;
        x = (x & 0x33333333u) << 2 | (x & 0xccccccccu) >> 2;
        return (x & 0x55555555u) << 1 | (x & 0xaaaaaaaau) >> 1;
    }
    // Laine and Karras' permutation: each bit is flipped by a hash of the bits below it.
    static constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
        x ^= x * 0x3d20adeau;
        x += seed;
        x *= (seed >> 16) | 1u;
        x ^= x * 0x05526c56u;
        return x ^ x * 0x53a22864u;
    }
    static constexpr std::uint32_t scrambled_value(std::uint32_t x, std::uint32_t seed) {
        return reversed(scrambled(reversed(x), seed));
    }
    // Sobol's second dimension: Pascal's triangle modulo 2, its columns by repeated shifting.
    static constexpr std::uint32_t sobol_second(std::uint32_t n) {
        std::uint32_t value = 0;
        for (std::uint32_t column = 1u << 31; n; n >>= 1, column ^= column >> 1)
            if (n & 1u) value ^= column;
        return value;
    }
    static constexpr float unit(std::uint32_t x) { return static_cast<float>(x >> 8) * 0x1p-24f; }

    std::uint64_t key_;
    std::uint32_t index_, dimension_ = 0;
};

}  // namespace fastscene
