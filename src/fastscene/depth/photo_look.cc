#include "fastscene/depth/photo_look.h"

#include <algorithm>
#include <cmath>

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

template <class T>
Image<T> turned(const Image<T>& image, int columns, bool mirrored) {
    Image<T> out(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            out.at(x, y) = image.at(wrap_column((mirrored ? image.width - 1 - x : x) + columns, image.width), y);
    return out;
}

// Separable 3 x 3 filter with circular columns.
ImageColor blurred(const ImageColor& image, float sigma) {
    const float side = std::exp(-0.5f / (sigma * sigma)), scale = 1 / (1 + 2 * side);
    ImageColor across(image.width, image.height), out(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            across.at(x, y) = (image.at(x, y) + (image.at(wrap_column(x - 1, image.width), y) +
                                                 image.at(wrap_column(x + 1, image.width), y)) *
                                                    side) *
                              scale;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            out.at(x,
                   y) = (across.at(x, y) +
                         (across.at(x, std::max(0, y - 1)) + across.at(x, std::min(image.height - 1, y + 1))) * side) *
                        scale;
    return out;
}

}  // namespace

PhotoLook random_photo_look(Random& rng) {
    PhotoLook look;
    look.turn = rng.uniform();
    look.mirrored = rng.chance(0.5f);
    look.exposure_ev = 0.6f * rng.normal();
    const float warm = 0.12f * rng.normal(), green = 0.04f * rng.normal();
    look.white = {std::exp(warm - green), std::exp(green), std::exp(-warm - green)};
    look.gamma = std::clamp(std::exp(0.18f * rng.normal()), 0.6f, 1.6f);
    look.saturation = rng.uniform(0.4f, 1.4f);
    if (rng.chance(0.1f)) look.saturation = 0;  // gray pictures, too
    if (rng.chance(0.4f)) look.blur_px = rng.uniform(0.3f, 0.9f);
    if (rng.chance(0.5f)) look.noise = 0.05f * std::pow(rng.uniform(), 2.f);
    if (rng.chance(0.3f)) look.jpeg_quality = 45 + rng.index(50);
    return look;
}

DepthExample seen_as(const DepthExample& example, const PhotoLook& look, Random& rng) {
    const int columns = static_cast<int>(look.turn * static_cast<float>(example.color.width));
    DepthExample out{turned(example.color, columns, look.mirrored), turned(example.range, columns, look.mirrored)};
    ImageColor light = linear_from_srgb8(out.color);
    if (look.blur_px > 0) light = blurred(light, look.blur_px);
    const float gain = std::exp2(look.exposure_ev);
    for (std::size_t i = 0; i < light.size(); ++i) {
        Vec3f c{light.pixels[i].x * look.white.x * gain, light.pixels[i].y * look.white.y * gain,
                light.pixels[i].z * look.white.z * gain};
        const float gray = luminance(c);
        Vec3f seen;
        for (std::size_t a = 0; a < 3; ++a) {
            const float v = std::pow(std::clamp(srgb_from_linear(gray + (c[a] - gray) * look.saturation), 0.f, 1.f),
                                     look.gamma);
            seen[a] = look.noise > 0 ? v + look.noise * rng.normal() : v;
        }
        out.color.pixels[i] = {byte_from_unit(seen.x), byte_from_unit(seen.y), byte_from_unit(seen.z)};
    }
    if (look.jpeg_quality < 100)
        out.color = decode_rgb8(encode_jpeg(out.color, look.jpeg_quality), "a picture for training");
    return out;
}

}  // namespace fastscene
