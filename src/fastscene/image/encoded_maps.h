// Depth and normals as the pixels of PNG files.
#pragma once

#include <algorithm>
#include <cmath>

#include "fastscene/image/color.h"
#include "fastscene/image/image.h"

namespace fastscene {

// Millimetres; 0 = infinitely far, or beyond what 16 bits hold.
inline Image<std::uint16_t> millimetres(const ImageF& range) {
    constexpr float kFarthest_m = 65.5f;
    Image<std::uint16_t> out(range.width, range.height);
    std::transform(range.pixels.begin(), range.pixels.end(), out.pixels.begin(), [](float r) {
        return r < kFarthest_m ? static_cast<std::uint16_t>(std::lround(r * 1000.f)) : std::uint16_t{0};
    });
    return out;
}

// (n + 1) / 2; a zero vector, where there is no surface, is gray.
inline Rgb8 encoded_normal(Vec3f n) {
    if (n == Vec3f{}) return {128, 128, 128};
    return {byte_from_unit(0.5f + 0.5f * n.x), byte_from_unit(0.5f + 0.5f * n.y), byte_from_unit(0.5f + 0.5f * n.z)};
}

}  // namespace fastscene
