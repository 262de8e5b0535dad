// AOT-GAN's training losses. Pictures are [N, 3, H, W] in -1..1, masks [N, 1, H, W] with 1 = hole. Private to nn/
// (torch).
#pragma once

#include <map>
#include <string>

#include "fastscene/nn/aotgan_net.h"

namespace fastscene::nn {

// ReLU outputs of VGG19 by name, e.g. "relu3_1", up to relu5_2 (torchvision's keys, features.0.weight …).
using Maps = std::map<std::string, at::Tensor>;
Maps vgg19_maps(const Scope& s, const at::Tensor& picture);
// Gram matrices f f' / (c h w): correlations between channels.
at::Tensor gram(const at::Tensor& map);
// L1 distances of relu1_1 … relu5_1, summed.
at::Tensor perceptual_loss(const Maps& a, const Maps& b);
// L1 distances of the Gram matrices of relu2_2, relu3_4, relu4_4, relu5_2, summed.
at::Tensor style_loss(const Maps& a, const Maps& b);

// As in kornia: kernel of `size`, zero padding.
at::Tensor gaussian_blur(const at::Tensor& x, std::int64_t size, double sigma);

struct Adversarial {
    at::Tensor discriminator, generator;
};
// As in the published code (SM-PatchGAN): the discriminator's target is the blurred mask for fake pictures and 0 for
// real ones; the generator's target is 1, the value for "fake", and its weighting by the mask cancels. Kept for
// comparison with the official code.
Adversarial soft_mask_loss_as_published(const Scope& discriminator, std::int64_t width, const at::Tensor& fake,
                                        const at::Tensor& real, const at::Tensor& mask);
// As in the paper (eq. 5-7): targets are 1 for real pictures and the blurred 1 - mask for fake ones; the generator aims
// for 1 in the holes only.
Adversarial soft_mask_loss(const Scope& discriminator, std::int64_t width, const at::Tensor& fake,
                           const at::Tensor& real, const at::Tensor& mask);
// The non-saturating GAN loss.
Adversarial plain_loss(const Scope& discriminator, std::int64_t width, const at::Tensor& fake, const at::Tensor& real);

}  // namespace fastscene::nn
