// Color: linear floats in memory, sRGB 8 bit in files (IEC 61966-2-1).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/image/image.h"

namespace fastscene {

inline float srgb_from_linear(float v) {
    v = v > 0.f ? v : 0.f;  // NaN becomes 0
    return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1.f / 2.4f) - 0.055f;
}
inline float linear_from_srgb(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }
inline std::uint8_t byte_from_unit(float v) {
    return static_cast<std::uint8_t>(std::clamp(v, 0.f, 1.f) * 255.f + 0.5f);
}

inline Vec3f srgb_from_linear(Vec3f c) { return {srgb_from_linear(c.x), srgb_from_linear(c.y), srgb_from_linear(c.z)}; }
// sRGB-encoded floats in [0, 1]; brighter light is clamped.
inline Vec3f unit_from_linear(Vec3f c) {
    const Vec3f v = srgb_from_linear(c);
    return {std::min(1.f, v.x), std::min(1.f, v.y), std::min(1.f, v.z)};
}
inline Rgb8 srgb8_from_unit(Vec3f c) { return {byte_from_unit(c.x), byte_from_unit(c.y), byte_from_unit(c.z)}; }
inline Rgb8 srgb8_from_linear(Vec3f c) { return srgb8_from_unit(srgb_from_linear(c)); }
inline Vec3f linear_from_srgb8(Rgb8 c) {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (std::size_t i = 0; i < t.size(); ++i) t[i] = linear_from_srgb(static_cast<float>(i) / 255.f);
        return t;
    }();
    return {table[c.r], table[c.g], table[c.b]};
}
// sRGB-encoded floats in [0, 1]: the space in which splats are trained and compared.
inline Vec3f unit_from_srgb8(Rgb8 c) {
    return {static_cast<float>(c.r) / 255.f, static_cast<float>(c.g) / 255.f, static_cast<float>(c.b) / 255.f};
}

inline ImageColor unit_from_linear(const ImageColor& image) {
    ImageColor out(image.width, image.height);
    std::transform(image.pixels.begin(), image.pixels.end(), out.pixels.begin(),
                   [](Vec3f c) { return unit_from_linear(c); });
    return out;
}
inline ImageRgb8 srgb8_from_unit(const ImageColor& image) {
    ImageRgb8 out(image.width, image.height);
    std::transform(image.pixels.begin(), image.pixels.end(), out.pixels.begin(),
                   [](Vec3f c) { return srgb8_from_unit(c); });
    return out;
}
inline ImageRgb8 srgb8_from_linear(const ImageColor& image) {
    ImageRgb8 out(image.width, image.height);
    std::transform(image.pixels.begin(), image.pixels.end(), out.pixels.begin(),
                   [](Vec3f c) { return srgb8_from_linear(c); });
    return out;
}
inline ImageColor linear_from_srgb8(const ImageRgb8& image) {
    ImageColor out(image.width, image.height);
    std::transform(image.pixels.begin(), image.pixels.end(), out.pixels.begin(),
                   [](Rgb8 c) { return linear_from_srgb8(c); });
    return out;
}

}  // namespace fastscene
