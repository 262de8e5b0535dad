// Applies a network to a panorama too large for memory, in overlapping blended tiles. Columns wrap, so neither tile
// borders nor the seam show. Private to nn/ (torch).
#pragma once

#include <functional>

#include <ATen/ATen.h>

namespace fastscene::nn {

struct SphereTiles {
    std::int64_t tile = 64, overlap = 16;  // in units
    std::int64_t in = 1, out = 8;          // pixels per unit of the network's input and output
    std::function<void(std::int64_t done, std::int64_t total)> heard;
};
// x [1, C, in H, in W] -> [1, C', out H, out W]: `net` maps tiles [1, C, in h, in w] to [1, C', out h, out w].
at::Tensor over_sphere(const at::Tensor& x, const SphereTiles& how,
                       const std::function<at::Tensor(const at::Tensor&)>& net);

}  // namespace fastscene::nn
