#include "fastscene/nn/depth_losses.h"

namespace fastscene::nn {
namespace {

using at::Tensor;
using at::indexing::None;
using at::indexing::Slice;

Tensor sum_of_picture(const Tensor& x) { return x.sum(at::IntArrayRef{1, 2, 3}, true); }

}  // namespace

Tensor aligned_depth(const Tensor& found, const Tensor& truth, const Tensor& mask) {
    // Solves [a b; b n] (scale, shift)' = (c, d)' using means: sums of squares over 100,000 pixels would lose
    // precision.
    const Tensor n = sum_of_picture(mask).clamp_min(1);
    const Tensor mean_found = sum_of_picture(mask * found) / n, mean_truth = sum_of_picture(mask * truth) / n;
    const Tensor off_found = (found - mean_found) * mask, off_truth = (truth - mean_truth) * mask;
    const Tensor variance = sum_of_picture(off_found.square()) / n,
                 together = sum_of_picture(off_found * off_truth) / n;
    const Tensor fits = variance > 1e-9;
    const Tensor scale = at::where(fits, together / variance.clamp_min(1e-9), at::ones_like(variance));
    const Tensor shift = at::where(fits, mean_truth - scale * mean_found, at::zeros_like(variance));
    return found * scale + shift;
}

Tensor invariant_loss(const Tensor& aligned, const Tensor& truth, const Tensor& mask) {
    return ((aligned - truth).abs() * mask).sum() / mask.sum().clamp_min(1);
}

Tensor gradient_loss(const Tensor& aligned, const Tensor& truth, const Tensor& mask) {
    Tensor sum = at::zeros({}, aligned.options());
    for (const std::int64_t step : {1, 2, 4, 8}) {
        const Slice every(None, None, step);
        const Tensor m = mask.index({Slice(), Slice(), every, every}),
                     difference = (aligned - truth).index({Slice(), Slice(), every, every}) * m;
        const std::int64_t h = m.size(2), w = m.size(3);
        const auto change = [&](std::int64_t along, std::int64_t size) {
            const Tensor both = m.narrow(along, 1, size - 1) * m.narrow(along, 0, size - 1);
            return ((difference.narrow(along, 1, size - 1) - difference.narrow(along, 0, size - 1)).abs() * both).sum();
        };
        sum = sum + (change(3, w) + change(2, h)) / m.sum().clamp_min(1);
    }
    return sum;
}

Tensor direct_loss(const Tensor& found, const Tensor& truth, const Tensor& mask) {
    return ((found.clamp_min(1e-4).log() - truth.clamp_min(1e-4).log()).abs() * mask).sum() / mask.sum().clamp_min(1);
}

Tensor depth_loss(const Tensor& found, const Tensor& truth, const Tensor& mask) {
    const Tensor aligned = aligned_depth(found, truth, mask);
    return 0.5 * invariant_loss(aligned, truth, mask) + 0.5 * gradient_loss(aligned, truth, mask);
}

}  // namespace fastscene::nn
