#include "fastscene/metrics/brisque_opencv.h"

#include <algorithm>
#include <cmath>

#include "fastscene/metrics/naturalness.h"

namespace fastscene {
namespace {

// 8-bit gray in fixed point with 15 fraction bits, then 0..1.
ImageF unit_gray(const ImageRgb8& image) {
    ImageF out(image.width, image.height);
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb8 c = image.pixels[i];
        const int gray = (9798 * c.r + 19235 * c.g + 3735 * c.b + (1 << 14)) >> 15;
        out.pixels[i] = static_cast<float>(gray * (1. / 255));
    }
    return out;
}

// Bicubic with a = -0.75 at the matching position, without antialiasing; clamped at the border.
struct Taps {
    int first = 0;
    float weight[4] = {};
};
std::vector<Taps> cubic_taps(int from, int to) {
    std::vector<Taps> out;
    const double step = static_cast<double>(from) / to;
    for (int i = 0; i < to; ++i) {
        const auto at = static_cast<float>((i + 0.5) * step - 0.5);
        const int base = static_cast<int>(std::floor(at));
        const float x = at - static_cast<float>(base);
        constexpr float a = -0.75f;
        Taps t{base - 1, {}};
        t.weight[0] = ((a * (x + 1) - 5 * a) * (x + 1) + 8 * a) * (x + 1) - 4 * a;
        t.weight[1] = ((a + 2) * x - (a + 3)) * x * x + 1;
        t.weight[2] = ((a + 2) * (1 - x) - (a + 3)) * (1 - x) * (1 - x) + 1;
        t.weight[3] = 1 - t.weight[0] - t.weight[1] - t.weight[2];
        out.push_back(t);
    }
    return out;
}
ImageF half_size(const ImageF& in) {
    ImageF out(in.width / 2, in.height / 2);
    const std::vector<Taps> across = cubic_taps(in.width, out.width), down = cubic_taps(in.height, out.height);
    ImageF rows(out.width, in.height);
    for (int y = 0; y < in.height; ++y)
        for (int x = 0; x < out.width; ++x)
            for (int k = 0; k < 4; ++k) {
                const Taps& t = across[static_cast<std::size_t>(x)];
                rows.at(x, y) += t.weight[k] * in.at(std::clamp(t.first + k, 0, in.width - 1), y);
            }
    for (int y = 0; y < out.height; ++y)
        for (int k = 0; k < 4; ++k) {
            const Taps& t = down[static_cast<std::size_t>(y)];
            const float* from = rows.row(std::clamp(t.first + k, 0, in.height - 1));
            for (int x = 0; x < out.width; ++x) out.at(x, y) += t.weight[k] * from[x];
        }
    return out;
}

ImageF blur(const ImageF& in) {
    Plane wide(in.width, in.height);
    std::copy(in.pixels.begin(), in.pixels.end(), wide.pixels.begin());
    const Plane out = blurred(wide, Border::replicate);
    ImageF narrow(in.width, in.height);
    std::transform(out.pixels.begin(), out.pixels.end(), narrow.pixels.begin(),
                   [](double v) { return static_cast<float>(v); });
    return narrow;
}

ImageF structure_of(const ImageF& in) {
    ImageF square = in;
    for (float& v : square.pixels) v *= v;
    const ImageF mean = blur(in), power = blur(square);
    ImageF out(in.width, in.height);
    for (std::size_t i = 0; i < in.size(); ++i) {
        // A variance made negative by rounding counts as 0.
        const float variance = power.pixels[i] - mean.pixels[i] * mean.pixels[i];
        const float sigma = std::sqrt(variance > 0 ? variance : 0.f) + static_cast<float>(1. / 255);
        out.pixels[i] = (in.pixels[i] - mean.pixels[i]) / sigma;
    }
    return out;
}

// v(x, y) v(x + dx, y + dy), zero padding.
std::vector<double> products(const ImageF& v, int dy, int dx) {
    std::vector<double> out;
    out.reserve(v.size());
    for (int y = 0; y < v.height; ++y)
        for (int x = 0; x < v.width; ++x) {
            const int sy = y + dy, sx = x + dx;
            const bool inside = sy >= 0 && sy < v.height && sx >= 0 && sx < v.width;
            out.push_back(inside ? static_cast<double>(v.at(x, y) * v.at(sx, sy)) : 0.0);
        }
    return out;
}

float square(double v) { return static_cast<float>(v * v); }

}  // namespace

std::vector<double> opencv_brisque_features(const ImageRgb8& image) {
    std::vector<double> out;
    ImageF plane = unit_gray(image);
    for (int scale = 0; scale < 2; ++scale) {
        const ImageF structure = structure_of(plane);
        const Aggd own = fit_aggd({structure.pixels.begin(), structure.pixels.end()});
        out.push_back(static_cast<float>(own.alpha));
        out.push_back(static_cast<float>(own.left_std * own.left_std + own.right_std * own.right_std) / 2);
        constexpr int shifts[4][2] = {{0, 1}, {1, 0}, {1, 1}, {-1, 1}};
        for (const auto& [dy, dx] : shifts) {
            const Aggd pair = fit_aggd(products(structure, dy, dx));
            const double mean = (pair.right_std - pair.left_std) * pair.ratio() * pair.scale();
            out.insert(out.end(), {static_cast<float>(pair.alpha), static_cast<float>(mean), square(pair.left_std),
                                   square(pair.right_std)});
        }
        if (scale == 0) plane = half_size(plane);
    }
    return out;
}

}  // namespace fastscene
