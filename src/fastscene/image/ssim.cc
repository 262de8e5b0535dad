#include "fastscene/image/ssim.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr int kRadius = 5;

std::array<double, 2 * kRadius + 1> gaussian_window() {
    std::array<double, 2 * kRadius + 1> w{};
    double sum = 0;
    for (int i = -kRadius; i <= kRadius; ++i) sum += w[static_cast<std::size_t>(i + kRadius)] = std::exp(-i * i / (2 * 1.5 * 1.5));
    for (double& v : w) v /= sum;
    return w;
}

using Plane = Image<double>;

// Separable blur; what lies outside the picture counts as 0.
Plane blur(const Plane& in) {
    static const auto window = gaussian_window();
    Plane across(in.width, in.height), out(in.width, in.height);
    for (int y = 0; y < in.height; ++y)
        for (int x = 0; x < in.width; ++x)
            for (int k = std::max(-kRadius, -x); k <= std::min(kRadius, in.width - 1 - x); ++k)
                across.at(x, y) += window[static_cast<std::size_t>(k + kRadius)] * in.at(x + k, y);
    for (int y = 0; y < in.height; ++y)
        for (int k = std::max(-kRadius, -y); k <= std::min(kRadius, in.height - 1 - y); ++k)
            for (int x = 0; x < in.width; ++x)
                out.at(x, y) += window[static_cast<std::size_t>(k + kRadius)] * across.at(x, y + k);
    return out;
}

Plane channel(const ImageRgb8& image, int c) {
    Plane out(image.width, image.height);
    for (std::size_t i = 0; i < image.size(); ++i) out.pixels[i] = unit_from_srgb8(image.pixels[i])[static_cast<std::size_t>(c)];
    return out;
}

Plane product(const Plane& a, const Plane& b) {
    Plane out(a.width, a.height);
    for (std::size_t i = 0; i < a.size(); ++i) out.pixels[i] = a.pixels[i] * b.pixels[i];
    return out;
}

double ssim_of_channel(const Plane& x, const Plane& y) {
    constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    const Plane mx = blur(x), my = blur(y), xx = blur(product(x, x)), yy = blur(product(y, y)), xy = blur(product(x, y));
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double a = mx.pixels[i], b = my.pixels[i];
        const double vx = xx.pixels[i] - a * a, vy = yy.pixels[i] - b * b, cov = xy.pixels[i] - a * b;
        sum += (2 * a * b + c1) * (2 * cov + c2) / ((a * a + b * b + c1) * (vx + vy + c2));
    }
    return sum / static_cast<double>(x.size());
}

}  // namespace

double mean_squared_error(const ImageRgb8& a, const ImageRgb8& b, const ImageMask& mask) {
    FASTSCENE_CHECK(a.same_size(b) && (mask.empty() || mask.same_size(a)));
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!mask.empty() && !mask.pixels[i]) continue;
        const Vec3f d = unit_from_srgb8(a.pixels[i]) - unit_from_srgb8(b.pixels[i]);
        sum += static_cast<double>(dot(d, d));
        ++count;
    }
    return count ? sum / (3.0 * static_cast<double>(count)) : std::numeric_limits<double>::quiet_NaN();
}

double psnr_of_mse(double mse) { return mse == 0 ? std::numeric_limits<double>::infinity() : -10 * std::log10(mse); }

double ssim(const ImageRgb8& a, const ImageRgb8& b) {
    FASTSCENE_CHECK(a.same_size(b) && !a.empty());
    double sum = 0;
    for (int c = 0; c < 3; ++c) sum += ssim_of_channel(channel(a, c), channel(b, c));
    return sum / 3;
}

}  // namespace fastscene
