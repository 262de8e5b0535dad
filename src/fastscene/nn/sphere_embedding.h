// SphereViT's fixed embedding of viewing angles (DA-2, Li et al. 2025): which direction each patch of an
// equirectangular picture looks in, as sines of many frequencies. Private to nn/ (torch).
#pragma once

#include <ATen/core/Tensor.h>

#include <cstdint>

namespace fastscene::nn {

// Pixels of a full turn and of the angle from pole to pole. The published code derives them from the size of its input,
// not from that of the picture the network sees: only where the two agree do the angles span the sphere.
struct SphereSize {
    double width, height;
};

// Directions of every `step`-th pixel (top left of each step x step block), [1, 3, height, width] of doubles: x right, y
// down, z forward, the picture's middle ahead.
at::Tensor sphere_directions(std::int64_t height, std::int64_t width, const SphereSize& sphere, std::int64_t step = 1);
// Polar angle (of y, within a quarter turn) and azimuth of directions [1, 3, h, w]: [1, h w, 2] of doubles.
at::Tensor sphere_angles(const at::Tensor& directions);
// sin(angle f pi) for `count` frequencies f from 1 to `highest`, evenly spaced in their logarithm; first all of the
// polar angle, then all of the azimuth: [1, N, 2 count] of floats.
at::Tensor sphere_embedding(const at::Tensor& angles, std::int64_t count, std::int64_t highest);

}  // namespace fastscene::nn
