// EGformer's attention within one row or column of an equirectangular token grid (Yun et al. 2023): distance-based
// weights instead of softmax. Single precision on a CPU has a fused implementation, forward and backward, whose scores
// stay in the cache; everything else uses libtorch's operators. Private to nn/.
#pragma once

#include <ATen/core/Tensor.h>

#include <cstdint>

namespace fastscene::nn {

// A stage's token grid, row-major: [N, height * width, channels].
struct Grid {
    std::int64_t height, width;
};

enum class Windows { rows, columns };

struct WindowAttention {
    at::Tensor said;      // [N, height * width, C]: each window's output for its tokens, heads concatenated
    at::Tensor loudness;  // [N, windows]: mean magnitude of its scores
};

// qkv [N, height * width, 3 C] holds queries, keys and values, each split into `heads`. Scores are q k' + bias; each
// token's row is normalized to length 1, and values are weighted by 1 - cos(pi / 2 score). bias [windows or 1, L, L]
// for L tokens in a window, a constant without gradient.
WindowAttention window_attention(const at::Tensor& qkv, const at::Tensor& bias, Grid grid, std::int64_t heads,
                                 Windows windows);
// The same with libtorch's operators, for any type and device.
WindowAttention window_attention_by_operators(const at::Tensor& qkv, const at::Tensor& bias, Grid grid,
                                              std::int64_t heads, Windows windows);

}  // namespace fastscene::nn
