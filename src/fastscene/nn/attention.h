// Attention on a CPU for large pictures: the L x M weights are computed in tiles that stay in the cache and are never
// stored as a whole (FlashAttention, Dao et al. 2022; online softmax, Milakov and Gimelshein 2018). Accumulates in
// single precision; bfloat16 uses the processor's bfloat16 products where available (attention_bf16.h).
#pragma once

#include <ATen/core/Tensor.h>

namespace fastscene::nn {

// softmax(q k' / sqrt(d)) v for each of n: q [n, L, d], k and v [n, M, d], on a CPU, all float or all bfloat16; returns
// [n, L, d]. No gradients. The result does not depend on the number of threads.
at::Tensor tiled_attention(const at::Tensor& q, const at::Tensor& k, const at::Tensor& v);

}  // namespace fastscene::nn
