// Lanes: 16 floats that behave like one number. Included once per instruction set, each time in the namespace
// FASTSCENE_ISA: one 64-byte register with AVX-512, otherwise two 32-byte halves (a 64-byte vector type compiled for
// AVX2 is several times slower).
#pragma once

#ifndef FASTSCENE_ISA
#error "define FASTSCENE_ISA before including this file"
#endif

#include <cstdint>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace fastscene::splat::FASTSCENE_ISA {

inline constexpr int kLanes = 16;

#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__)
#define FASTSCENE_WIDE 1  // one register holds all lanes
#else
#define FASTSCENE_WIDE 0
#endif

#if FASTSCENE_WIDE

struct Mask {
    __mmask16 m;
    friend Mask operator&(Mask a, Mask b) { return {static_cast<__mmask16>(a.m & b.m)}; }
    std::uint32_t bits() const { return m; }
};
struct Lanes {
    __m512 r;
    Lanes() : r(_mm512_setzero_ps()) {}
    Lanes(float x) : r(_mm512_set1_ps(x)) {}
    explicit Lanes(__m512 x) : r(x) {}
    static Lanes load(const float* p) { return Lanes(_mm512_loadu_ps(p)); }
    void store(float* p) const { _mm512_storeu_ps(p, r); }
    friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.r + b.r); }
    friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.r - b.r); }
    friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.r * b.r); }
    friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.r / b.r); }
    friend Lanes operator-(Lanes a) { return Lanes(-a.r); }
    Lanes& operator+=(Lanes b) { return *this = *this + b; }
    Lanes& operator-=(Lanes b) { return *this = *this - b; }
    friend Mask operator<(Lanes a, Lanes b) { return {_mm512_cmp_ps_mask(a.r, b.r, _CMP_LT_OQ)}; }
    friend Mask operator>(Lanes a, Lanes b) { return {_mm512_cmp_ps_mask(a.r, b.r, _CMP_GT_OQ)}; }
    friend Mask operator<=(Lanes a, Lanes b) { return {_mm512_cmp_ps_mask(a.r, b.r, _CMP_LE_OQ)}; }
    friend Mask operator>=(Lanes a, Lanes b) { return {_mm512_cmp_ps_mask(a.r, b.r, _CMP_GE_OQ)}; }
};
inline Lanes select(Mask m, Lanes yes, Lanes no) { return Lanes(_mm512_mask_mov_ps(no.r, m.m, yes.r)); }
inline Lanes sqrt(Lanes a) { return Lanes(_mm512_sqrt_ps(a.r)); }
inline Lanes min(Lanes a, Lanes b) { return Lanes(_mm512_min_ps(a.r, b.r)); }
inline Lanes max(Lanes a, Lanes b) { return Lanes(_mm512_max_ps(a.r, b.r)); }
inline Lanes abs(Lanes a) { return Lanes(_mm512_abs_ps(a.r)); }
inline Lanes round_near(Lanes a) { return Lanes(_mm512_roundscale_ps(a.r, 8)); }
// x * 2^n for integral n of any size.
inline Lanes scale2(Lanes x, Lanes n) { return Lanes(_mm512_scalef_ps(x.r, n.r)); }
// a = mantissa * 2^exponent with mantissa in [0.75, 1.5); a > 0.
inline void split2(Lanes a, Lanes& mantissa, Lanes& exponent) {
    mantissa.r = _mm512_getmant_ps(a.r, _MM_MANT_NORM_p75_1p5, _MM_MANT_SIGN_src);
    exponent.r = _mm512_getexp_ps(a.r / mantissa.r);
}
inline Lanes cut(Lanes x, Lanes low, Lanes high) {
    return Lanes(_mm512_maskz_min_ps(_mm512_cmp_ps_mask(x.r, low.r, _CMP_GE_OQ), x.r, high.r));
}
inline Lanes above(Lanes x, Lanes low) {
    return Lanes(_mm512_maskz_mov_ps(_mm512_cmp_ps_mask(x.r, low.r, _CMP_GE_OQ), x.r));
}
// `size` with the sign of x; 0 where x is 0.
inline Lanes signed_like(Lanes x, Lanes size) {
    const __m512 positive = _mm512_maskz_mov_ps(_mm512_cmp_ps_mask(x.r, _mm512_setzero_ps(), _CMP_GT_OQ), size.r);
    return Lanes(
        _mm512_mask_sub_ps(positive, _mm512_cmp_ps_mask(x.r, _mm512_setzero_ps(), _CMP_LT_OQ), positive, size.r));
}
// 1 / a to about 1e-7 relative: hardware estimate (14 bits) and one Newton step.
inline Lanes reciprocal(Lanes a) {
    const Lanes r(_mm512_rcp14_ps(a.r));
    return r * (Lanes(2.f) - a * r);
}
// a / b to about 1e-7 relative.
inline Lanes quotient(Lanes a, Lanes b) { return a * reciprocal(b); }
// 2^x to 3e-6 relative (interpolated at the Chebyshev points of [-1/2, 1/2]); for the blending loops.
[[gnu::always_inline]] inline Lanes exp2_fast(Lanes x) {
    const Lanes n = round_near(x), f = x - n;
    Lanes p(0.00966636852f);
    p = p * f + Lanes(0.0559219758f);
    p = p * f + Lanes(0.24022349f);
    p = p * f + Lanes(0.693121045f);
    p = p * f + Lanes(1.f);
    return scale2(p, n);
}

