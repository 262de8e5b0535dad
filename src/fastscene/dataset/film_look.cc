#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/base/parallel.h"
#include "fastscene/image/color.h"
#include "fastscene/dataset/parts.h"

namespace fastscene::dataset {
namespace {

std::vector<float> gaussian(float sigma) {
    const int radius = std::max(1, static_cast<int>(std::ceil(2.5f * sigma)));
    std::vector<float> weights;
    float sum = 0;
    for (int i = -radius; i <= radius; ++i)
        sum += weights.emplace_back(std::exp(-0.5f * static_cast<float>(i * i) / (sigma * sigma)));
    for (float& w : weights) w /= sum;
    return weights;
}

ImageColor blurred(const ImageColor& image, float sigma, bool wraps) {
    const std::vector<float> weights = gaussian(sigma);
    const int radius = static_cast<int>(weights.size() / 2), w = image.width, h = image.height;
    const auto column = [&](int x) { return wraps ? ((x % w) + w) % w : std::clamp(x, 0, w - 1); };
    ImageColor across(w, h), out(w, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            for (int i = -radius; i <= radius; ++i)
                across.at(x, y) += image.at(column(x + i), y) * weights[static_cast<std::size_t>(i + radius)];
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            for (int i = -radius; i <= radius; ++i)
                out.at(x, y) += across.at(x, std::clamp(y + i, 0, h - 1)) *
                                weights[static_cast<std::size_t>(i + radius)];
    return out;
}

// The camera's tone curve: an S-curve around mid-gray, a gamma, and lifted blacks.
float tone(const Film& film, float v) {
    const float s = v + film.s_curve * v * (1 - v) * (2 * v - 1) * 2;
    return film.lift + (1 - film.lift) * std::pow(std::clamp(s, 0.f, 1.f), film.gamma);
}

}  // namespace

Film random_film(Random& rng, bool perspective) {
    Film film;
    film.blur_px = rng.chance(0.5f) ? rng.uniform(0.25f, 0.9f) : 0.f;
    // A third of all pictures are practically free of noise; the worst resemble a phone at night.
    const float noise = rng.chance(0.35f) ? 0.f : std::pow(rng.uniform(), 2.f);
    film.shot_noise = 0.05f * noise;
    film.read_noise = 0.012f * noise * rng.uniform();
    film.gamma = std::exp(0.14f * rng.normal());
    film.gamma = std::clamp(film.gamma, 0.7f, 1.4f);
    film.lift = rng.chance(0.3f) ? rng.uniform(0.f, 0.06f) : 0.f;
    film.s_curve = rng.uniform(-0.15f, 0.3f);
    film.vignette = perspective && rng.chance(0.5f) ? rng.uniform(0.f, 0.35f) : 0.f;
    film.jpeg_quality = static_cast<int>(rng.uniform(58.f, 97.99f));
    return film;
}

ImageRgb8 expose(const ImageColor& color, const Film& film, bool wraps, Random& rng) {
    ImageColor light = film.blur_px > 0 ? blurred(color, film.blur_px, wraps) : color;
    ImageRgb8 out(light.width, light.height);
    const float rx = 0.5f * static_cast<float>(light.width), ry = 0.5f * static_cast<float>(light.height),
                corner = rx * rx + ry * ry;
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x) {
            Vec3f c = light.at(x, y);
            const float dx = static_cast<float>(x) + 0.5f - rx, dy = static_cast<float>(y) + 0.5f - ry;
            c = c * (1.f - film.vignette * (dx * dx + dy * dy) / corner);
            for (std::size_t a = 0; a < 3; ++a) {
                if (film.shot_noise > 0)
                    c[a] += rng.normal() *
                            std::hypot(film.shot_noise * std::sqrt(std::max(0.f, c[a])), film.read_noise);
                c[a] = tone(film, std::clamp(srgb_from_linear(c[a]), 0.f, 1.f));
            }
            out.at(x, y) = {byte_from_unit(c.x), byte_from_unit(c.y), byte_from_unit(c.z)};
        }
    return out;
}

Json to_json(const Film& film) {
    return {{"blur_px", film.blur_px},
            {"shot_noise", film.shot_noise},
            {"read_noise", film.read_noise},
            {"gamma", film.gamma},
            {"lift", film.lift},
            {"s_curve", film.s_curve},
            {"vignette", film.vignette},
            {"jpeg_quality", film.jpeg_quality}};
}

}  // namespace fastscene::dataset
