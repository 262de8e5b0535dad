#include "fastscene/nn/clip_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

#include "fastscene/base/error.h"
#include "fastscene/base/parallel.h"

namespace fastscene {
namespace {

constexpr int kBits = 22;  // fixed-point bits of a weight: 32, less 8 for the value and 2 for overshoot of the sum

double cubic(double x) {
    x = std::abs(x);
    if (x < 1) return (1.5 * x - 2.5) * x * x + 1;
    if (x < 2) return ((-0.5 * x + 2.5) * x - 4) * x + 2;
    return 0;
}

struct Taps {
    int first = 0;
    std::vector<std::int32_t> weights;
};
std::vector<Taps> taps_for(int from, int to) {
    const double scale = static_cast<double>(from) / to, widen = std::max(scale, 1.0), reach = 2 * widen;
    std::vector<Taps> out;
    for (int i = 0; i < to; ++i) {
        const double center = (i + 0.5) * scale;
        const int first = std::max(0, static_cast<int>(center - reach + 0.5)),
                  last = std::min(from, static_cast<int>(center + reach + 0.5));
        std::vector<double> weights;
        double sum = 0;
        for (int k = first; k < last; ++k) sum += weights.emplace_back(cubic((k - center + 0.5) / widen));
        Taps taps{first, {}};
        for (const double w : weights)
            taps.weights.push_back(static_cast<std::int32_t>(w / sum * (1 << kBits) + (w < 0 ? -0.5 : 0.5)));
        out.push_back(std::move(taps));
    }
    return out;
}

std::uint8_t byte_of(std::int32_t sum) { return static_cast<std::uint8_t>(std::clamp(sum >> kBits, 0, 255)); }

// Weighted sum of pixels with stride `step`.
Rgb8 gathered(const Rgb8* pixels, std::size_t step, const Taps& taps) {
    std::array<std::int32_t, 3> sum{1 << (kBits - 1), 1 << (kBits - 1), 1 << (kBits - 1)};
    for (std::size_t k = 0; k < taps.weights.size(); ++k) {
        const Rgb8 p = pixels[(static_cast<std::size_t>(taps.first) + k) * step];
        sum[0] += p.r * taps.weights[k];
        sum[1] += p.g * taps.weights[k];
        sum[2] += p.b * taps.weights[k];
    }
    return {byte_of(sum[0]), byte_of(sum[1]), byte_of(sum[2])};
}

void for_each_row(int height, const std::function<void(int)>& work) {
    constexpr std::int64_t grain = 16;  // rows: a few microseconds each
    parallel_for(height, grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t y = begin; y < end; ++y) work(static_cast<int>(y));
    });
}

// Rounds half to even, like Python.
int rounded(double v) { return static_cast<int>(std::nearbyint(v)); }

}  // namespace

ImageRgb8 pillow_bicubic(const ImageRgb8& image, int width, int height) {
    FASTSCENE_CHECK(width > 0 && height > 0 && !image.empty());
    ImageRgb8 rows = image;
    if (width != image.width) {
        const std::vector<Taps> taps = taps_for(image.width, width);
        rows = ImageRgb8(width, image.height);
        for_each_row(image.height, [&](int y) {
            for (int x = 0; x < width; ++x)
                rows.at(x, y) = gathered(image.row(y), 1, taps[static_cast<std::size_t>(x)]);
        });
    }
    if (height == image.height) return rows;
    const std::vector<Taps> taps = taps_for(image.height, height);
    ImageRgb8 out(width, height);
    for_each_row(height, [&](int y) {
        for (int x = 0; x < width; ++x)
            out.at(x, y) = gathered(rows.pixels.data() + x, static_cast<std::size_t>(width),
                                    taps[static_cast<std::size_t>(y)]);
    });
    return out;
}

ImageRgb8 clip_crop(const ImageRgb8& image, int side) {
    if (image.empty()) throw Error("CLIP: expected a picture of at least one pixel, found none");
    const int shorter = std::min(image.width, image.height), longer = std::max(image.width, image.height);
    const auto other = static_cast<int>(static_cast<std::int64_t>(side) * longer / shorter);
    if (other > 64 * side)
        throw Error("CLIP: expected a picture whose sides differ by less than 64 times, found {} x {}", image.width,
                    image.height);
    const bool upright = image.height >= image.width;
    const ImageRgb8 small = pillow_bicubic(image, upright ? side : other, upright ? other : side);
    const int left = rounded((small.width - side) / 2.0), top = rounded((small.height - side) / 2.0);
    ImageRgb8 out(side, side);
    for (int y = 0; y < side; ++y) std::copy_n(small.row(top + y) + left, side, out.row(y));
    return out;
}

}  // namespace fastscene
