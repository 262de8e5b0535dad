// EGformer's attention within one row or one column of an equirectangular grid of tokens (Yun et al. 2023):
// distance-based scores in place of softmax. In single precision on a CPU a window's scores stay in the cache, forwards
// and backwards; anything else goes by libtorch's operators. Private to nn/.
#pragma once

#include <ATen/core/Tensor.h>

#include <cstdint>

namespace fastscene::nn {

// A stage works on a grid of tokens, row-major: [N, height * width, channels].
struct Grid {
    std::int64_t height, width;
};

enum class Windows { rows, columns };

struct WindowAttention {
    at::Tensor said;      // [N, height * width, C]: what each window says to its tokens, heads side by side
    at::Tensor loudness;  // [N, windows]: the mean magnitude of its scores
};

// qkv [N, height * width, 3 C] holds queries, keys and values, each cut into `heads`. Scores are q k' + bias, a token's
// row of them is brought to length 1, and 1 - cos(pi / 2 score) weighs the values. bias [windows or 1, L, L], L tokens
// in a window; it is a constant, no gradient goes there.
WindowAttention window_attention(const at::Tensor& qkv, const at::Tensor& bias, Grid grid, std::int64_t heads,
                                 Windows windows);
// The same by libtorch's operators, of any type on any device.
WindowAttention window_attention_by_operators(const at::Tensor& qkv, const at::Tensor& bias, Grid grid,
                                              std::int64_t heads, Windows windows);

}  // namespace fastscene::nn
