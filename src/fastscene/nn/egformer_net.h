// EGformer as a function of its weights: equirectangular geometry-biased transformer for panoramic depth (Yun, Lee,
// Rhee, ICCV 2023). Private to nn/ (torch).
#pragma once

#include <array>

#include "fastscene/nn/egformer.h"
#include "fastscene/nn/scope.h"

namespace fastscene::nn {

// Constants that depend on the shape only (egformer_tables.h), by level: 0 is half the picture's resolution, 4 is 1/32.
struct EgformerConstants {
    explicit EgformerConstants(const EgformerShape& of, at::Device device = at::kCPU);
    EgformerShape shape;
    std::array<at::Tensor, 2> patch;        // [h w, 9, 2] of levels 0 and 1, the only ones with patch sampling
    std::array<at::Tensor, 5> row_bias;     // [h, w, w]; levels 2 to 4
    std::array<at::Tensor, 5> column_bias;  // [1, h, h]
};

// Key of EgformerShape::latitude_prior: 32 logits from the zenith down, added to those of the last layer.
inline constexpr const char* kLatitudePrior = "latitude_prior";

// color [N, 3, H, W] in 0..1 (sRGB) -> [N, 1, H, W] in (0, 1), increasing with distance, defined up to scale and shift.
// Parameter names are the official checkpoint's keys without "module.". Pictures of a batch are independent (in the
// official code they share one maximum of scores; for a single picture the result is the same).
at::Tensor egformer(const Scope& s, const EgformerConstants& constants, const at::Tensor& color);

}  // namespace fastscene::nn