// Integers stored as the bits of lanes.
inline Lanes lane_numbers(std::int32_t first) {
    const __m512i lane = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    return Lanes(_mm512_castsi512_ps(_mm512_add_epi32(_mm512_set1_epi32(first), lane)));
}
// floor(x / 16) in the lower, floor(y / 16) in the upper 16 bits; 0 <= x, y < 2^20.
inline Lanes sixteenths(Lanes x, Lanes y) {
    const __m512i low = _mm512_srli_epi32(_mm512_cvttps_epi32(x.r), 4),
                  high = _mm512_slli_epi32(_mm512_cvttps_epi32(y.r), 12);
    return Lanes(_mm512_castsi512_ps(
        _mm512_or_si512(low, _mm512_and_si512(high, _mm512_set1_epi32(static_cast<int>(0xffff0000u))))));
}
// The number of 16-bit values in each inclusive range `from` to `to`, both dimensions.
inline Lanes spans(Lanes from, Lanes to) {
    const __m512i between = _mm512_sub_epi32(_mm512_castps_si512(to.r), _mm512_castps_si512(from.r));
    return Lanes(_mm512_castsi512_ps(_mm512_add_epi32(between, _mm512_set1_epi32(0x00010001))));
}

#else

typedef float Half __attribute__((vector_size(32)));
typedef std::int32_t HalfBits __attribute__((vector_size(32)));

struct Mask {
    HalfBits lo, hi;
    friend Mask operator&(Mask a, Mask b) { return {a.lo & b.lo, a.hi & b.hi}; }
    std::uint32_t bits() const {
        std::uint32_t out = 0;
#if defined(__AVX__)
        out = static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)lo)) |
              static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)hi)) << 8;
#else
        for (int i = 0; i < 8; ++i) out |= (lo[i] ? 1u : 0u) << i | (hi[i] ? 1u : 0u) << (i + 8);
