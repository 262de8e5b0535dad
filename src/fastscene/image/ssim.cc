#include "fastscene/image/ssim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace fastscene {
namespace {

constexpr int kRadius = 5;

using Window = std::array<double, 2 * kRadius + 1>;
Window gaussian_window() {
    Window w{};
    double sum = 0;
    for (int i = -kRadius; i <= kRadius; ++i)
        sum += w[static_cast<std::size_t>(i + kRadius)] = std::exp(-i * i / (2 * 1.5 * 1.5));
    for (double& v : w) v /= sum;
    return w;
}
// The splatting papers' code computes its window in single precision, and libtorch sums its eleven weights in four
// lanes. Due to that sum's rounding, the window's total is 7e-8 below 1, which changes scores of uniform areas in the
// fifth decimal. Their window is a rounded 11 x 11 product; here it stays separable, with the same sum.
Window single_window() {
    std::array<float, 2 * kRadius + 1> w{};
    std::array<float, 4> lanes{};
    for (int i = -kRadius; i <= kRadius; ++i) {
        const auto at = static_cast<std::size_t>(i + kRadius);
        w[at] = static_cast<float>(std::exp(-i * i / (2 * 1.5 * 1.5)));
        lanes[at % 4] += w[at];
    }
    const float sum = (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
    Window out{};
    for (float& v : w) v /= sum;
    double side = 0, all = 0;
    for (const float a : w) {
        side += a;
        for (const float b : w) all += a * b;
    }
    for (std::size_t i = 0; i < w.size(); ++i) out[i] = w[i] * std::sqrt(all) / side;
    return out;
}

using Plane = Image<double>;

// Separable blur with zero padding.
Plane blur(const Plane& in, const Window& window) {
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
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb8 p = image.pixels[i];
        out.pixels[i] = (c == 0 ? p.r : c == 1 ? p.g : p.b) / 255.0;
    }
    return out;
}
Plane gray(const ImageRgb8& image) {
    Plane out(image.width, image.height);
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb8 p = image.pixels[i];
        out.pixels[i] = 0.299 * p.r + 0.587 * p.g + 0.114 * p.b;
    }
    return out;
}

Plane product(const Plane& a, const Plane& b) {
    Plane out(a.width, a.height);
    for (std::size_t i = 0; i < a.size(); ++i) out.pixels[i] = a.pixels[i] * b.pixels[i];
    return out;
}

// Local means, (co)variances and the four factors of the map at one pixel.
struct Moments {
    Plane mx, my, xx, yy, xy;
    Moments(const Plane& x, const Plane& y, const Window& w)
        : mx(blur(x, w)),
          my(blur(y, w)),
          xx(blur(product(x, x), w)),
          yy(blur(product(y, y), w)),
          xy(blur(product(x, y), w)) {}
};
struct Factors {
    double a, b, a1, a2, b1, b2;
    Factors(const Moments& m, std::size_t i, double peak) : a(m.mx.pixels[i]), b(m.my.pixels[i]) {
        const double c1 = 0.01 * peak * 0.01 * peak, c2 = 0.03 * peak * 0.03 * peak;
        a1 = 2 * a * b + c1;
        a2 = 2 * (m.xy.pixels[i] - a * b) + c2;
        b1 = a * a + b * b + c1;
        b2 = m.xx.pixels[i] - a * a + m.yy.pixels[i] - b * b + c2;
    }
    double ssim() const { return a1 * a2 / (b1 * b2); }
};

// Means of two planes, pixel by pixel.
Plane mean_of(const Plane& a, const Plane& b) {
    Plane out(a.width, a.height);
    for (std::size_t i = 0; i < a.size(); ++i) out.pixels[i] = (a.pixels[i] + b.pixels[i]) / 2;
    return out;
}

}  // namespace

