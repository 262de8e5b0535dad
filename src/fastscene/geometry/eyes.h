// Omnidirectional stereo: two panoramas whose viewpoint moves with the column, so that there is depth in every
// direction that a viewer turns to. Columns and rows as in sphere.h.
#pragma once

#include <algorithm>
#include <cmath>

#include "fastscene/geometry/sphere.h"

namespace fastscene {

// Mean distance between the pupils of adults, in metres.
inline constexpr float kPupils_m = 0.063f;
// Straight up and down the columns meet, and eyes that turn with them would see the same point from all sides. The
// offset is whole up to the first latitude and gone from the second on.
inline constexpr float kWholeOffsetDeg = 60, kNoOffsetDeg = 75;

// The share of an eye's offset that is left at a latitude.
inline float eye_share(float latitude_rad) {
    const float deg = std::fabs(latitude_rad) * 180.f / std::numbers::pi_v<float>;
    const float t = std::clamp((deg - kWholeOffsetDeg) / (kNoOffsetDeg - kWholeOffsetDeg), 0.f, 1.f);
    return 1.f - t * t * (3.f - 2.f * t);
}
// Where the ray through a picture point starts, in the panorama's frame: `eye_m` to the right of its direction, level.
inline Vec3f eye_offset(Vec2f pixel, EquirectSize size, float eye_m) {
    const float lon = (pixel.x / static_cast<float>(size.width) - 0.5f) * 2 * std::numbers::pi_v<float>;
    const float lat = (0.5f - pixel.y / static_cast<float>(size.height)) * std::numbers::pi_v<float>;
    const float offset = eye_m * eye_share(lat);
    return {std::cos(lon) * offset, 0, -std::sin(lon) * offset};
}

}  // namespace fastscene