#endif
        return out;
    }
};
struct Lanes {
    Half lo, hi;
    Lanes() : lo{}, hi{} {}
    Lanes(float x) : lo(x - Half{}), hi(lo) {}
    Lanes(Half a, Half b) : lo(a), hi(b) {}
    static Lanes load(const float* p) {
        Lanes out;
        __builtin_memcpy(&out.lo, p, 32);
        __builtin_memcpy(&out.hi, p + 8, 32);
        return out;
    }
    void store(float* p) const {
        __builtin_memcpy(p, &lo, 32);
        __builtin_memcpy(p + 8, &hi, 32);
    }
    friend Lanes operator+(Lanes a, Lanes b) { return {a.lo + b.lo, a.hi + b.hi}; }
    friend Lanes operator-(Lanes a, Lanes b) { return {a.lo - b.lo, a.hi - b.hi}; }
    friend Lanes operator*(Lanes a, Lanes b) { return {a.lo * b.lo, a.hi * b.hi}; }
    friend Lanes operator/(Lanes a, Lanes b) { return {a.lo / b.lo, a.hi / b.hi}; }
    friend Lanes operator-(Lanes a) { return {-a.lo, -a.hi}; }
    Lanes& operator+=(Lanes b) { return *this = *this + b; }
    Lanes& operator-=(Lanes b) { return *this = *this - b; }
    friend Mask operator<(Lanes a, Lanes b) { return {a.lo < b.lo, a.hi < b.hi}; }
    friend Mask operator>(Lanes a, Lanes b) { return {a.lo > b.lo, a.hi > b.hi}; }
    friend Mask operator<=(Lanes a, Lanes b) { return {a.lo <= b.lo, a.hi <= b.hi}; }
    friend Mask operator>=(Lanes a, Lanes b) { return {a.lo >= b.lo, a.hi >= b.hi}; }
};
inline Lanes select(Mask m, Lanes yes, Lanes no) { return {m.lo ? yes.lo : no.lo, m.hi ? yes.hi : no.hi}; }
#if defined(__AVX2__)
inline Lanes sqrt(Lanes a) { return {_mm256_sqrt_ps(a.lo), _mm256_sqrt_ps(a.hi)}; }
inline Half min(Half a, Half b) { return _mm256_min_ps(a, b); }
inline Half max(Half a, Half b) { return _mm256_max_ps(a, b); }
#else
inline Lanes sqrt(Lanes a) {
    for (int i = 0; i < 8; ++i) a.lo[i] = __builtin_sqrtf(a.lo[i]), a.hi[i] = __builtin_sqrtf(a.hi[i]);
    return a;
}
inline Half min(Half a, Half b) { return a < b ? a : b; }
inline Half max(Half a, Half b) { return a > b ? a : b; }
#endif
inline Lanes min(Lanes a, Lanes b) { return {min(a.lo, b.lo), min(a.hi, b.hi)}; }
inline Lanes max(Lanes a, Lanes b) { return {max(a.lo, b.lo), max(a.hi, b.hi)}; }
// Broadcast (x + 0 would not preserve -0).
inline Half eight(float x) { return x - Half{}; }
inline Half abs(Half a) { return (Half)((HalfBits)a & 0x7fffffff); }
inline Lanes abs(Lanes a) { return {abs(a.lo), abs(a.hi)}; }
// Adding 1.5 * 2^23 shifts the fraction out of the mantissa; |a| < 2^22.
inline Lanes round_near(Lanes a) {
    const Lanes magic(12582912.f);
    return (a + magic) - magic;
}
inline Half scale2(Half x, Half n) {
    n = n < -126.f ? Half{} - 126.f : n > 127.f ? Half{} + 127.f : n;
    return x * (Half)((__builtin_convertvector(n, HalfBits) + 127) << 23);
}
inline Lanes scale2(Lanes x, Lanes n) { return {scale2(x.lo, n.lo), scale2(x.hi, n.hi)}; }
inline void split2(Half a, Half& mantissa, Half& exponent) {
    const HalfBits bits = (HalfBits)a;
    const HalfBits e = ((bits >> 23) & 255) - 127;
    const Half m = (Half)((bits & 0x007fffff) | 0x3f800000);
    const HalfBits big = m >= 1.5f;
    mantissa = big ? m * 0.5f : m;
    exponent = __builtin_convertvector(e - big, Half);
}
inline void split2(Lanes a, Lanes& mantissa, Lanes& exponent) {
    split2(a.lo, mantissa.lo, exponent.lo);
    split2(a.hi, mantissa.hi, exponent.hi);
}
#if defined(__AVX2__)
// 1 / a to 2e-7 relative: hardware estimate (12 bits) and one Newton step. Division would saturate a single execution
// unit.
inline Lanes reciprocal(Lanes a) {
    const Lanes r(_mm256_rcp_ps(a.lo), _mm256_rcp_ps(a.hi));
    return r * (Lanes(2.f) - a * r);
}
inline Lanes quotient(Lanes a, Lanes b) { return a * reciprocal(b); }
#else
inline Lanes reciprocal(Lanes a) { return Lanes(1.f) / a; }
inline Lanes quotient(Lanes a, Lanes b) { return a / b; }
#endif
inline Half where(HalfBits mask, Half x) { return (Half)((HalfBits)x & mask); }
inline Lanes cut(Lanes x, Lanes low, Lanes high) {
    return {where(x.lo >= low.lo, min(x.lo, high.lo)), where(x.hi >= low.hi, min(x.hi, high.hi))};
}
// `size` with the sign of x; 0 where x is 0.
inline Half signed_like(Half x, Half size) { return where(x > 0.f, size) - where(x < 0.f, size); }
inline Lanes signed_like(Lanes x, Lanes size) { return {signed_like(x.lo, size.lo), signed_like(x.hi, size.hi)}; }
inline Lanes above(Lanes x, Lanes low) { return {where(x.lo >= low.lo, x.lo), where(x.hi >= low.hi, x.hi)}; }
// Two from `a`, two from `b`, and so on. (With identical arguments GCC generates more shuffles.)
inline Half alternate_pairs(Half a, Half b) {
#if defined(__AVX__)
    return _mm256_blend_ps(a, b, 0b11001100);
#else
    return __builtin_shuffle(a, b, HalfBits{0, 1, 10, 11, 4, 5, 14, 15});
#endif
}
// 2^x to 2e-7 relative, |x| <= 126 (the polynomial through 2^f at the Chebyshev points of [-1/2, 1/2]): the exponent is
// added to the bits.
[[gnu::always_inline]] inline Half exp2_near(Half x) {
    const Half magic = Half{} + 12582912.f, shifted = x + magic, f = x - (shifted - magic);  // round_near
    Half p = Half{} + 0.00133813025f;
    p = p * f + 0.00966636852f;
    p = p * f + 0.0555038101f;
    p = p * f + 0.24022349f;
    p = p * f + 0.693147181f;
    p = p * f + 1.f;
    return (Half)((HalfBits)p + ((HalfBits)shifted << 23));
}

