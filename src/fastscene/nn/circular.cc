#include "fastscene/nn/circular.h"

#include <algorithm>

#include "fastscene/base/check.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

// Column by column: if a is b, later columns read already blended ones, as in the published code.
Tensor blend(const Tensor& a, Tensor b, std::int64_t count, std::int64_t dim) {
    count = std::min({count, a.size(dim), b.size(dim)});
    for (std::int64_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count);
        b.select(dim, i).copy_(a.select(dim, a.size(dim) - count + i) * (1 - share) + b.select(dim, i) * share);
    }
    return b;
}

}  // namespace

Tensor blend_columns(const Tensor& a, Tensor b, std::int64_t count) { return blend(a, std::move(b), count, 3); }
Tensor blend_rows(const Tensor& a, Tensor b, std::int64_t count) { return blend(a, std::move(b), count, 2); }

Tensor extended(const Tensor& x, std::int64_t count) { return at::cat({x, x.narrow(3, 0, count)}, 3); }

Tensor circular_decode(const Scope& s, const VaeConfig& config, const Tensor& z, std::int64_t tile,
                       bool always_closed) {
    const std::int64_t h = z.size(2), w = z.size(3), scale = config.factor();
    if (h <= tile && w <= tile && !always_closed) return vae_decode(s, config, z);
    constexpr double overlap = 0.25;
    const auto step = static_cast<std::int64_t>(static_cast<double>(tile) * (1 - overlap));
    const auto mix = static_cast<std::int64_t>(static_cast<double>(tile * scale) * overlap);
    FASTSCENE_CHECK(step >= 1);
    const std::int64_t keep = tile * scale - mix;
    const Tensor wide = extended(z, w / 4);
    Tensor above;
    std::vector<Tensor> bands;
    for (std::int64_t y = 0; y < h; y += step) {
        Tensor band = vae_decode(s, config, wide.narrow(2, y, std::min(tile, h - y)));
        if (above.defined()) band = blend_rows(above, band, mix);
        above = band;
        bands.push_back(band.narrow(2, 0, std::min(keep, band.size(2))));
    }
    Tensor picture = at::cat(bands, 2);
    const std::int64_t width = w * scale, more = picture.size(3) - width;
    const Tensor right = picture.narrow(3, width, more).clone();
    picture = picture.narrow(3, 0, width).clone();
    return blend_columns(right, picture, more);
}

}  // namespace fastscene::nn
