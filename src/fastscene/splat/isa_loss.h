// L1 + D-SSIM and its gradient for one channel and a band of rows. SSIM (Wang et al. 2004) with an
// 11x11 Gaussian window, sigma 1.5, zeros outside the picture. With blurred x, y, x^2 + y^2 and x y
// (variances enter SSIM only as their sum: four maps suffice), the window being symmetric,
//   dS/dx = blur(p) + x blur(q) + y blur(r),   p = dS/d(blur x), q = 2 dS/d(blur(x^2 + y^2)), r = dS/d(blur(x y)).
// Both blurs run in one sweep down the band, kGroup rows at a time, the second kReach rows behind the first:
// what is alive are rings of 16 rows that stay in the second-level cache, not planes.
#pragma once

#include "fastscene/splat/kernel.h"
#include "fastscene/splat/lanes.h"

namespace fastscene::splat::FASTSCENE_ISA {

inline constexpr int kReach = 5;
inline constexpr int kTaps = 2 * kReach + 1;
inline constexpr int kMargin = 16;  // zero padding on both sides of a scratch row
inline constexpr int kGroup = 4;    // rows blurred at once: each source row is loaded once for all of them
inline constexpr int kRing = 16;    // ring buffer size: kGroup + 2 kReach, rounded up
// exp(-k^2 / (2 1.5^2)), normalized.
inline constexpr float kWindow[kTaps] = {0.00102838f, 0.00759876f, 0.03600077f, 0.10936069f, 0.21300554f, 0.26601172f,
                                         0.21300554f, 0.10936069f, 0.03600077f, 0.00759876f, 0.00102838f};
inline constexpr float kC1 = 0.01f * 0.01f, kC2 = 0.03f * 0.03f;
enum LossMap { kX, kY, kSquares, kProduct, kP, kQ, kR, kLossMaps };

alignas(64) inline constexpr float kColumns[kLanes] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

inline std::ptrdiff_t scratch_row(std::ptrdiff_t stride) { return stride + 2 * kMargin; }

// The scratch memory of one band: ring buffers of rows, the vertically blurred rows, a row of weights, and a sink for
// discarded output.
struct LossScratch {
    float* memory;
    std::ptrdiff_t row_floats;
    float* ring(int map, int y) const { return memory + (map * kRing + (y & (kRing - 1))) * row_floats + kMargin; }
    float* blurred(int map, int i) const {
        return memory + (kLossMaps * kRing + map * kGroup + i) * row_floats + kMargin;
    }
    float* weights() const { return memory + (kLossMaps * kRing + 4 * kGroup) * row_floats + kMargin; }
    float* unused() const { return weights() + row_floats; }
};
inline std::ptrdiff_t loss_scratch(std::ptrdiff_t stride) {
    return scratch_row(stride) * (kLossMaps * kRing + 4 * kGroup + 2);
}

// blurred(out, i) = rows around y + i of `map`, blurred vertically; i < kGroup.
inline void blur_down(const LossScratch& s, int map, int out, int y, int width) {
    const float* rows[kGroup + 2 * kReach];
    for (int k = 0; k < kGroup + 2 * kReach; ++k) rows[k] = s.ring(map, y - kReach + k);
    float* to[kGroup];
    for (int i = 0; i < kGroup; ++i) to[i] = s.blurred(out, i);
#if FASTSCENE_WIDE
    for (int x = 0; x < width; x += kLanes) {
        Lanes sum[kGroup];
#pragma GCC unroll 14
        for (int k = 0; k < kGroup + 2 * kReach; ++k) {
            const Lanes v = Lanes::load(rows[k] + x);
#pragma GCC unroll 4
            for (int i = 0; i < kGroup; ++i)
                if (k - i >= 0 && k - i < kTaps) sum[i] += v * Lanes(kWindow[k - i]);
        }
        for (int i = 0; i < kGroup; ++i) sum[i].store(to[i] + x);
    }
#else
    // Rows at equal distance from the center are added before multiplying, since additions have units of their own.
    // Twelve rows fill the registers; two rows result.
    for (int x = 0; x < width; x += kLanes / 2)
#pragma GCC unroll 2
        for (int first = 0; first < kGroup; first += 2) {
            Half v[2 * kReach + 2];
#pragma GCC unroll 12
            for (int k = 0; k < 2 * kReach + 2; ++k) v[k] = *reinterpret_cast<const Half*>(rows[first + k] + x);
#pragma GCC unroll 2
            for (int i = 0; i < 2; ++i) {
                Half sum = v[i + kReach] * kWindow[kReach];
#pragma GCC unroll 5
                for (int k = 1; k <= kReach; ++k) sum += (v[i + kReach - k] + v[i + kReach + k]) * kWindow[kReach + k];
                *reinterpret_cast<Half*>(to[first + i] + x) = sum;
            }
        }
#endif
}
// `at` is aligned: three loads and shifts are cheaper than eleven loads across cache lines. Symmetric taps are added
// before multiplying, as above.
[[gnu::always_inline]] inline Lanes blur_along(const float* at) {
    const Neighbours n{at};
    const auto pair = [&]<int k>() { return (n.shifted<-k>() + n.shifted<k>()) * Lanes(kWindow[kReach + k]); };
    static_assert(kReach == 5);
    return n.shifted<0>() * Lanes(kWindow[kReach]) + pair.template operator()<1>() + pair.template operator()<2>() +
           pair.template operator()<3>() + pair.template operator()<4>() + pair.template operator()<5>();
}

// One channel of a row of interleaved bytes, as 0..1.
inline void target_row(const LossJob& job, int channel, int y, float* out) {
    const std::uint8_t* in = job.target + static_cast<std::ptrdiff_t>(y) * job.width * 3 + channel;
    int x = 0;
#if defined(__AVX2__)
    // Byte 3 i of the 48 from `in` on: five or six of each third.
    const __m128i pick0 = _mm_setr_epi8(0, 3, 6, 9, 12, 15, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1);
    const __m128i pick1 = _mm_setr_epi8(-1, -1, -1, -1, -1, -1, 2, 5, 8, 11, 14, -1, -1, -1, -1, -1);
    const __m128i pick2 = _mm_setr_epi8(-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 1, 4, 7, 10, 13);
    // The last vector would read up to two bytes past the row, so the loop below handles it.
    for (; x + kLanes < job.width; x += kLanes) {
        const auto third = [&](int i) {
            return _mm_loadu_si128(reinterpret_cast<const __m128i*>(in + 3 * x + 16 * i));
        };
        const __m128i bytes = _mm_or_si128(
            _mm_shuffle_epi8(third(0), pick0),
            _mm_or_si128(_mm_shuffle_epi8(third(1), pick1), _mm_shuffle_epi8(third(2), pick2)));
        const __m256 scale = _mm256_set1_ps(1.f / 255);
        _mm256_storeu_ps(out + x, _mm256_mul_ps(_mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(bytes)), scale));
        _mm256_storeu_ps(out + x + 8,
                         _mm256_mul_ps(_mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(_mm_srli_si128(bytes, 8))), scale));
    }