inline Lanes lane_numbers(std::int32_t first) {
    const HalfBits lane = {0, 1, 2, 3, 4, 5, 6, 7};
    return {(Half)(lane + first), (Half)(lane + (first + 8))};
}
inline Half sixteenths(Half x, Half y) {
    return (Half)((__builtin_convertvector(x, HalfBits) >> 4) | ((__builtin_convertvector(y, HalfBits) >> 4) << 16));
}
inline Lanes sixteenths(Lanes x, Lanes y) { return {sixteenths(x.lo, y.lo), sixteenths(x.hi, y.hi)}; }
inline Half spans(Half from, Half to) { return (Half)((HalfBits)to - (HalfBits)from + 0x00010001); }
inline Lanes spans(Lanes from, Lanes to) { return {spans(from.lo, to.lo), spans(from.hi, to.hi)}; }

#endif

// 2^x to float precision; for the projection.
inline Lanes exp2(Lanes x) {
    x = min(max(x, Lanes(-200.f)), Lanes(200.f));
    const Lanes n = round_near(x), f = x - n;
    Lanes p(1.54035304e-4f);
    p = p * f + Lanes(1.33335581e-3f);
    p = p * f + Lanes(9.61812911e-3f);
    p = p * f + Lanes(5.55041087e-2f);
    p = p * f + Lanes(0.240226507f);
    p = p * f + Lanes(0.693147181f);
    p = p * f + Lanes(1.f);
    return scale2(p, n);
}
inline Lanes exp(Lanes x) { return exp2(x * Lanes(1.44269504f)); }
// log2 of a > 0 by the atanh series: ln m = 2 (s + s^3/3 + …), s = (m - 1) / (m + 1), |s| <= 0.2.
inline Lanes log2(Lanes a) {
    Lanes m, e;
    split2(a, m, e);
    const Lanes s = (m - Lanes(1.f)) / (m + Lanes(1.f)), z = s * s;
    Lanes p(1.f / 9);
    p = p * z + Lanes(1.f / 7);
    p = p * z + Lanes(1.f / 5);
    p = p * z + Lanes(1.f / 3);
    p = p * z + Lanes(1.f);
    return e + Lanes(2.88539008f) * s * p;
}

