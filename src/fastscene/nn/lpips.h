// LPIPS 0.1 (Zhang et al. 2018): perceptual distance between pictures by a network trained on ImageNet. Backbone keys
// as in torchvision (features.N), linear heads as in the authors' files (lin0.model.1 …). Private to nn/ (torch).
#pragma once

#include <vector>

#include "fastscene/nn/scope.h"

namespace fastscene::nn {

enum class LpipsNet { alex, vgg };

struct Lpips {
    at::Tensor distance;                 // [N]
    std::vector<at::Tensor> layers;      // five tensors [N]; their sum is the distance
    at::Tensor map;                      // [N, 1, H, W]: sum of the layers' maps, upsampled
    std::vector<at::Tensor> first_maps;  // the backbone's five feature maps of `a`
};
// a, b [N, 3, H, W] in [-1, 1], at least 32 x 32.
Lpips lpips(const Scope& backbone, const Scope& heads, LpipsNet net, const at::Tensor& a, const at::Tensor& b);

}  // namespace fastscene::nn
