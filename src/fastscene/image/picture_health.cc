#include "fastscene/image/picture_health.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fastscene {
namespace {

constexpr int kBlack = 3, kWhite = 252;  // of 255: noise of JPEG and of path tracing stays within
// Rooms at night have lamps, and snow outside a window has a room around it: more of one value is no picture.
constexpr double kMostBlack = 0.8, kMostWhite = 0.6;
constexpr double kLeastContrast = 2.0 / 255;  // an even wall fills no sphere: less is one color alone

struct Counts {
    std::size_t all = 0, black = 0, white = 0;
    double sum = 0, squares = 0;
    void add(double r, double g, double b) {  // 0..255
        ++all;
        black += std::max({r, g, b}) <= kBlack ? 1u : 0u;
        white += std::min({r, g, b}) >= kWhite ? 1u : 0u;
        const double luma = 0.2126 * r + 0.7152 * g + 0.0722 * b;
        sum += luma;
        squares += luma * luma;
    }
    PictureHealth health() const {
        if (all == 0) return {};
        const double n = static_cast<double>(all), mean = sum / n;
        return {static_cast<double>(black) / n, static_cast<double>(white) / n,
                std::sqrt(std::max(0.0, squares / n - mean * mean)) / 255, 0, 0};
    }
};

std::string percent(double share) { return fmt::format("{:.0f} %", std::floor(100 * share)); }

}  // namespace

PictureHealth health_of(const ImageRgb8& picture) {
    Counts counts;
    for (const Rgb8& p : picture.pixels) counts.add(p.r, p.g, p.b);
    return counts.health();
}

PictureHealth health_of(const ImageColor& encoded, const ImageF& alpha) {
    Counts counts;
    std::size_t transparent = 0, broken = 0;
    for (std::size_t i = 0; i < encoded.size(); ++i) {
        const Vec3f c = encoded.pixels[i];
        const float a = alpha.empty() ? 1.f : alpha.pixels[i];
        if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z) || !std::isfinite(a)) {
            ++broken;
            continue;
        }
        transparent += a < 0.5f ? 1u : 0u;
        const auto byte = [](float v) { return 255.0 * std::clamp(static_cast<double>(v), 0.0, 1.0); };
        counts.add(byte(c.x), byte(c.y), byte(c.z));
    }
    PictureHealth health = counts.health();
    const double n = std::max<double>(1, static_cast<double>(encoded.size()));
    health.transparent = static_cast<double>(transparent) / n;
    health.not_finite = static_cast<double>(broken) / n;
    return health;
}

std::string complaint(const PictureHealth& h, double most_transparent) {
    if (h.not_finite > 0) return fmt::format("{:.3g} % of its pixels are no numbers", 100 * h.not_finite);
    if (h.transparent > most_transparent)
        return percent(h.transparent) + " of it is transparent, expected at most " + percent(most_transparent);
    if (h.black > kMostBlack) return percent(h.black) + " of it is black";
    if (h.white > kMostWhite) return percent(h.white) + " of it is white";
    if (h.contrast < kLeastContrast) return "it shows one color alone";
    return {};
}

}  // namespace fastscene
