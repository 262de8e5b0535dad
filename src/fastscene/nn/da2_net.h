// DA-2 as a function of its weights: SphereViT for panoramic depth (Li et al., "DA^2: Depth Anything in Any Direction",
// 2025). Private to nn/ (torch).
#pragma once

#include <cstdint>

#include "fastscene/nn/dinov2.h"
#include "fastscene/nn/scope.h"
#include "fastscene/nn/sphere_embedding.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {

// The published network. Smaller ones have the same structure; tests have some.
struct Da2Shape {
    DinoShape dino;
    std::int64_t features = 512;  // channels of the head; a multiple of 64, the width of an attention head
};

// Parameters that the network asks for.
NamedShapes da2_parameters(const Da2Shape& shape);
// Parameters of the published file that nothing is computed from: of training, and of a confidence.
NamedShapes da2_unused(const Da2Shape& shape);

// What the published code reads from configs/infer.json.
struct Da2Config {
    double min_pixels = 580000, max_pixels = 620000;  // that the network sees, before rounding up to whole patches
    SphereSize sphere{1092, 546};                     // of a picture that is not resized
};

// How large the network sees a picture, and how large the sphere is to it.
struct Da2Size {
    std::int64_t height, width;
    SphereSize sphere;
};
Da2Size da2_size(std::int64_t height, std::int64_t width, const Da2Config& config = {});

// color [1, 3, H, W], sRGB in 0..1 -> [1, 1, H', W'] of the size the network sees: the logarithm of the distance along
// each ray, up to one summand. `size` is da2_size of the picture or any other with whole patches. bf16: rounds the
// products of all but the last layers to bfloat16.
at::Tensor da2_log_distance(const Scope& root, const Da2Shape& shape, const at::Tensor& color, const Da2Size& size,
                            bool bf16 = false);
// The same with the published post-processing: distances [1, H, W] of the picture's size, of which 2 % exceed 1.
at::Tensor da2(const Scope& root, const Da2Shape& shape, const at::Tensor& color, const Da2Config& config = {},
               bool bf16 = false);

}  // namespace fastscene::nn
