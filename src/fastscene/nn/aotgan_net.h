// AOT-GAN's two networks (Zeng et al., "Aggregated Contextual Transformations for High-Resolution Image Inpainting",
// TVCG 2022), names as in the official checkpoints. Private to nn/ (torch).
#pragma once

#include <vector>

#include "fastscene/nn/scope.h"
#include "fastscene/weights/weights.h"

namespace fastscene::nn {

// The official network has width 64, eight blocks, four rates and no skips; slim variants differ in width only.
struct AotganShape {
    std::int64_t width = 64;  // channels of the first layer; the middle layers have four times as many
    std::int64_t blocks = 8;
    std::vector<std::int64_t> rates{1, 2, 4, 8};  // dilations of a block's branches
    // Our extension: skip connections from encoder to decoder at equal resolution. Without them all known pixels pass
    // through a quarter of the resolution, and holes one pixel wide are poorly filled.
    bool skips = false;
};
// The shape of a generator checkpoint. The file does not reveal `rates`: they are 1, 2, 4 … for the number of branches,
// unless the metadata contains "rates". Throws Error if it is not such a checkpoint.
AotganShape aotgan_shape(const Weights& weights);

// picture [N, 3, H, W] in -1..1 with holes at +1 (white), mask [N, 1, H, W] with 1 = hole -> picture in -1..1 (tanh). H
// and W are multiples of 4 and at least 40: reflection padding at dilation 8 needs 9 rows at a quarter of the size.
at::Tensor aotgan_generator(const Scope& s, const AotganShape& shape, const at::Tensor& picture,
                            const at::Tensor& mask);

// PatchGAN discriminator: [N, 3, H, W] -> [N, 1, H/8 - 2, W/8 - 2]. Its convolutions are spectrally normalized (Miyato
// et al. 2018) with the stored vectors u and v; `power_iteration` updates them in place first, as in training.
at::Tensor aotgan_discriminator(const Scope& s, std::int64_t width, const at::Tensor& picture, bool power_iteration);

}  // namespace fastscene::nn
