#include "fastscene/nn/sphere_tiles.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/base/check.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

// Tile positions on a bounded axis: the last tile ends with it.
std::vector<std::int64_t> row_starts(std::int64_t side, std::int64_t tile, std::int64_t overlap) {
    std::vector<std::int64_t> out{0};
    while (out.back() + tile < side) out.push_back(std::min(out.back() + tile - overlap, side - tile));
    return out;
}
// … and on a circle: evenly spaced.
std::vector<std::int64_t> column_starts(std::int64_t side, std::int64_t tile, std::int64_t overlap) {
    const std::int64_t step = tile - overlap, count = (side + step - 1) / step;
    std::vector<std::int64_t> out;
    for (std::int64_t i = 0; i < count; ++i) out.push_back(i * side / count);
    return out;
}

// Blend weights: 1, with ramps from and to nearly 0 over `ramp` values at the ends that have a neighbour.
Tensor hat(std::int64_t size, std::int64_t ramp, bool rises, bool falls) {
    Tensor weight = at::ones({size}, at::kFloat);
    for (std::int64_t i = 0; i < std::min(ramp, size); ++i) {
        const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(ramp);
        if (rises) weight[i] = std::min(weight[i].item<float>(), share);
        if (falls) weight[size - 1 - i] = std::min(weight[size - 1 - i].item<float>(), share);
    }
    return weight;
}

}  // namespace

Tensor over_sphere(const Tensor& x, const SphereTiles& how, const std::function<Tensor(const Tensor&)>& net) {
    const std::int64_t height = x.size(2) / how.in, width = x.size(3) / how.in;
    const std::int64_t rows = std::min(how.tile, height), columns = std::min(how.tile, width),
                       overlap = std::min({how.overlap, rows / 2, columns / 2});
    FASTSCENE_CHECK(overlap > 0 && x.size(0) == 1);
    const auto tops = row_starts(height, rows, overlap), lefts = column_starts(width, columns, overlap);
    const at::TensorOptions there = x.options().dtype(at::kFloat);
    const auto wrapped = [&](std::int64_t from, std::int64_t count, std::int64_t around) {
        return at::remainder(at::arange(from, from + count, there.dtype(at::kLong)), around);
    };
    const Tensor across = hat(columns * how.out, overlap * how.out, true, true);
    Tensor sum, weights = at::zeros({1, 1, height * how.out, width * how.out}, there);
    std::int64_t done = 0;
    for (const std::int64_t top : tops) {
        const Tensor down = hat(rows * how.out, overlap * how.out, top > 0, top + rows < height);
        const Tensor weight = (down.unsqueeze(1) * across.unsqueeze(0)).unsqueeze(0).unsqueeze(0).to(x.device());
        for (const std::int64_t left : lefts) {
            const Tensor tile = net(x.narrow(2, top * how.in, rows * how.in)
                                        .index_select(3, wrapped(left * how.in, columns * how.in, width * how.in)))
                                    .to(x.device(), at::kFloat);
            if (!sum.defined()) sum = at::zeros({1, tile.size(1), height * how.out, width * how.out}, there);
            const Tensor where = wrapped(left * how.out, columns * how.out, width * how.out);
            sum.narrow(2, top * how.out, rows * how.out).index_add_(3, where, tile * weight);
            weights.narrow(2, top * how.out, rows * how.out).index_add_(3, where, weight);
            if (how.heard) how.heard(++done, static_cast<std::int64_t>(tops.size() * lefts.size()));
        }
    }
    return sum / weights;
}

}  // namespace fastscene::nn
