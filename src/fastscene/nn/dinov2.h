// DINOv2's vision transformer (Oquab et al. 2023) as DA-2 runs it: features of four of its blocks. Private to nn/
// (torch).
#pragma once

#include <array>

#include "fastscene/nn/scope.h"

namespace fastscene::nn {

// ViT-L/14 without registers.
struct DinoShape {
    std::int64_t width = 1024, blocks = 24;
};
inline constexpr std::int64_t kDinoPatch = 14;      // pixels, each way
inline constexpr std::int64_t kDinoHeadWidth = 64;  // of an attention head

// picture [1, 3, 14 rows, 14 columns], normalized -> four maps [1, rows, columns, width], shallow to deep, the last of
// the last block. `root` is where "dino" lies. Differs from the original DINOv2, as DA-2's weights were trained: layer
// norms have eps 1e-5, the position table is resampled to the grid's size by plain bicubic interpolation.
std::array<at::Tensor, 4> dino_features(const Scope& root, const DinoShape& shape, const at::Tensor& picture);

}  // namespace fastscene::nn
