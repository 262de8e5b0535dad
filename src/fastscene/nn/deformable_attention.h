// PanoFormer's attention (Shen et al. 2022): each token takes values from nine points of the tangent patch around it,
// each moved by a learned offset. In single precision on a CPU points are read and mixed one token at a time; anything
// else goes by libtorch's operators. Private to nn/.
#pragma once

#include <ATen/core/Tensor.h>

#include <cstdint>

#include "fastscene/nn/window_attention.h"

namespace fastscene::nn {

inline constexpr std::int64_t kTaps = 9;

// value [N, h w, C], cut into `heads`; offset [N, h w, heads 9 2] moves the points of `patch` [h w, 9, 2], (row,
// column) in tokens; weight [N, h w, heads 9] -> [N, h w, C]. As published: indices go to -1..1 as if corners were
// aligned and are read as if they were not, bilinear, zeros outside.
at::Tensor deformable_mix(const at::Tensor& value, const at::Tensor& offset, const at::Tensor& weight,
                          const at::Tensor& patch, Grid grid, std::int64_t heads);
// The same by libtorch's operators, of any type on any device.
at::Tensor deformable_mix_by_operators(const at::Tensor& value, const at::Tensor& offset, const at::Tensor& weight,
                                       const at::Tensor& patch, Grid grid, std::int64_t heads);

}  // namespace fastscene::nn
