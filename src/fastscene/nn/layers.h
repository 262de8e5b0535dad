// The layers that the networks share, with PyTorch's meaning. Each takes its parameters from `s` and tells s's listener
// its output. Private to nn/ (torch).
#pragma once

#include "fastscene/nn/scope.h"

namespace fastscene::nn {

struct Conv {
    std::int64_t kernel = 3, stride = 1, pad = 1;
    bool bias = true;
};
// x [N, C, H, W] -> [N, out, H', W'].
at::Tensor conv(const Scope& s, const at::Tensor& x, std::int64_t out, Conv shape = {});
// x [..., C] -> [..., out].
at::Tensor linear(const Scope& s, const at::Tensor& x, std::int64_t out, bool bias = true);
at::Tensor group_norm(const Scope& s, const at::Tensor& x, std::int64_t groups, double eps);
// By erf. With a gradient that is right in any layout, which libtorch's own is not (gelu.cc).
at::Tensor exact_gelu(const at::Tensor& x);
// Over the last dimension.
at::Tensor layer_norm(const Scope& s, const at::Tensor& x, double eps = 1e-5);

// softmax(q k' / sqrt(d)) v for q [N, L, heads d], k and v [N, M, heads d], 256 rows of q at a time, so that the L x M
// weights of a large picture need not be in memory at once; on a CPU, without a mask and without gradients, by tiles
// (attention.h). `mask` [L, M] is added to the weights if defined. `in_float`: weights in single precision whatever the
// type of q.
at::Tensor attention(const at::Tensor& q, const at::Tensor& k, const at::Tensor& v, std::int64_t heads,
                     const at::Tensor& mask = {}, bool in_float = false);

// x sigmoid(1.702 x). Who moves x in, and nobody else holds it, has it in x's own memory (without gradients, floats on
// a CPU).
at::Tensor quick_gelu(at::Tensor x);

}  // namespace fastscene::nn
