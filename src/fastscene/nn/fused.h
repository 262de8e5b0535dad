// Layers in one kernel of ours on a graphics card (kernels.h). Each returns an undefined tensor where there is none for
// its input: on a CPU, with gradients, in a build without CUDA's compiler, with FASTSCENE_CUDA_KERNELS=0. Private to
// nn/ (torch).
#pragma once

#include <ATen/core/Tensor.h>

namespace fastscene::nn {

// Group norm of x [N, C, H, W], through SiLU if `silu`; the result lies channels last.
at::Tensor fused_group_norm(const at::Tensor& x, const at::Tensor& weight, const at::Tensor& bias, std::int64_t groups,
                            double eps, bool silu);
// a * gelu(b) for x = [..., a b].
at::Tensor fused_gated_gelu(const at::Tensor& x);

}  // namespace fastscene::nn
