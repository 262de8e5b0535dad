// PanoFormer's attention (Shen et al. 2022): each token gathers values from nine points of its tangent patch, each
// displaced by a learned offset. Single precision on a CPU has a fused implementation; everything else uses libtorch's
// operators. Private to nn/.
#pragma once

#include <ATen/core/Tensor.h>

#include <cstdint>

#include "fastscene/nn/window_attention.h"

namespace fastscene::nn {

inline constexpr std::int64_t kTaps = 9;

// value [N, h w, C], split into `heads`; offset [N, h w, heads 9 2] displaces the points of `patch` [h w, 9, 2], (row,
// column) in tokens; weight [N, h w, heads 9] -> [N, h w, C]. As published: coordinates are normalized with
// align_corners = true but sampled with align_corners = false, bilinear, zero padding.
at::Tensor deformable_mix(const at::Tensor& value, const at::Tensor& offset, const at::Tensor& weight,
                          const at::Tensor& patch, Grid grid, std::int64_t heads);
// The same with libtorch's operators, for any type and device.
at::Tensor deformable_mix_by_operators(const at::Tensor& value, const at::Tensor& offset, const at::Tensor& weight,
                                       const at::Tensor& patch, Grid grid, std::int64_t heads);

}  // namespace fastscene::nn
