#include "fastscene/nn/attention.h"

#include <ATen/Parallel.h>
#include <ATen/ops/empty.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/check.h"
#include "fastscene/nn/attention_bf16.h"
#include "fastscene/nn/lane_products.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

constexpr int kVectors = 3, kPanel = kVectors * kLanes;

constexpr std::int64_t kTileRows = 8 * kRows;  // rows of q: their part of the weights is 64 x 480 floats, 123 KB
constexpr std::int64_t kTileKeys = 10 * 48;
static_assert(kTileKeys % kPanel == 0);

// Keys in panels of kPanel: [panel][d][kPanel]. Values in rows padded to whole vectors: [M][wide]. Padding is zero.
struct Packed {
    Floats keys, values;
    std::int64_t wide;
};
Packed packed(const float* k, const float* v, std::int64_t m, std::int64_t d) {
    const std::int64_t padded = rounded_up(m, kPanel), wide = rounded_up(d, kLanes);
    Packed out{Floats(padded * d), Floats(padded * wide), wide};
    for (std::int64_t j = 0; j < m; ++j) {
        float* key = out.keys.data() + j / kPanel * kPanel * d + j % kPanel;
        for (std::int64_t i = 0; i < d; ++i) key[i * kPanel] = k[j * d + i];
        std::copy_n(v + j * d, d, out.values.data() + j * out.wide);
    }
    return out;
}

// A thread's scratch memory.
struct Bench {
    Floats q, weights, sum;
    Floats greatest, total;  // running maximum and sum of each row
    Bench(std::int64_t d, std::int64_t wide)
        : q(kTileRows * d),
          weights(kTileRows * kTileKeys),
          sum(kTileRows * wide),
          greatest(kTileRows),
          total(kTileRows) {}
};

// Online softmax: turns a row of scores into weights relative to the running maximum, and rescales earlier sums when
// the maximum grows.
void weigh(Bench& b, std::int64_t row, std::int64_t keys, std::int64_t padded, std::int64_t wide) {
    float* s = b.weights.data() + row * kTileKeys;
    std::fill(s + keys, s + padded, -std::numeric_limits<float>::infinity());
    Lanes most = load(s);
    for (std::int64_t i = kLanes; i < padded; i += kLanes) {
        const Lanes x = load(s + i);
        most = x > most ? x : most;
    }
    float greatest = b.greatest[row];
    for (int i = 0; i < kLanes; ++i) greatest = std::max(greatest, most[i]);
    const float shrink = std::exp(b.greatest[row] - greatest);
    b.greatest[row] = greatest;
    Lanes total{};
    for (std::int64_t i = 0; i < padded; i += kLanes) {
        const Lanes w = exp_of(load(s + i) - all(greatest));
        store(s + i, w);
        total += w;
    }
    float sum = b.total[row] * shrink;
    for (int i = 0; i < kLanes; ++i) sum += total[i];
    b.total[row] = sum;
    if (shrink != 1.f)
        for (std::int64_t i = 0; i < wide; i += kLanes)
            store(b.sum.data() + row * wide + i, load(b.sum.data() + row * wide + i) * all(shrink));
}

void add_values(Bench& b, std::int64_t row, const float* values, std::int64_t keys, std::int64_t wide) {
    const float* weights = b.weights.data() + row * kTileKeys;
    float* to = b.sum.data() + row * wide;
    std::int64_t at = 0;
    for (; at + kPanel <= wide; at += kPanel)
        multiply<kVectors, true>(weights, kTileKeys, 1, values + at, wide, keys, to + at, wide);
    if (wide - at == 2 * kLanes) multiply<2, true>(weights, kTileKeys, 1, values + at, wide, keys, to + at, wide);
    if (wide - at == kLanes) multiply<1, true>(weights, kTileKeys, 1, values + at, wide, keys, to + at, wide);
}

