// DA-2's head: features of the backbone and viewing angles -> the logarithm of distance. Private to nn/ (torch).
#pragma once

#include <array>

#include "fastscene/nn/scope.h"

namespace fastscene::nn {

// maps: four of [1, h, w, C], shallow to deep; embedding [1, h w, features] (sphere_embedding.h). Returns
// [1, 1, height, width]. `root` is where "vit_w_esphere" lies. bf16: products of all but the last layers are rounded
// to bfloat16; in those, rounding would be steps of the distance.
at::Tensor da2_head(const Scope& root, std::int64_t features, const std::array<at::Tensor, 4>& maps,
                    const at::Tensor& embedding, std::int64_t height, std::int64_t width, bool bf16 = false);

}  // namespace fastscene::nn
