// Small matrix products in registers, the building blocks of tiled and window attention. Private to nn/.
#pragma once

#include <ATen/core/Tensor.h>
#include <ATen/ops/zeros.h>

#include <cstdint>

#include "fastscene/nn/lanes.h"

namespace fastscene::nn {

// AVX-512: 8 rows of 3 vectors, so that 24 of the 32 registers hold accumulators; otherwise 12 of 16
constexpr int kRows = kLanes / 2;

// to [kRows, W vectors] (+)= rows [kRows, depth] panel [depth, W vectors]. `rows` may be transposed, as given by its
// strides.
template <int W, bool add>
void multiply(const float* rows, std::int64_t row_stride, std::int64_t depth_stride, const float* panel,
              std::int64_t panel_stride, std::int64_t depth, float* to, std::int64_t to_stride) {
    Lanes sum[kRows][W];
    for (int r = 0; r < kRows; ++r)
        for (int w = 0; w < W; ++w) sum[r][w] = add ? load(to + r * to_stride + w * kLanes) : Lanes{};
    for (std::int64_t k = 0; k < depth; ++k) {
        Lanes p[W];
        for (int w = 0; w < W; ++w) p[w] = load(panel + k * panel_stride + w * kLanes);
        for (int r = 0; r < kRows; ++r) {
            const Lanes x = all(rows[r * row_stride + k * depth_stride]);
            for (int w = 0; w < W; ++w) sum[r][w] += x * p[w];
        }
    }
    for (int r = 0; r < kRows; ++r)
        for (int w = 0; w < W; ++w) store(to + r * to_stride + w * kLanes, sum[r][w]);
}

inline std::int64_t rounded_up(std::int64_t x, std::int64_t to) { return (x + to - 1) / to * to; }

// Zero-initialized floats with libtorch's alignment, so that vectors never cross cache lines.
class Floats {
  public:
    explicit Floats(std::int64_t count) : memory_(at::zeros({count}, at::kFloat)), data_(memory_.data_ptr<float>()) {}
    float* data() { return data_; }
    const float* data() const { return data_; }
    float* begin() { return data_; }
    float* end() { return data_ + memory_.numel(); }
    float& operator[](std::int64_t i) { return data_[i]; }

  private:
    at::Tensor memory_;
    float* data_;
};

}  // namespace fastscene::nn
