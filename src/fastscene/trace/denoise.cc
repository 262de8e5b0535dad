#include "fastscene/trace/denoise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/check.h"
#include "fastscene/base/parallel.h"
#include "fastscene/geometry/sphere.h"

namespace fastscene {
namespace {

constexpr std::array<float, 5> kSpline{1.f / 16, 1.f / 4, 3.f / 8, 1.f / 4, 1.f / 16};
constexpr float kDeviations = 2.2f;  // range weight: differences beyond this many standard deviations are real edges
constexpr float kExact = 0.004f;     // relative standard error below which nothing is left to do
// how far off a pixel's plane a neighbour may lie, as a share of the pixel's distance
constexpr float kOffPlane = 0.12f;

bool is_surface(Vec3f normal) { return dot(normal, normal) > 0.25f; }

// A pixel's own variance estimate is unreliable: if none of its rays hit the lamp, they all agree. So the variance per
// ray is pooled over the neighbourhood, and a pixel counts as more certain than its neighbours only as far as its
// larger ray count justifies. Otherwise a single lucky ray would survive as a speck.
ImageF pooled_variance(const ImageF& variance, const Guides& guides) {
    constexpr int kReach = 2;
    ImageF out = variance;
    parallel_for(variance.height, 8, [&](std::int64_t begin, std::int64_t end) {
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < variance.width; ++x) {
                if (!is_surface(guides.normal.at(x, y))) continue;  // the sky, or nothing at all
                float sum = 0, count = 0;
                for (int qy = std::max(0, y - kReach); qy <= std::min(variance.height - 1, y + kReach); ++qy)
                    for (int dx = -kReach; dx <= kReach; ++dx) {
                        int qx = x + dx;
                        if (guides.wraps) qx = wrap_column(qx, variance.width);
                        else if (qx < 0 || qx >= variance.width) continue;
                        if (!is_surface(guides.normal.at(qx, qy))) continue;
                        sum += variance.at(qx, qy) * guides.rays_of(qx, qy);
                        ++count;
                    }
                out.at(x, y) = std::max(variance.at(x, y), count > 0 ? sum / (count * guides.rays_of(x, y)) : 0.f);
            }
    });
    return out;
}

// One level of the à-trous wavelet: the 5 x 5 B-spline taps, `step` pixels apart.
struct Level {
    const NoisyLight& light;
    const Guides& guides;
    int step;

    // Edge-stopping weight of pixel q for the pixel at `position`, in 0..1.
    float agreement(Vec3f position, Vec3f normal, float bright, float deviation2, int qx, int qy) const {
        const float same = same_surface(guides, qx, qy, position, normal);
        if (!(same > 0)) return 0;
        const float difference = luminance(light.value.at(qx, qy)) - bright;
        const float tolerance = kDeviations * kDeviations * (deviation2 + light.variance.at(qx, qy)) + 1e-12f;
        return same * std::exp(-difference * difference / tolerance);
    }

    void filter(int x, int y, Vec3f& value, float& variance) const {
        const Vec3f here = light.value.at(x, y), normal = guides.normal.at(x, y), position = guides.position.at(x, y);
        const float bright = luminance(here), own = light.variance.at(x, y);
        value = here;
        variance = own;
        if (!is_surface(normal) || !(own > kExact * kExact * bright * bright)) return;
        const int width = light.value.width, height = light.value.height;
        Vec3f sum{};
        float weights = 0, squares = 0;
        for (int j = -2; j <= 2; ++j) {
            const int qy = y + j * step;
            if (qy < 0 || qy >= height) continue;
            for (int i = -2; i <= 2; ++i) {
                int qx = x + i * step;
                if (guides.wraps) qx = wrap_column(qx, width);
                else if (qx < 0 || qx >= width) continue;
                const float spline = kSpline[static_cast<std::size_t>(i + 2)] *
                                     kSpline[static_cast<std::size_t>(j + 2)];
                const float agrees = i == 0 && j == 0 ? 1.f : agreement(position, normal, bright, own, qx, qy);
                // weighted by rays, so that the result is the mean over rays rather than over pixels
                const float w = spline * agrees * guides.rays_of(qx, qy);
                sum += light.value.at(qx, qy) * w;
                weights += w;
                squares += w * w * light.variance.at(qx, qy);
            }
        }
        value = sum / weights;
        variance = squares / (weights * weights);
    }
};

}  // namespace

float same_surface(const Guides& guides, int x, int y, Vec3f position, Vec3f normal) {
    const float turned = dot(normal, guides.normal.at(x, y));
    if (!(turned > 0.5f)) return 0;
    const Vec3f to = guides.position.at(x, y) - position;
    const float off = dot(to, normal), reach2 = dot(to, to) * (kOffPlane * kOffPlane) + 1e-7f;
    const float t2 = turned * turned, t8 = t2 * t2 * t2 * t2;
    return t8 * t8 * std::exp(-off * off / reach2);
}

void denoise(NoisyLight& light, const Guides& guides, int levels) {
    FASTSCENE_CHECK(light.value.same_size(guides.normal));
    light.variance = pooled_variance(light.variance, guides);
    NoisyLight next{ImageColor(light.value.width, light.value.height), ImageF(light.value.width, light.value.height)};
    for (int k = 0; k < levels; ++k) {
        const Level level{light, guides, 1 << k};
        parallel_for(light.value.height, 8, [&](std::int64_t begin, std::int64_t end) {
            for (auto y = static_cast<int>(begin); y < end; ++y)
                for (int x = 0; x < light.value.width; ++x)
                    level.filter(x, y, next.value.at(x, y), next.variance.at(x, y));
        });
        std::swap(light, next);
    }
}

}  // namespace fastscene
