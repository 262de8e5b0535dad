#include "fastscene/metrics/naturalness.h"

#include <algorithm>
#include <cmath>

namespace fastscene {
namespace {

// Shapes on the search grid, and E|x|^2 / E x^2 of a generalized Gaussian with each shape.
constexpr int kShapes = 9801;
double shape(int i) { return 0.2 + 0.001 * i; }
const std::vector<double>& shape_ratios() {
    static const std::vector<double> table = [] {
        std::vector<double> out(kShapes);
        for (int i = 0; i < kShapes; ++i) {
            const double a = shape(i), g2 = std::tgamma(2 / a);
            out[static_cast<std::size_t>(i)] = g2 * g2 / (std::tgamma(1 / a) * std::tgamma(3 / a));
        }
        return out;
    }();
    return table;
}

// The first shape with the minimum `distance(ratio)`; the smallest shape if all are NaN, like MATLAB's min.
template <class Distance>
double nearest_shape(Distance&& distance) {
    const std::vector<double>& ratios = shape_ratios();
    int best = 0;
    double least = INFINITY;
    for (int i = 0; i < kShapes; ++i) {
        const double d = distance(ratios[static_cast<std::size_t>(i)]);
        if (d < least) least = d, best = i;
    }
    return shape(best);
}

double cubic(double x) {  // Keys 1981 with a = -0.5
    x = std::abs(x);
    if (x <= 1) return (1.5 * x - 2.5) * x * x + 1;
    if (x <= 2) return ((-0.5 * x + 2.5) * x - 4) * x + 2;
    return 0;
}
// … d c b a | a b c d … | d c b a …
int mirrored(int i, int n) {
    i %= 2 * n;
    if (i < 0) i += 2 * n;
    return i < n ? i : 2 * n - 1 - i;
}

// Downsampling by 2 along a line: output i lies between inputs 2i and 2i+1, and the kernel is stretched to a radius of
// 4.
constexpr int kHalvingTaps = 8;
std::array<double, kHalvingTaps> halving_weights() {
    std::array<double, kHalvingTaps> w{};
    double sum = 0;
    for (int k = 0; k < kHalvingTaps; ++k) sum += w[static_cast<std::size_t>(k)] = cubic((k - 3.5) / 2);
    for (double& v : w) v /= sum;
    return w;
}

Plane half_height(const Plane& in) {
    const auto w = halving_weights();
    Plane out(in.width, (in.height + 1) / 2);
    for (int y = 0; y < out.height; ++y)
        for (int k = 0; k < kHalvingTaps; ++k) {
            const double* from = in.row(mirrored(2 * y - 3 + k, in.height));
            for (int x = 0; x < in.width; ++x) out.at(x, y) += w[static_cast<std::size_t>(k)] * from[x];
        }
    return out;
}
Plane half_width(const Plane& in) {
    const auto w = halving_weights();
    Plane out((in.width + 1) / 2, in.height);
    for (int y = 0; y < in.height; ++y)
        for (int x = 0; x < out.width; ++x)
            for (int k = 0; k < kHalvingTaps; ++k)
                out.at(x, y) += w[static_cast<std::size_t>(k)] * in.at(mirrored(2 * x - 3 + k, in.width), y);
    return out;
}

}  // namespace

Plane matlab_gray(const ImageRgb8& image) {
    Plane out(image.width, image.height);
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb8 c = image.pixels[i];
        out.pixels[i] = std::round(0.298936021293775 * c.r + 0.587043074451121 * c.g + 0.114020904255103 * c.b);
    }
    return out;
}

Plane matlab_luma(const ImageRgb8& image) {
    Plane out(image.width, image.height);
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb8 c = image.pixels[i];
        out.pixels[i] = std::round(16 + (65.481 * c.r + 128.553 * c.g + 24.966 * c.b) / 255);
    }
    return out;
}

bool is_constant(const ImageRgb8& image) {
    return std::all_of(image.pixels.begin(), image.pixels.end(), [&](Rgb8 c) { return c == image.pixels.front(); });
}

Plane matlab_half(const Plane& plane) { return half_width(half_height(plane)); }

Window gaussian_window() {
    constexpr double sigma = 7.0 / 6;
    Window w{};
    for (int x = -kWindowRadius; x <= kWindowRadius; ++x)
        for (int y = -kWindowRadius; y <= kWindowRadius; ++y)
            w[tap(x, y)] = std::exp(-(x * x + y * y) / (2 * sigma * sigma));
    for (int pass = 0; pass < 2; ++pass) {  // the authors' code normalizes twice, which affects the last digits
        double sum = 0;
        for (int x = -kWindowRadius; x <= kWindowRadius; ++x) {
            double column = 0;
            for (int y = -kWindowRadius; y <= kWindowRadius; ++y) column += w[tap(x, y)];
            sum += column;
        }
        for (double& v : w) v /= sum;
    }
    return w;
}

