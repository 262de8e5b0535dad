#include "fastscene/evaluate/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace fastscene {
namespace {

struct Knot {
    double at, r, g, b;
};
// Perceptually uniform; lower values are always darker.
constexpr std::array<Knot, 6> kRamp{{{0, 0, 0, 4},
                                     {0.2, 59, 15, 112},
                                     {0.4, 140, 41, 129},
                                     {0.6, 222, 73, 104},
                                     {0.8, 254, 159, 109},
                                     {1, 252, 253, 191}}};

Rgb8 ramp(double v) {
    v = std::clamp(v, 0.0, 1.0);
    std::size_t i = 1;
    while (i + 1 < kRamp.size() && kRamp[i].at < v) ++i;
    const Knot &a = kRamp[i - 1], &b = kRamp[i];
    const double t = (v - a.at) / (b.at - a.at);
    const auto mix = [t](double x, double y) { return static_cast<std::uint8_t>(std::lround(x + t * (y - x))); };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

}  // namespace

ImageRgb8 thumbnail(const ImageRgb8& image, int width) {
    if (image.width <= width) return image;
    const int height = std::max(1,
                                static_cast<int>(std::lround(static_cast<double>(image.height) * width / image.width)));
    ImageRgb8 out(width, height);
    const auto bound = [](int i, int of, int source) {
        return static_cast<int>(static_cast<std::int64_t>(i) * source / of);
    };
    for (int y = 0; y < height; ++y) {
        const int y0 = bound(y, height, image.height), y1 = std::max(y0 + 1, bound(y + 1, height, image.height));
        for (int x = 0; x < width; ++x) {
            const int x0 = bound(x, width, image.width), x1 = std::max(x0 + 1, bound(x + 1, width, image.width));
            int r = 0, g = 0, b = 0;
            for (int v = y0; v < y1; ++v)
                for (int u = x0; u < x1; ++u) r += image.at(u, v).r, g += image.at(u, v).g, b += image.at(u, v).b;
            const int n = (x1 - x0) * (y1 - y0);
            out.at(x, y) = {static_cast<std::uint8_t>((r + n / 2) / n), static_cast<std::uint8_t>((g + n / 2) / n),
                            static_cast<std::uint8_t>((b + n / 2) / n)};
        }
    }
    return out;
}

ImageRgb8 error_map(const ImageRgb8& a, const ImageRgb8& b, double white) {
    FASTSCENE_CHECK(a.same_size(b));
    ImageRgb8 out(a.width, a.height);
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Rgb8 p = a.pixels[i], q = b.pixels[i];
        out.pixels[i] = ramp((std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b)) / 3.0 / white);
    }
    return out;
}

ImageRgb8 cut_out(const ImageRgb8& image, int x, int y, int width, int height) {
    FASTSCENE_CHECK(x >= 0 && y >= 0 && x + width <= image.width && y + height <= image.height);
    ImageRgb8 out(width, height);
    for (int v = 0; v < height; ++v) std::copy_n(image.row(y + v) + x, width, out.row(v));
    return out;
}

}  // namespace fastscene
