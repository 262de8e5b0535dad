// The sphere as a picture: COLMAP 4.1's EQUIRECTANGULAR camera. Camera frame: x right, y down, z forward; longitude
// grows to the right, latitude upward; the picture's center looks along +z.
//   lon = atan2(x, z), lat = atan2(-y, hypot(x, z)), px = (lon / 2pi + 1/2) W, py = (1/2 - lat / pi) H
// Pixel centers are at +0.5; columns wrap. (The paper's equations 1-2 and 8-11, read literally, cover half a sphere:
// docs/conventions.md.)
#pragma once

#include <cmath>
#include <numbers>

#include "fastscene/math/vec.h"

namespace fastscene {

struct EquirectSize {
    int width = 0, height = 0;
};

// Unit direction at picture point (px, py).
template <class F>
Vec3<F> direction_at(Vec2<F> pixel, EquirectSize size) {
    using std::cos;
    using std::sin;
    const F lon = (pixel.x / F(size.width) - F(0.5)) * F(2 * std::numbers::pi);
    const F lat = (F(0.5) - pixel.y / F(size.height)) * F(std::numbers::pi);
    return {cos(lat) * sin(lon), -sin(lat), cos(lat) * cos(lon)};
}
// Unit direction through the center of pixel (x, y).
inline Vec3f direction_of_pixel(int x, int y, EquirectSize size) {
    return direction_at(Vec2f{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, size);
}
// Projects a direction (any nonzero length): x in [0, W], y in [0, H].
template <class F>
Vec2<F> pixel_of_direction(Vec3<F> d, EquirectSize size) {
    using std::atan2;
    using std::sqrt;
    const F lon = atan2(d.x, d.z), lat = atan2(-d.y, sqrt(d.x * d.x + d.z * d.z));
    return {(lon / F(2 * std::numbers::pi) + F(0.5)) * F(size.width),
            (F(0.5) - lat / F(std::numbers::pi)) * F(size.height)};
}
// Solid angle of a pixel in row y; all pixels together cover 4 pi.
inline double pixel_solid_angle(int y, EquirectSize size) {
    const double pi = std::numbers::pi;
    const double top = (0.5 - static_cast<double>(y) / size.height) * pi,
                 bottom = (0.5 - static_cast<double>(y + 1) / size.height) * pi;
    return (std::sin(top) - std::sin(bottom)) * 2 * pi / size.width;
}
// Wraps a column outside [0, width) around the seam.
inline int wrap_column(int x, int width) {
    const int r = x % width;
    return r < 0 ? r + width : r;
}

}  // namespace fastscene