// Summed in the order of the authors' environment, without fused multiply-add: in a uniform area x - blur(x) is the
// rounding error of this very sum, and its sign, equal for all pixels of one gray, decides whether they count as left
// or right of 0.
Plane blurred(const Plane& plane, Border border) {
    static const Window w = gaussian_window();
    constexpr int r = kWindowRadius;
    Plane padded(plane.width + 2 * r, plane.height + 2 * r), out(plane.width, plane.height);
    for (int y = 0; y < padded.height; ++y)
        for (int x = 0; x < padded.width; ++x) {
            const int u = std::clamp(x - r, 0, plane.width - 1), v = std::clamp(y - r, 0, plane.height - 1);
            const bool inside = u == x - r && v == y - r;
            if (inside || border == Border::replicate) padded.at(x, y) = plane.at(u, v);
        }
    for (int y = 0; y < plane.height; ++y)
        for (int dx = -r; dx <= r; ++dx)
            for (int dy = r; dy >= -r; --dy) {
                const double weight = w[tap(dx, dy)];
                const double* from = padded.row(y + r + dy) + r + dx;
                double* to = out.row(y);
                for (int x = 0; x < plane.width; ++x) to[x] += weight * from[x];
            }
    return out;
}

Normalized normalized(const Plane& plane, Border border, double offset) {
    Plane square = plane;
    for (double& v : square.pixels) v *= v;
    const Plane mean = blurred(plane, border);
    Normalized out{Plane(plane.width, plane.height), blurred(square, border)};
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const double m = mean.pixels[i], sigma = std::sqrt(std::abs(out.sigma.pixels[i] - m * m));
        out.sigma.pixels[i] = sigma;
        out.structure.pixels[i] = (plane.pixels[i] - m) / (sigma + offset);
    }
    return out;
}

std::vector<double> block_values(const Plane& plane, Block b) {
    std::vector<double> out;
    out.reserve(static_cast<std::size_t>(b.width) * static_cast<std::size_t>(b.height));
    for (int y = b.y; y < b.y + b.height; ++y) out.insert(out.end(), plane.row(y) + b.x, plane.row(y) + b.x + b.width);
    return out;
}

std::vector<double> neighbor_products(const Plane& plane, Block b, int dy, int dx) {
    std::vector<double> out;
    out.reserve(static_cast<std::size_t>(b.width) * static_cast<std::size_t>(b.height));
    for (int y = 0; y < b.height; ++y) {
        const double* here = plane.row(b.y + y) + b.x;
        const double* there = plane.row(b.y + (y - dy + b.height) % b.height) + b.x;
        for (int x = 0; x < b.width; ++x) out.push_back(here[x] * there[(x - dx + b.width) % b.width]);
    }
    return out;
}

Ggd fit_ggd(const std::vector<double>& values) {
    double absolute = 0, square = 0;
    for (const double v : values) absolute += std::abs(v), square += v * v;
    const auto n = static_cast<double>(values.size());
    absolute /= n, square /= n;
    const double rho = square / (absolute * absolute);
    return {nearest_shape([rho](double r) { return std::abs(rho - 1 / r); }), square};
}

Aggd fit_aggd(const std::vector<double>& values) {
    double left = 0, right = 0, absolute = 0;
    std::size_t lefts = 0, rights = 0;
    for (const double v : values) {
        absolute += std::abs(v);
        if (v < 0) left += v * v, ++lefts;
        if (v > 0) right += v * v, ++rights;
    }
    const auto n = static_cast<double>(values.size());
    Aggd out;
    out.left_std = std::sqrt(left / static_cast<double>(lefts));
    out.right_std = std::sqrt(right / static_cast<double>(rights));
    const double mean = absolute / n, r = mean * mean / ((left + right) / n), g = out.left_std / out.right_std;
    const double wanted = r * (g * g * g + 1) * (g + 1) / ((g * g + 1) * (g * g + 1));
    out.alpha = nearest_shape([wanted](double ratio) { return (ratio - wanted) * (ratio - wanted); });
    return out;
}

double Aggd::scale() const { return std::sqrt(std::tgamma(1 / alpha) / std::tgamma(3 / alpha)); }
double Aggd::ratio() const { return std::tgamma(2 / alpha) / std::tgamma(1 / alpha); }

}  // namespace fastscene
