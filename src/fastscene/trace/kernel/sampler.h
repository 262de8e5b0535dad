// Low-discrepancy numbers in [0, 1) for the paths of a pixel.
//
// The first two Sobol dimensions with hash-based Owen scrambling, one scrambled and shuffled copy per pair of
// dimensions (Burley 2020, "Practical hash-based Owen scrambling"): any aligned power of two of consecutive samples is
// well stratified in every pair.
#ifndef FASTSCENE_TRACE_KERNEL_SAMPLER_H
#define FASTSCENE_TRACE_KERNEL_SAMPLER_H

#include "fastscene/trace/kernel/random.h"

KERNEL_BEGIN

// Veach's power heuristic for one sample of each strategy: the weight of the sample with the pdf `mine`.
inline float power_heuristic(float mine, float other) { return mine * mine / max(1e-20f, mine * mine + other * other); }

// Paths of one pixel share `key` and differ in `index`; `dimension` starts at 0.
struct Sampler {
    uint64 key;
    uint index, dimension;
};

#ifdef __cplusplus
inline uint reversed_bits(uint x) {
    x = x << 16 | x >> 16;
    x = (x & 0x00ff00ffu) << 8 | (x & 0xff00ff00u) >> 8;
    x = (x & 0x0f0f0f0fu) << 4 | (x & 0xf0f0f0f0u) >> 4;
    x = (x & 0x33333333u) << 2 | (x & 0xccccccccu) >> 2;
    return (x & 0x55555555u) << 1 | (x & 0xaaaaaaaau) >> 1;
}
#else
uint reversed_bits(uint x) { return bitfieldReverse(x); }
#endif
// Laine and Karras' permutation: each bit is flipped by a hash of the bits below it.
inline uint scrambled(uint x, uint seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    return x ^ x * 0x53a22864u;
}
inline uint scrambled_value(uint x, uint seed) { return reversed_bits(scrambled(reversed_bits(x), seed)); }
// Sobol's second dimension: Pascal's triangle modulo 2, its columns by repeated shifting.
inline uint sobol_second(uint n) {
    uint value = 0;
    for (uint column = 1u << 31; n != 0; n >>= 1, column ^= column >> 1)
        if ((n & 1u) != 0) value ^= column;
    return value;
}
inline float unit_of_bits(uint x) { return float(x >> 8) * 5.9604644775390625e-8f; }

inline Vec2f next2(INOUT(Sampler) s) {
    s.dimension += 1;
    const uint64 h = mix64(add64(s.key, mul64(word64(0x632be59bu, 0xd9b4e019u), word64(0, s.dimension))));
    const uint i = scrambled(reversed_bits(s.index), low_half(h));
    const uint n = reversed_bits(i);
    return vec2(unit_of_bits(scrambled_value(reversed_bits(n), high_half(h))),
                unit_of_bits(scrambled_value(sobol_second(n), low_half(mix64(h)))));
}
inline float next(INOUT(Sampler) s) { return next2(s).x; }

KERNEL_END

#endif