#endif
    for (; x < job.width; ++x) out[x] = static_cast<float>(in[3 * x]) * (1.f / 255);
}
inline void weight_row(const LossJob& job, int y, float* out) {
    const float all = job.row_weight ? job.row_weight[y] : 1.f;
    const std::uint8_t* in = job.weight ? job.weight + static_cast<std::ptrdiff_t>(y) * job.width : nullptr;
    for (int x = 0; x < job.width; ++x) out[x] = in ? static_cast<float>(in[x]) * (all * (1.f / 255)) : all;
}
inline double sum_of(Lanes a) {
    alignas(64) float v[kLanes];
    a.store(v);
    double sum = 0;
    for (const float x : v) sum += x;
    return sum;
}

// Row y of the four maps to blur; zeros outside the picture.
inline void source_row(const LossJob& job, const LossScratch& s, int channel, int y) {
    float *x1 = s.ring(kX, y), *y1 = s.ring(kY, y), *squares = s.ring(kSquares, y), *product = s.ring(kProduct, y);
    if (y < 0 || y >= job.height) {
        for (float* row : {x1, y1, squares, product})
            __builtin_memset(row, 0, static_cast<std::size_t>(job.stride) * sizeof(float));
        return;
    }
    __builtin_memcpy(x1, job.color[channel] + y * job.stride, static_cast<std::size_t>(job.width) * sizeof(float));
    // Zeroes the right margin, which the last vector's blur reads.
    Lanes(0.f).store(x1 + job.width), Lanes(0.f).store(y1 + job.width);
    target_row(job, channel, y, y1);
    for (int i = 0; i < job.width; i += kLanes) {
        const Lanes a = Lanes::load(x1 + i), b = Lanes::load(y1 + i);
        (a * a + b * b).store(squares + i);
        (a * b).store(product + i);
    }
}

// Sums over a row, per lane: weight * |difference|, weight * (1 - SSIM), weight * difference^2.
struct RowSums {
    Lanes size, dissimilarity, squared;
};

