// Attention of large pictures on a CPU: the L x M weights are never in memory, only a tile of them that stays in the
// cache (Dao et al. 2022, FlashAttention; Milakov and Gimelshein 2018 for the softmax in one pass). Single precision
// inside; bfloat16 goes through the processor's own products of such numbers where it has them (attention_bf16.h).
#pragma once

#include <ATen/core/Tensor.h>

namespace fastscene::nn {

// softmax(q k' / sqrt(d)) v for each of n: q [n, L, d], k and v [n, M, d], on a CPU, all float or all bfloat16; returns
// [n, L, d]. No gradients. The same numbers for any number of threads.
at::Tensor tiled_attention(const at::Tensor& q, const at::Tensor& k, const at::Tensor& v);

}  // namespace fastscene::nn
