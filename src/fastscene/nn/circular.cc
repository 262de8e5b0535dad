#include "fastscene/nn/circular.h"

#include <algorithm>

#include "fastscene/base/check.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

// At once, where no column is read after it was written.
void blend_at_once(const Tensor& from, const Tensor& to, std::int64_t dim) {
    const std::int64_t count = to.size(dim);
    std::vector<std::int64_t> shape(static_cast<std::size_t>(to.dim()), 1);
    shape[static_cast<std::size_t>(dim)] = count;
    const Tensor share = (at::arange(count, to.options().dtype(at::kDouble)) / static_cast<double>(count)).view(shape);
    to.copy_(from * (1 - share).to(at::kFloat) + to * share.to(at::kFloat));
}

// Column by column: if a is b, later columns read already blended ones, as in the published code.
Tensor blend(const Tensor& a, Tensor b, std::int64_t count, std::int64_t dim) {
    count = std::min({count, a.size(dim), b.size(dim)});
    const bool apart = !a.is_alias_of(b) || a.size(dim) - count >= count;
    if (apart && count > 0 && b.scalar_type() == at::kFloat && a.scalar_type() == at::kFloat) {
        blend_at_once(a.narrow(dim, a.size(dim) - count, count), b.narrow(dim, 0, count), dim);
        return b;
    }
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
    // Halves of a graphics card are blended in float.
    const auto decoded = [&](const Tensor& part) {
        const Tensor picture = vae_decode(s, config, part);
        return picture.is_cuda() ? picture.to(at::kFloat) : picture;
    };
    if (h <= tile && w <= tile && !always_closed) return decoded(z);
    constexpr double overlap = 0.25;
    const auto step = static_cast<std::int64_t>(static_cast<double>(tile) * (1 - overlap));
    const auto mix = static_cast<std::int64_t>(static_cast<double>(tile * scale) * overlap);
    FASTSCENE_CHECK(step >= 1);
    const std::int64_t keep = tile * scale - mix;
    const Tensor wide = extended(z, w / 4);
    Tensor above;
    std::vector<Tensor> bands;
    for (std::int64_t y = 0; y < h; y += step) {
        Tensor band = decoded(wide.narrow(2, y, std::min(tile, h - y)));
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
