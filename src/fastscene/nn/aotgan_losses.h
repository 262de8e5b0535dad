// What AOT-GAN is trained against. Pictures are [N, 3, H, W] in -1..1, masks [N, 1, H, W] with 1 = hole. Private to nn/
// (torch).
#pragma once

#include <map>
#include <string>

#include "fastscene/nn/aotgan_net.h"

namespace fastscene::nn {

// Rectified outputs of VGG19 (torchvision's keys, features.0.weight …) by name: "relu3_1". As far as relu5_2.
using Maps = std::map<std::string, at::Tensor>;
Maps vgg19_maps(const Scope& s, const at::Tensor& picture);
// f f' / (c h w) of each picture: which features come together, wherever they do.
at::Tensor gram(const at::Tensor& map);
// Mean absolute differences of relu1_1 … relu5_1, summed.
at::Tensor perceptual_loss(const Maps& a, const Maps& b);
// Of the Gram matrices of relu2_2, relu3_4, relu4_4, relu5_2, summed.
at::Tensor style_loss(const Maps& a, const Maps& b);

// As kornia's: kernel of `size`, zeros outside.
at::Tensor gaussian_blur(const at::Tensor& x, std::int64_t size, double sigma);

struct Adversarial {
    at::Tensor discriminator, generator;
};
// The published code (SM-PatchGAN): the discriminator says where a picture is made up (softened mask) and 0 for a real
// one; the generator is pushed to 1, which is "made up", and its weighting by the mask cancels. Kept for comparison
// with the official code.
Adversarial soft_mask_loss_as_published(const Scope& discriminator, std::int64_t width, const at::Tensor& fake,
                                        const at::Tensor& real, const at::Tensor& mask);
// The paper's formula (eq. 5-7): real 1; made up = softened 1 - mask; the generator reaches for 1 in the holes, and
// only there.
Adversarial soft_mask_loss(const Scope& discriminator, std::int64_t width, const at::Tensor& fake,
                           const at::Tensor& real, const at::Tensor& mask);
// The plain non-saturating loss.
Adversarial plain_loss(const Scope& discriminator, std::int64_t width, const at::Tensor& fake, const at::Tensor& real);

}  // namespace fastscene::nn
