// L1 + D-SSIM and its gradient for one channel and up to kLossRows rows. SSIM (Wang et al. 2004) with an
// 11x11 Gaussian window, sigma 1.5, zeros outside the picture. With blurred x, y, x^2 + y^2 and x y
// (variances enter SSIM only as their sum: four maps suffice), the window being symmetric,
//   dS/dx = blur(p) + 2 x blur(q) + y blur(r),   p = dS/d(blur x), q = dS/d(blur(x^2 + y^2)), r = dS/d(blur(x y)).
// Blurs run down the columns first (aligned), then along one row that lies in the first-level cache.
#pragma once

#include "fastscene/splat/kernel.h"
#include "fastscene/splat/lanes.h"

namespace fastscene::splat::FASTSCENE_ISA {

inline constexpr int kReach = 5;
inline constexpr int kTaps = 2 * kReach + 1;
inline constexpr int kMargin = 16;  // zeros to the left and right of a scratch row
// exp(-k^2 / (2 1.5^2)), normalized.
inline constexpr float kWindow[kTaps] = {0.00102838f, 0.00759876f, 0.03600077f, 0.10936069f, 0.21300554f, 0.26601172f,
                                         0.21300554f, 0.10936069f, 0.03600077f, 0.00759876f, 0.00102838f};
inline constexpr float kC1 = 0.01f * 0.01f, kC2 = 0.03f * 0.03f;
inline constexpr int kMaps = 4, kScratchRows = kLossRows + 2 * kReach;

alignas(64) inline constexpr float kColumns[kLanes] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

inline std::ptrdiff_t scratch_row(std::ptrdiff_t stride) { return stride + 2 * kMargin; }
inline std::ptrdiff_t loss_scratch(std::ptrdiff_t stride) {
    // Source rows of four maps, one column-blurred row of each, and a row of weights.
    return scratch_row(stride) * (kMaps * kScratchRows + kMaps + 1);
}

// out[x] = sum over taps of window * rows[tap][x], for whole vectors covering `width`; the rest stays 0.
inline void blur_down(const float* const* rows, int width, float* out) {
    for (int x = 0; x < width; x += kLanes) {
        Lanes sum = Lanes::load(rows[0] + x) * Lanes(kWindow[0]);
        for (int k = 1; k < kTaps; ++k) sum += Lanes::load(rows[k] + x) * Lanes(kWindow[k]);
        sum.store(out + x);
    }
}
inline Lanes blur_along(const float* at) {
    Lanes sum = Lanes::load(at - kReach) * Lanes(kWindow[0]);
    for (int k = 1; k < kTaps; ++k) sum += Lanes::load(at - kReach + k) * Lanes(kWindow[k]);
    return sum;
}
inline void target_row(const LossJob& job, int channel, int y, float* out) {
    const std::uint8_t* in = job.target + static_cast<std::ptrdiff_t>(y) * job.width * 3 + channel;
    for (int x = 0; x < job.width; ++x) out[x] = static_cast<float>(in[3 * x]) * (1.f / 255);
}
// Ones (or the view's weights) over the picture's columns, zeros beyond.
inline void weight_row(const LossJob& job, int y, float* out) {
    if (job.weight) {
        const std::uint8_t* in = job.weight + static_cast<std::ptrdiff_t>(y) * job.width;
        for (int x = 0; x < job.width; ++x) out[x] = static_cast<float>(in[x]) * (1.f / 255);
    } else {
        for (int x = 0; x < job.width; ++x) out[x] = 1.f;
    }
}
inline double sum_of(Lanes a) {
    alignas(64) float v[kLanes];
    a.store(v);
    double sum = 0;
    for (const float x : v) sum += x;
    return sum;
}

// First pass: the loss, and p, q, r (times -lambda * weight / values).
inline LossSums loss_statistics(const LossJob& job, int channel, int row_begin, int row_end, float* scratch) {
    const FlushDenormals flush;
    const std::ptrdiff_t row_floats = scratch_row(job.stride);
    const auto source = [&](int map, int row) { return scratch + (map * kScratchRows + row) * row_floats + kMargin; };
    const auto blurred = [&](int map) { return scratch + (kMaps * kScratchRows + map) * row_floats + kMargin; };
    float* const weights = blurred(kMaps);
    __builtin_memset(blurred(0) - kMargin, 0, static_cast<std::size_t>((kMaps + 1) * row_floats) * sizeof(float));
    for (int row = 0; row < row_end - row_begin + 2 * kReach; ++row) {
        const int y = row_begin - kReach + row;
        if (y < 0 || y >= job.height) {
            for (int map = 0; map < kMaps; ++map)
                __builtin_memset(source(map, row), 0, static_cast<std::size_t>(job.stride) * sizeof(float));
            continue;
        }
        float *x1 = source(0, row), *y1 = source(1, row), *squares = source(2, row), *product = source(3, row);
        // The last vector may reach beyond the picture: zeros there.
        if (job.width % kLanes) Lanes(0.f).store(x1 + job.width), Lanes(0.f).store(y1 + job.width);
        __builtin_memcpy(x1, job.color[channel] + y * job.stride, static_cast<std::size_t>(job.width) * sizeof(float));
        target_row(job, channel, y, y1);
        for (int i = 0; i < job.width; i += kLanes) {
            const Lanes a = Lanes::load(x1 + i), b = Lanes::load(y1 + i);
            (a * a + b * b).store(squares + i);
            (a * b).store(product + i);
        }
    }

    const float scale = 1.f / (3.f * static_cast<float>(job.width) * static_cast<float>(job.height));
    LossSums sums;
    for (int y = row_begin; y < row_end; ++y) {
        const float* rows[kTaps];
        for (int map = 0; map < kMaps; ++map) {
            for (int k = 0; k < kTaps; ++k) rows[k] = source(map, y - row_begin + k);
            blur_down(rows, job.width, blurred(map));
        }
        weight_row(job, y, weights);
        Lanes loss, squared;
        const float *x1 = source(0, y - row_begin + kReach), *y1 = source(1, y - row_begin + kReach);
        for (int x = 0; x < job.width; x += kLanes) {
            const Lanes mx = blur_along(blurred(0) + x), my = blur_along(blurred(1) + x);
            const Lanes ss = blur_along(blurred(2) + x), sp = blur_along(blurred(3) + x);
            const Lanes mxmy = mx * my, mm = mx * mx + my * my;
            const Lanes a1 = mxmy + mxmy + Lanes(kC1), a2 = (sp - mxmy) * Lanes(2.f) + Lanes(kC2);
            const Lanes b1 = mm + Lanes(kC1), b2 = ss - mm + Lanes(kC2);
            const Lanes inv_b1 = reciprocal(b1), inv_b2 = reciprocal(b2), inv = inv_b1 * inv_b2;
            const Lanes ssim = a1 * a2 * inv;
            const Lanes w = Lanes::load(weights + x), difference = Lanes::load(x1 + x) - Lanes::load(y1 + x);
            loss += w * (Lanes(1.f - job.lambda) * abs(difference) + Lanes(job.lambda) * (Lanes(1.f) - ssim));
            squared += w * difference * difference;
            const Lanes k = w * Lanes(-job.lambda * scale);
            const Lanes p = Lanes(2.f) * (my * (a2 - a1) * inv - mx * ssim * (inv_b1 - inv_b2));
            const std::ptrdiff_t at = y * job.stride + x;
            (k * p).store(job.p[channel] + at);
            (-(k * ssim * inv_b2)).store(job.q[channel] + at);
            (k * Lanes(2.f) * a1 * inv).store(job.r[channel] + at);
            (w * abs(difference)).store(job.error[channel] + at);
        }
        sums.loss += sum_of(loss) * scale;
        sums.squared_error += sum_of(squared) * scale;
    }
    return sums;
}

// Second pass: dL/d color of the rows, from p, q, r of all rows within reach.
inline void loss_gradient(const LossJob& job, int channel, int row_begin, int row_end, float* scratch) {
    const FlushDenormals flush;
    const std::ptrdiff_t row_floats = scratch_row(job.stride);
    __builtin_memset(scratch, 0, static_cast<std::size_t>(row_floats * 6) * sizeof(float));
    const auto row_at = [&](int i) { return scratch + i * row_floats + kMargin; };
    const float* maps[3] = {job.p[channel], job.q[channel], job.r[channel]};
    const float* zeros = row_at(4);
    float *target = row_at(3), *weights = row_at(5);
    const float scale = (1.f - job.lambda) / (3.f * static_cast<float>(job.width) * static_cast<float>(job.height));
    for (int y = row_begin; y < row_end; ++y) {
        for (int map = 0; map < 3; ++map) {
            const float* rows[kTaps];
            for (int k = 0; k < kTaps; ++k) {
                const int from = y - kReach + k;
                rows[k] = from >= 0 && from < job.height ? maps[map] + from * job.stride : zeros;
            }
            blur_down(rows, job.width, row_at(map));
        }
        target_row(job, channel, y, target);
        weight_row(job, y, weights);
        const float* color = job.color[channel] + y * job.stride;
        float* out = job.v[channel] + y * job.stride;
        for (int x = 0; x < job.width; x += kLanes) {
            const Lanes c = Lanes::load(color + x), t = Lanes::load(target + x), w = Lanes::load(weights + x);
            const Lanes sign = select(c > t, Lanes(1.f), select(c < t, Lanes(-1.f), Lanes(0.f)));
            const Lanes slope = w * Lanes(scale) * sign + blur_along(row_at(0) + x) +
                                Lanes(2.f) * c * blur_along(row_at(1) + x) + t * blur_along(row_at(2) + x);
            const Lanes column = Lanes(static_cast<float>(x)) + Lanes::load(kColumns);
            select(column < Lanes(static_cast<float>(job.width)), slope, Lanes(0.f)).store(out + x);
        }
    }
}

}  // namespace fastscene::splat::FASTSCENE_ISA
