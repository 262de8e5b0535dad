// Residual and transformer blocks, shared by the U-Net and the VAE. Private to nn/ (torch).
#pragma once

#include "fastscene/nn/scope.h"

namespace fastscene::nn {

// x [N, C, H, W] + residual -> [N, out, H, W]; `time` [N, D] (undefined in the VAE) is added after the first
// convolution.
at::Tensor resnet(const Scope& s, const at::Tensor& x, std::int64_t out, std::int64_t groups, double eps,
                  const at::Tensor& time = {});

struct TransformerShape {
    std::int64_t heads = 8, groups = 32;
    bool linear_projection = false, in_float = false;
};
// Self-attention, then cross-attention to the text.
at::Tensor transformer(const Scope& s, const at::Tensor& x, const at::Tensor& text, const TransformerShape& shape);

at::Tensor doubled(const at::Tensor& x);  // nearest-neighbour upsampling by 2
at::Tensor resized_nearest(const at::Tensor& x, at::IntArrayRef height_width);

}  // namespace fastscene::nn
