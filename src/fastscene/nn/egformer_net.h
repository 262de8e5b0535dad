// EGformer as a function of its weights: equirectangular geometry-biased transformer for panoramic depth (Yun, Lee,
// Rhee, ICCV 2023). Private to nn/ (torch).
#pragma once

#include <array>

#include "fastscene/nn/egformer.h"
#include "fastscene/nn/scope.h"

namespace fastscene::nn {

// What a shape fixes once and for all (egformer_tables.h), by level: 0 is half the picture's size, 4 a thirty-second.
struct EgformerConstants {
    explicit EgformerConstants(const EgformerShape& of, at::Device device = at::kCPU);
    EgformerShape shape;
    std::array<at::Tensor, 2> patch;        // [h w, 9, 2] of levels 0 and 1, the only ones that sample patches
    std::array<at::Tensor, 5> row_bias;     // [h, w, w]; levels 2 to 4
    std::array<at::Tensor, 5> column_bias;  // [1, h, h]
};

// The parameter of EgformerShape::latitude_prior: 32 logits from the zenith down, added to the last layer's.
inline constexpr const char* kLatitudePrior = "latitude_prior";

// color [N, 3, H, W] in 0..1 (sRGB as in files) -> [N, 1, H, W] in (0, 1), growing with distance; affine-invariant.
// Names of parameters are the official checkpoint's keys without their "module.". Each picture of a batch is treated
// alone (the official code lets the pictures of a batch share one maximum of their scores; with one picture it is the
// same).
at::Tensor egformer(const Scope& s, const EgformerConstants& constants, const at::Tensor& color);

}  // namespace fastscene::nn
