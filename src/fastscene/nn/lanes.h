// SIMD vectors of floats. Private to nn/, and to sources compiled for the baseline instruction set.
#pragma once

#include <bit>
#include <cstdint>

namespace fastscene::nn {

#if defined(__AVX512F__)
constexpr int kLanes = 16;
#else
constexpr int kLanes = 8;
#endif
typedef float Lanes __attribute__((vector_size(kLanes * sizeof(float)), aligned(4)));
typedef std::int32_t Whole __attribute__((vector_size(kLanes * sizeof(float)), aligned(4)));

inline Lanes load(const float* p) { return *reinterpret_cast<const Lanes*>(p); }
inline void store(float* p, Lanes x) { *reinterpret_cast<Lanes*>(p) = x; }
inline Lanes all(float x) { return x - Lanes{}; }

// e^x for x <= 0: 2^integer part via the exponent bits, 2^fraction by a polynomial (relative error 2e-7); underflows to
// 1e-38, which is negligible in any sum.
inline Lanes exp_of(Lanes x) {
    const Lanes y = x * all(1.44269504088896341f);
    const Lanes far_down = all(-126.f), clipped = y > far_down ? y : far_down;
    const Lanes magic = all(12582912.f);  // 1.5 * 2^23: adding it rounds to a whole number
    const Lanes shifted = clipped + magic, rest = clipped - (shifted - magic);
    const Whole exponent = (std::bit_cast<Whole>(shifted) - 0x4B400000) << 23;
    Lanes p = all(1.5403530e-4f);
    p = p * rest + all(1.3333558e-3f);
    p = p * rest + all(9.6181291e-3f);
    p = p * rest + all(5.5504109e-2f);
    p = p * rest + all(2.4022651e-1f);
    p = p * rest + all(6.9314718e-1f);
    p = p * rest + all(1.f);
    const Whole bits = std::bit_cast<Whole>(p) + exponent;
    return std::bit_cast<Lanes>(bits);
}

}  // namespace fastscene::nn
