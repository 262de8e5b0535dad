// AOT-GAN's two networks (Zeng et al., "Aggregated Contextual Transformations for High-Resolution Image Inpainting",
// TVCG 2022), names as in the official checkpoints. Private to nn/ (torch).
#pragma once

#include <vector>

#include "fastscene/nn/scope.h"
#include "fastscene/nn/weights.h"

namespace fastscene::nn {

// The official network has width 64, eight blocks, four rates and no skips; a slim one differs in width alone.
struct AotganShape {
    std::int64_t width = 64;  // channels of the first layer; the middle has four times as many
    std::int64_t blocks = 8;
    std::vector<std::int64_t> rates{1, 2, 4, 8};  // dilations of a block's branches
    // Ours: the decoder sees the encoder's maps of its own size too. Without them every known pixel must come through a
    // quarter of the size, and holes of a pixel's width are painted by guess.
    bool skips = false;
};
// What a checkpoint of the generator holds; `rates` cannot be seen in it: 1, 2, 4 … as many as there are branches,
// unless the metadata say "rates". Throws Error when it is no such checkpoint.
AotganShape aotgan_shape(const Weights& weights);

// picture [N, 3, H, W] in -1..1 with holes at +1 (white), mask [N, 1, H, W] with 1 = hole -> picture in -1..1 (tanh). H
// and W are multiples of 4 and at least 40: reflection at dilation 8 needs 9 rows of the middle.
at::Tensor aotgan_generator(const Scope& s, const AotganShape& shape, const at::Tensor& picture,
                            const at::Tensor& mask);

// Whether a patch is real: [N, 3, H, W] -> [N, 1, H/8 - 2, W/8 - 2]. Its convolutions are divided by their spectral
// norm (Miyato et al. 2018), estimated with the stored vectors u and v; `power_iteration` first improves both, in
// place, as training does at each call.
at::Tensor aotgan_discriminator(const Scope& s, std::int64_t width, const at::Tensor& picture, bool power_iteration);

}  // namespace fastscene::nn
