// EGformer's training loss: scale- and shift-invariant depth (Ranftl et al. 2020, "MiDaS", equations 4 to 6 and 11).
// Private to nn/ (torch). All maps are [N, 1, H, W]; `mask` is 1 where the ground truth is known, else 0.
#pragma once

#include <ATen/ATen.h>

namespace fastscene::nn {

// found * scale + shift, with scale and shift fitted per picture to the truth (least squares over the mask). Gradients
// flow through both. For degenerate pictures (empty mask, constant map) scale is 1 and shift 0.
at::Tensor aligned_depth(const at::Tensor& found, const at::Tensor& truth, const at::Tensor& mask);

// Mean |aligned - truth| over the mask.
at::Tensor invariant_loss(const at::Tensor& aligned, const at::Tensor& truth, const at::Tensor& mask);
// Multi-scale gradient matching: horizontal and vertical differences of aligned - truth at four scales, each half as
// fine.
at::Tensor gradient_loss(const at::Tensor& aligned, const at::Tensor& truth, const at::Tensor& mask);
// Our addition: mean |log found - log truth| without alignment. Early in training, alignment shrinks the map to a
// constant and the gradients vanish; this loss does not have that problem, and lets the network learn metric depth
// where the data permit.
at::Tensor direct_loss(const at::Tensor& found, const at::Tensor& truth, const at::Tensor& mask);
// 0.5 invariant + 0.5 gradient, as published.
at::Tensor depth_loss(const at::Tensor& found, const at::Tensor& truth, const at::Tensor& mask);

}  // namespace fastscene::nn