// `count` rows of q (at most kTileRows) against all keys.
void tile(const float* q, std::int64_t count, const Packed& p, std::int64_t m, std::int64_t d, Bench& b, float* out) {
    const float scale = 1 / std::sqrt(static_cast<float>(d));
    std::fill(b.q.begin(), b.q.end(), 0.f);
    std::transform(q, q + count * d, b.q.begin(), [scale](float x) { return x * scale; });
    std::fill(b.sum.begin(), b.sum.end(), 0.f);
    std::fill(b.greatest.begin(), b.greatest.end(), -std::numeric_limits<float>::infinity());
    std::fill(b.total.begin(), b.total.end(), 0.f);
    const std::int64_t rows = rounded_up(count, kRows);
    for (std::int64_t from = 0; from < m; from += kTileKeys) {
        const std::int64_t keys = std::min(kTileKeys, m - from), padded = rounded_up(keys, kPanel);
        for (std::int64_t j = 0; j < padded; j += kPanel)
            for (std::int64_t row = 0; row < rows; row += kRows)
                multiply<kVectors, false>(b.q.data() + row * d, d, 1, p.keys.data() + (from + j) * d, kPanel, d,
                                          b.weights.data() + row * kTileKeys + j, kTileKeys);
        for (std::int64_t row = 0; row < rows; ++row) weigh(b, row, keys, padded, p.wide);
        for (std::int64_t row = 0; row < rows; row += kRows)
            add_values(b, row, p.values.data() + from * p.wide, keys, p.wide);
    }
    for (std::int64_t row = 0; row < count; ++row)
        for (std::int64_t i = 0; i < d; ++i) out[row * d + i] = b.sum[row * p.wide + i] / b.total[row];
}

Tensor through_bf16(const Tensor& q, const Tensor& k, const Tensor& v) {
    constexpr std::int64_t kAtOnce = 4 * bf16::kRows;
    const std::int64_t l = q.size(1), m = k.size(1), d = q.size(2), tiles = (l + kAtOnce - 1) / kAtOnce;
    const auto numbers = [](const Tensor& x) { return reinterpret_cast<bf16::Bf16*>(x.data_ptr<at::BFloat16>()); };
    const Tensor out = at::empty(q.sizes(), q.options()), keys = at::empty({bf16::packed_keys(m, d)}, q.options()),
                 values = at::empty({bf16::packed_values(m, d)}, q.options());
    for (std::int64_t i = 0; i < q.size(0); ++i) {
        bf16::pack(numbers(k) + i * m * d, numbers(v) + i * m * d, m, d, numbers(keys), numbers(values));
        at::parallel_for(0, tiles, 1, [&](std::int64_t begin, std::int64_t end) {
            const Tensor work = at::empty({static_cast<std::int64_t>(bf16::workspace(d))},
                                          at::kByte);  // libtorch aligns to 64 bytes
            const std::int64_t from = begin * kAtOnce, to = std::min(end * kAtOnce, l);
            bf16::attend(numbers(q) + (i * l + from) * d, to - from, numbers(keys), numbers(values), m, d,
                         reinterpret_cast<std::byte*>(work.data_ptr()), numbers(out) + (i * l + from) * d);
        });
    }
    return out;
}

}  // namespace

Tensor tiled_attention(const Tensor& q, const Tensor& k, const Tensor& v) {
    FASTSCENE_CHECK(q.dim() == 3 && k.sizes() == v.sizes() && q.size(0) == k.size(0) && q.size(2) == k.size(2) &&
                    k.size(1) > 0);
    FASTSCENE_CHECK(q.scalar_type() == k.scalar_type() && k.scalar_type() == v.scalar_type() && q.device().is_cpu());
    if (q.scalar_type() == at::kBFloat16) {
        if (bf16::available()) return through_bf16(q.contiguous(), k.contiguous(), v.contiguous());
        return tiled_attention(q.to(at::kFloat), k.to(at::kFloat), v.to(at::kFloat)).to(at::kBFloat16);
    }
    FASTSCENE_CHECK(q.scalar_type() == at::kFloat);
    const Tensor rows = q.contiguous(), keys = k.contiguous(), values = v.contiguous();
    const std::int64_t n = q.size(0), l = q.size(1), m = k.size(1), d = q.size(2),
                       tiles = (l + kTileRows - 1) / kTileRows;
    Tensor out = at::empty(q.sizes(), rows.options());
    for (std::int64_t i = 0; i < n; ++i) {
        const Packed p = packed(keys.data_ptr<float>() + i * m * d, values.data_ptr<float>() + i * m * d, m, d);
        const float* from = rows.data_ptr<float>() + i * l * d;
        float* to = out.data_ptr<float>() + i * l * d;
        at::parallel_for(0, tiles, 1, [&](std::int64_t begin, std::int64_t end) {
            Bench bench(d, p.wide);
            for (std::int64_t t = begin; t < end; ++t)
                tile(from + t * kTileRows * d, std::min(kTileRows, l - t * kTileRows), p, m, d, bench,
                     to + t * kTileRows * d);
        });
    }
    return out;
}

}  // namespace fastscene::nn
