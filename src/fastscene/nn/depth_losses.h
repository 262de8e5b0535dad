// The loss that EGformer was trained with: depth up to scale and shift (Ranftl et al. 2020, "MiDaS", equations 4 to 6
// and 11). Private to nn/ (torch). All maps are [N, 1, H, W]; `mask` is 1 where the truth is known, else 0.
#pragma once

#include <ATen/ATen.h>

namespace fastscene::nn {

// found * scale + shift, each picture with the two numbers that bring it closest to the truth (least squares over its
// mask). Gradients pass through the two numbers. A picture without anything to fit to (an empty mask, a constant map)
// keeps scale 1 and shift 0.
at::Tensor aligned_depth(const at::Tensor& found, const at::Tensor& truth, const at::Tensor& mask);

// Mean |aligned - truth| over the masks.
at::Tensor invariant_loss(const at::Tensor& aligned, const at::Tensor& truth, const at::Tensor& mask);
// Of the same difference, changes to the right and downward at four scales, each half as fine: edges lie where the
// truth has them.
at::Tensor gradient_loss(const at::Tensor& aligned, const at::Tensor& truth, const at::Tensor& mask);
// Ours, beside the published ones: mean |log found - log truth|, nothing aligned. While a network knows next to
// nothing, alignment shrinks its map to a constant, and with it all gradients; this loss does not, and lets the network
// say metres where its rooms allow that.
at::Tensor direct_loss(const at::Tensor& found, const at::Tensor& truth, const at::Tensor& mask);
// 0.5 invariant and 0.5 gradient, as published.
at::Tensor depth_loss(const at::Tensor& found, const at::Tensor& truth, const at::Tensor& mask);

}  // namespace fastscene::nn