// From the vertically blurred maps: SSIM of row y, and p, q, r (times -lambda * weight / values) into their ring
// buffers. Rows next to a band are computed by the same code, so that they round identically; `error` may be
// s.unused().
inline RowSums statistics_row(const LossJob& job, const LossScratch& s, int y, int i, float* error) {
    const float *x1 = s.ring(kX, y), *y1 = s.ring(kY, y), *weights = s.weights();
    float *p_out = s.ring(kP, y), *q_out = s.ring(kQ, y), *r_out = s.ring(kR, y);
    RowSums sums;
    const Lanes twice(-2 * job.lambda / (3.f * static_cast<float>(job.width) * static_cast<float>(job.height)));
    for (int x = 0; x < job.width; x += kLanes) {
        const Lanes mx = blur_along(s.blurred(0, i) + x), my = blur_along(s.blurred(1, i) + x);
        const Lanes ss = blur_along(s.blurred(2, i) + x), sp = blur_along(s.blurred(3, i) + x);
        // SSIM = a1 a2 / (b1 b2), and its derivatives with the common factors extracted: one reciprocal for all.
        const Lanes mxmy = mx * my, mm = mx * mx + my * my;
        const Lanes a1 = mxmy * Lanes(2.f) + Lanes(kC1), a2 = (sp - mxmy) * Lanes(2.f) + Lanes(kC2);
        const Lanes b1 = mm + Lanes(kC1), b2 = ss - mm + Lanes(kC2);
        const Lanes inv = reciprocal(b1 * b2), ssim = a1 * a2 * inv;
        const Lanes w = Lanes::load(weights + x), k = w * twice * inv;
        (k * (my * (a2 - a1) - mx * ssim * (b2 - b1))).store(p_out + x);
        (-(k * b1 * ssim)).store(q_out + x);
        (k * a1).store(r_out + x);
        const Lanes difference = abs(Lanes::load(x1 + x) - Lanes::load(y1 + x)), size = w * difference;
        sums.size += size;
        sums.dissimilarity += w - w * ssim;
        sums.squared += size * difference;
        size.store(error + x);
    }
    return sums;
}

// From the vertically blurred p, q, r: dL/d color of row y.
inline void gradient_row(const LossJob& job, const LossScratch& s, int channel, int y, int i) {
    const float *x1 = s.ring(kX, y), *y1 = s.ring(kY, y), *weights = s.weights();
    const Lanes scale((1.f - job.lambda) / (3.f * static_cast<float>(job.width) * static_cast<float>(job.height)));
    float* out = job.v[channel] + y * job.stride;
    for (int x = 0; x < job.width; x += kLanes) {
        const Lanes c = Lanes::load(x1 + x), t = Lanes::load(y1 + x), size = Lanes::load(weights + x) * scale;
        (signed_like(c - t, size) + blur_along(s.blurred(0, i) + x) + c * blur_along(s.blurred(1, i) + x) +
         t * blur_along(s.blurred(2, i) + x))
            .store(out + x);
    }
    const std::ptrdiff_t end = (job.width + kLanes - 1) / kLanes *
                               kLanes;  // the last vector wrote past the picture: reset
    __builtin_memset(out + job.width, 0, static_cast<std::size_t>(end - job.width) * sizeof(float));
}

inline void loss_band(const LossJob& job, int channel, int row_begin, int row_end, float* scratch) {
    const FlushDenormals flush;
    const LossScratch s{scratch, scratch_row(job.stride)};
    // Zeros beside the rows; everything else is written before it is read.
    const std::ptrdiff_t inside = job.width / kLanes * kLanes;
    for (float* row = scratch; row != scratch + loss_scratch(job.stride); row += s.row_floats) {
        __builtin_memset(row, 0, kMargin * sizeof(float));
        __builtin_memset(row + kMargin + inside, 0,
                         static_cast<std::size_t>(s.row_floats - kMargin - inside) * sizeof(float));
    }
    const bool weighted = job.weight || job.row_weight;
    if (!weighted)  // ones within the picture's columns, zeros beyond
        for (int x = 0; x < job.width; ++x) s.weights()[x] = 1.f;
    const double lambda = static_cast<double>(job.lambda);
    const float scale = 1.f / (3.f * static_cast<float>(job.width) * static_cast<float>(job.height));
    // Aligned so that the rows finished in each iteration, from y - kReach on, start at row_begin.
    const int first = row_begin + kReach - 3 * kGroup;
    for (int row = first - kReach; row < first + kReach; ++row) source_row(job, s, channel, row);
    for (int y = first; y - kReach < row_end; y += kGroup) {
        for (int row = y + kReach; row < y + kReach + kGroup; ++row) source_row(job, s, channel, row);
        for (int map = 0; map < 4; ++map) blur_down(s, map, map, y, job.width);
        for (int i = 0; i < kGroup; ++i) {
            const int row = y + i;
            if (row < 0 || row >= job.height) {
                for (const int map : {kP, kQ, kR})
                    __builtin_memset(s.ring(map, row), 0, static_cast<std::size_t>(job.stride) * sizeof(float));
                continue;
            }
            if (weighted) weight_row(job, row, s.weights());
            const bool own = row >= row_begin && row < row_end;
            float* const error = own && job.error[channel] ? job.error[channel] + row * job.stride : s.unused();
            const RowSums of_row = statistics_row(job, s, row, i, error);
            if (!own) continue;
            job.row_sums[channel][row] = {
                ((1 - lambda) * sum_of(of_row.size) + lambda * sum_of(of_row.dissimilarity)) * scale,
                sum_of(of_row.squared) * scale};
        }
        const int done = y - kReach;
        if (done < row_begin) continue;
        for (int map = 0; map < 3; ++map) blur_down(s, kP + map, map, done, job.width);
        for (int row = done; row < done + kGroup && row < row_end; ++row) {
            if (weighted) weight_row(job, row, s.weights());
            gradient_row(job, s, channel, row, row - done);
        }
    }
}

}  // namespace fastscene::splat::FASTSCENE_ISA