// Angle of (x, y) in radians, to 3e-7: atan's series on [0, tan(pi / 8)], the octants by symmetry.
inline Lanes atan2(Lanes y, Lanes x) {
    const Lanes ax = abs(x), ay = abs(y), one(1.f), zero(0.f);
    const Lanes ratio = min(ax, ay) / max(max(ax, ay), Lanes(1e-30f));
    const Mask wide = ratio > Lanes(0.41421356f);
    const Lanes t = select(wide, (ratio - one) / (ratio + one), ratio), z = t * t;
    Lanes p(-1.f / 15);
    p = p * z + Lanes(1.f / 13);
    p = p * z + Lanes(-1.f / 11);
    p = p * z + Lanes(1.f / 9);
    p = p * z + Lanes(-1.f / 7);
    p = p * z + Lanes(1.f / 5);
    p = p * z + Lanes(-1.f / 3);
    p = p * z + one;
    Lanes angle = p * t + select(wide, Lanes(0.785398163f), zero);
    angle = select(ay > ax, Lanes(1.57079633f) - angle, angle);
    angle = select(x < zero, Lanes(3.14159265f) - angle, angle);
    return select(y < zero, -angle, angle);
}

// Transposes a 16 x 16 matrix in place.
inline void transpose16(Lanes* r) {
#if FASTSCENE_WIDE
    __m512 a[16], b[16];
    for (int i = 0; i < 16; i += 2) {
        a[i] = _mm512_unpacklo_ps(r[i].r, r[i + 1].r);
        a[i + 1] = _mm512_unpackhi_ps(r[i].r, r[i + 1].r);
    }
    for (int i = 0; i < 16; i += 4)
        for (int k = 0; k < 2; ++k) {
            b[i + 2 * k] = _mm512_castpd_ps(
                _mm512_unpacklo_pd(_mm512_castps_pd(a[i + k]), _mm512_castps_pd(a[i + k + 2])));
            b[i + 2 * k + 1] = _mm512_castpd_ps(
                _mm512_unpackhi_pd(_mm512_castps_pd(a[i + k]), _mm512_castps_pd(a[i + k + 2])));
        }
    // b[4 g + c] holds, in its 128-bit quarter q, column 4 q + c of rows 4 g .. 4 g + 3.
    for (int c = 0; c < 4; ++c) {
        const __m512 p = _mm512_shuffle_f32x4(b[c], b[4 + c], 0x88), q = _mm512_shuffle_f32x4(b[c], b[4 + c], 0xdd);
        const __m512 s = _mm512_shuffle_f32x4(b[8 + c], b[12 + c], 0x88),
                     t = _mm512_shuffle_f32x4(b[8 + c], b[12 + c], 0xdd);
        r[c].r = _mm512_shuffle_f32x4(p, s, 0x88);
        r[8 + c].r = _mm512_shuffle_f32x4(p, s, 0xdd);
        r[4 + c].r = _mm512_shuffle_f32x4(q, t, 0x88);
        r[12 + c].r = _mm512_shuffle_f32x4(q, t, 0xdd);
    }
#else
    const auto transpose8 = [](Half* x) {
        Half a[8], b[8];
        constexpr HalfBits lo = {0, 8, 1, 9, 4, 12, 5, 13}, hi = {2, 10, 3, 11, 6, 14, 7, 15};
        constexpr HalfBits lo2 = {0, 1, 8, 9, 4, 5, 12, 13}, hi2 = {2, 3, 10, 11, 6, 7, 14, 15};
        constexpr HalfBits left = {0, 1, 2, 3, 8, 9, 10, 11}, right = {4, 5, 6, 7, 12, 13, 14, 15};
        for (int i = 0; i < 8; i += 2)
            a[i] = __builtin_shuffle(x[i], x[i + 1], lo), a[i + 1] = __builtin_shuffle(x[i], x[i + 1], hi);
        for (int i = 0; i < 8; i += 4)
            for (int k = 0; k < 2; ++k) {
                b[i + 2 * k] = __builtin_shuffle(a[i + k], a[i + k + 2], lo2);
                b[i + 2 * k + 1] = __builtin_shuffle(a[i + k], a[i + k + 2], hi2);
            }
        for (int c = 0; c < 4; ++c) {
            x[c] = __builtin_shuffle(b[c], b[4 + c], left);
            x[4 + c] = __builtin_shuffle(b[c], b[4 + c], right);
        }
    };
    Half q00[8], q01[8], q10[8], q11[8];
    for (int i = 0; i < 8; ++i) q00[i] = r[i].lo, q01[i] = r[i].hi, q10[i] = r[i + 8].lo, q11[i] = r[i + 8].hi;
    transpose8(q00);
    transpose8(q01);
    transpose8(q10);
    transpose8(q11);
    for (int i = 0; i < 8; ++i) r[i] = Lanes(q00[i], q10[i]), r[i + 8] = Lanes(q01[i], q11[i]);
#endif
}