double mean_squared_error(const ImageRgb8& a, const ImageRgb8& b, const ImageMask& mask) {
    FASTSCENE_CHECK(a.same_size(b) && (mask.empty() || mask.same_size(a)));
    std::int64_t sum = 0;  // integers: exact
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!mask.empty() && !mask.pixels[i]) continue;
        const Rgb8 p = a.pixels[i], q = b.pixels[i];
        const int r = p.r - q.r, g = p.g - q.g, bl = p.b - q.b;
        sum += r * r + g * g + bl * bl;
        ++count;
    }
    return count ? static_cast<double>(sum) / (3.0 * 255 * 255 * static_cast<double>(count))
                 : std::numeric_limits<double>::quiet_NaN();
}

double psnr_of_mse(double mse) { return mse == 0 ? std::numeric_limits<double>::infinity() : -10 * std::log10(mse); }

double ssim_of_channel(const Image<double>& x, const Image<double>& y, double peak, bool windows_inside) {
    const int edge = windows_inside ? kRadius : 0;
    FASTSCENE_CHECK(x.same_size(y) && x.width > 2 * edge && x.height > 2 * edge);
    const Moments moments(x, y, windows_inside ? gaussian_window() : single_window());
    double sum = 0;
    for (int v = edge; v < x.height - edge; ++v)
        for (int u = edge; u < x.width - edge; ++u)
            sum += Factors(
                       moments,
                       static_cast<std::size_t>(v) * static_cast<std::size_t>(x.width) + static_cast<std::size_t>(u),
                       peak)
                       .ssim();
    return sum / (static_cast<double>(x.width - 2 * edge) * (x.height - 2 * edge));
}

// With p, q, r the derivatives of the map by blur(x), blur(x^2), blur(x y), and a symmetric window: dS/dx = blur(p) + 2
// x blur(q) + y blur(r).
Image<double> ssim_gradient(const Image<double>& x, const Image<double>& y) {
    FASTSCENE_CHECK(x.same_size(y) && !x.empty());
    const Window window = single_window();
    const Moments moments(x, y, window);
    Plane p(x.width, x.height), q = p, r = p;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Factors f(moments, i, 1);
        p.pixels[i] = 2 * f.b * (f.a2 - f.a1) / (f.b1 * f.b2) - 2 * f.a * f.ssim() * (1 / f.b1 - 1 / f.b2);
        q.pixels[i] = -f.ssim() / f.b2;
        r.pixels[i] = 2 * f.a1 / (f.b1 * f.b2);
    }
    p = blur(p, window), q = blur(q, window), r = blur(r, window);
    for (std::size_t i = 0; i < x.size(); ++i)
        p.pixels[i] = (p.pixels[i] + 2 * x.pixels[i] * q.pixels[i] + y.pixels[i] * r.pixels[i]) /
                      static_cast<double>(x.size());
    return p;
}

double ssim(const ImageRgb8& a, const ImageRgb8& b, Ssim kind) {
    FASTSCENE_CHECK(a.same_size(b) && !a.empty());
    if (kind == Ssim::wang) return ssim_of_channel(gray(a), gray(b), 255, true);
    double sum = 0;
    for (int c = 0; c < 3; ++c) sum += ssim_of_channel(channel(a, c), channel(b, c), 1, kind == Ssim::valid);
    return sum / 3;
}

double ssim_of_noisy_truth(const ImageRgb8& picture, const ImageRgb8& truth, const ImageRgb8& again) {
    FASTSCENE_CHECK(picture.same_size(truth) && picture.same_size(again) && !picture.empty());
    const Window window = single_window();
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
        const Plane a = channel(truth, c), b = channel(again, c);
        Moments moments(channel(picture, c), mean_of(a, b), window);
        // The variance is E[ab] - E[a] E[b]; Factors subtracts the square of the mean of both.
        const Plane ma = blur(a, window), mb = blur(b, window);
        moments.yy = blur(product(a, b), window);
        for (std::size_t i = 0; i < ma.size(); ++i)
            moments.yy.pixels[i] += moments.my.pixels[i] * moments.my.pixels[i] - ma.pixels[i] * mb.pixels[i];
        for (std::size_t i = 0; i < ma.size(); ++i)
            sum += Factors(moments, i, 1).ssim() / static_cast<double>(ma.size());
    }
    return sum / 3;
}

}  // namespace fastscene
