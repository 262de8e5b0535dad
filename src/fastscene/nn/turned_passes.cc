#include "fastscene/nn/turned_passes.h"

#include <ATen/ATen.h>

#include <numbers>

#include "fastscene/base/check.h"

namespace fastscene::nn {

using at::Tensor;

Tensor over_turns(const Tensor& color, int turns, const DistanceNet& net) {
    FASTSCENE_CHECK(turns >= 1);
    if (turns == 1) return net(color);
    const std::int64_t width = color.size(3);
    // The rows of an equirectangular picture count by the solid angle they cover.
    const Tensor row = at::sin((at::arange(color.size(2), at::kDouble) + 0.5) * (std::numbers::pi / color.size(2)))
                           .to(color.options())
                           .view({1, -1, 1});
    const Tensor window = at::sin((at::arange(width, at::kDouble) + 0.5) * (std::numbers::pi / width))
                              .square()
                              .to(color.options())
                              .view({1, 1, width});
    Tensor first, sum, total;
    for (int k = 0; k < turns; ++k) {
        const std::int64_t shift = k * width / turns;
        Tensor log = net(color.roll(-shift, 3).contiguous()).log().roll(shift, 2);
        const Tensor weight = window.roll(shift, 2);
        if (k == 0) {
            first = log, sum = log * weight, total = weight;
            continue;
        }
        const Tensor common = row * window * weight;  // where both are to be trusted
        log = log + ((first - log) * common).sum() / common.sum();
        sum = sum + log * weight, total = total + weight;
    }
    return at::exp(sum / total);
}

}  // namespace fastscene::nn