// Input of sums12(): per-lane partial sums over a splat's 16 pixels.
#if FASTSCENE_WIDE
using Summand = Lanes;
#else
using Summand = Half;
#endif
// Horizontal sums: lane i = the sum over all lanes of r[i], i < 12; zero beyond. Each level folds halves and packs two
// sums into one vector: 26 shuffles instead of 48 for 12 sums.
inline Lanes sums12(const Summand* r) {
#if FASTSCENE_WIDE
    // Quarters of the result: a, b = r[i], r[4 + i]; c = r[8 + i]; each still in four parts.
    const auto quarters = [&](int i) {
        const __m512 a = r[i].r, b = r[4 + i].r, c = r[8 + i].r;
        const __m512 ab = _mm512_shuffle_f32x4(a, b, 0x44) + _mm512_shuffle_f32x4(a, b, 0xee);
        const __m512 cc = _mm512_zextps256_ps512(_mm512_castps512_ps256(c) + _mm512_extractf32x8_ps(c, 1));
        return _mm512_shuffle_f32x4(ab, cc, 0x88) + _mm512_shuffle_f32x4(ab, cc, 0xdd);
    };
    const __m512 q0 = quarters(0), q1 = quarters(1), q2 = quarters(2), q3 = quarters(3);
    const __m512d p = _mm512_castps_pd(_mm512_unpacklo_ps(q0, q1) + _mm512_unpackhi_ps(q0, q1));
    const __m512d q = _mm512_castps_pd(_mm512_unpacklo_ps(q2, q3) + _mm512_unpackhi_ps(q2, q3));
    return Lanes(_mm512_castpd_ps(_mm512_unpacklo_pd(p, q)) + _mm512_castpd_ps(_mm512_unpackhi_pd(p, q)));
#else
    constexpr HalfBits low = {0, 1, 2, 3, 8, 9, 10, 11}, high = {4, 5, 6, 7, 12, 13, 14, 15};
    constexpr HalfBits even = {0, 8, 1, 9, 4, 12, 5, 13}, odd = {2, 10, 3, 11, 6, 14, 7, 15};
    constexpr HalfBits left = {0, 1, 8, 9, 4, 5, 12, 13}, right = {2, 3, 10, 11, 6, 7, 14, 15};
    const auto pair = [&](int i, int j) {
        return __builtin_shuffle(r[i], r[j], low) + __builtin_shuffle(r[i], r[j], high);
    };
    const auto woven = [&](Half a, Half b) { return __builtin_shuffle(a, b, even) + __builtin_shuffle(a, b, odd); };
    const Half p = woven(pair(0, 4), pair(1, 5)), q = woven(pair(2, 6), pair(3, 7));
    // The last four: two sums in each half, each still in two parts.
    const Half two = woven(pair(8, 10), pair(9, 11));
    const Half four = two + __builtin_shuffle(two, HalfBits{2, 3, 0, 1, 6, 7, 4, 5});
    return {__builtin_shuffle(p, q, left) + __builtin_shuffle(p, q, right),
            __builtin_shuffle(four, Half{}, HalfBits{0, 1, 4, 5, 8, 9, 10, 11})};
#endif
}
inline void store12(Lanes a, float* p) {
#if FASTSCENE_WIDE
    _mm256_storeu_ps(p, _mm512_castps512_ps256(a.r));
    _mm_storeu_ps(p + 8, _mm512_extractf32x4_ps(a.r, 2));
#else
    __builtin_memcpy(p, &a.lo, 32);
    __builtin_memcpy(p + 8, &a.hi, 16);
#endif
}

