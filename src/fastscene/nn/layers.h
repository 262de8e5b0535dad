// Layers shared by the networks, with PyTorch's semantics. Each reads its parameters from `s` and reports its output to
// s's listener. Private to nn/ (torch).
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
at::Tensor group_norm_silu(const Scope& s, const at::Tensor& x, std::int64_t groups, double eps);
// Half of the last dimension, gated by the other half through GELU.
at::Tensor gated_gelu(const at::Tensor& x);
// Exact GELU (by erf), with a correct gradient in any memory layout, unlike libtorch's own (gelu.cc).
at::Tensor exact_gelu(const at::Tensor& x);
// Over the last dimension.
at::Tensor layer_norm(const Scope& s, const at::Tensor& x, double eps = 1e-5);

// softmax(q k' / sqrt(d)) v for q [N, L, heads d], k and v [N, M, heads d], in blocks of 256 rows of q, so that the L x
// M weights need not be in memory at once; tiled (attention.h) on a CPU without mask and gradients. `mask` [L, M], if
// defined, is added to the scores. `in_float`: computes weights in single precision whatever the type of q.
at::Tensor attention(const at::Tensor& q, const at::Tensor& k, const at::Tensor& v, std::int64_t heads,
                     const at::Tensor& mask = {}, bool in_float = false);

// x sigmoid(1.702 x). If x is moved in and not shared, works in place (without gradients, floats on a CPU).
at::Tensor quick_gelu(at::Tensor x);

}  // namespace fastscene::nn