// The 16 floats at an aligned address with their neighbours: shifted<k>() is the vector k floats further on, |k| < 16.
struct Neighbours {
    const float* at;
#if FASTSCENE_WIDE
    __m512 before, here, after;
    explicit Neighbours(const float* p)
        : at(p), before(_mm512_load_ps(p - kLanes)), here(_mm512_load_ps(p)), after(_mm512_load_ps(p + kLanes)) {}
    template <int k>
    Lanes shifted() const {
        const auto joined = [](__m512 high, __m512 low) {
            return Lanes(_mm512_castsi512_ps(
                _mm512_alignr_epi32(_mm512_castps_si512(high), _mm512_castps_si512(low), (k + kLanes) % kLanes)));
        };
        if constexpr (k == 0) return Lanes(here);
        else if constexpr (k < 0) return joined(here, before);
        else return joined(after, here);
    }
#elif defined(__AVX2__)
    // Half of the unaligned loads would cross a cache line, at twice the cost: those halves are assembled in registers.
    __m256 before, lo, hi, after, before_lo, hi_after;
    explicit Neighbours(const float* p)
        : at(p),
          before(_mm256_load_ps(p - 8)),
          lo(_mm256_load_ps(p)),
          hi(_mm256_load_ps(p + 8)),
          after(_mm256_load_ps(p + 16)),
          before_lo(_mm256_permute2f128_ps(before, lo, 0x21)),
          hi_after(_mm256_permute2f128_ps(hi, after, 0x21)) {}
    template <int k>
    Lanes shifted() const {
        static_assert(k >= -8 && k <= 8);
        if constexpr (k == 0) return {lo, hi};
        else if constexpr (k < 0) return {joined<k + 8>(before, before_lo, lo), _mm256_loadu_ps(at + 8 + k)};
        else return {_mm256_loadu_ps(at + k), joined<k>(hi, hi_after, after)};
    }

  private:
    // Eight floats from the k-th of `low` and `high` on; `middle` is the upper half of the one and the lower half of
    // the other.
    template <int k>
    static __m256 joined(__m256 low, __m256 middle, __m256 high) {
        const auto shift = []<int bytes>(__m256 b, __m256 a) {
            return _mm256_castsi256_ps(_mm256_alignr_epi8(_mm256_castps_si256(b), _mm256_castps_si256(a), bytes));
        };
        if constexpr (k == 0) return low;
        else if constexpr (k == 4) return middle;
        else if constexpr (k == 8) return high;
        else if constexpr (k < 4) return shift.template operator()<4 * k>(middle, low);
        else return shift.template operator()<4 * (k - 4)>(high, middle);
    }
#else
    explicit Neighbours(const float* p) : at(p) {}
    template <int k>
    Lanes shifted() const {
        return Lanes::load(at + k);
    }
#endif
};

// Flushes denormals to zero during its lifetime: Adam's moments of invisible splats decay into denormals, at a hundred
// cycles each.
class FlushDenormals {
  public:
#if defined(__x86_64__)
    FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040u); }
    ~FlushDenormals() { _mm_setcsr(before_); }

  private:
    unsigned before_;
#endif
};

}  // namespace fastscene::splat::FASTSCENE_ISA
