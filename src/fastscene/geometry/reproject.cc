#include "fastscene/geometry/reproject.h"

#include <algorithm>

#include "fastscene/geometry/averaged.h"

namespace fastscene {
namespace {

// The pixel at any integer position: columns wrap, rows beyond a pole continue at the opposite longitude.
Vec3f pixel_on_sphere(const ImageColor& image, int x, int y) {
    const int w = image.width, h = image.height;
    if (y >= 0 && y < h) return image.at(wrap_column(x, w), y);
    y = std::clamp(y < 0 ? -1 - y : 2 * h - 1 - y, 0, h - 1);
    // With an odd number of columns, the opposite longitude is between two of them.
    return lerp(image.at(wrap_column(x + w / 2, w), y), image.at(wrap_column(x + w - w / 2, w), y), 0.5f);
}

}  // namespace

Vec3f sample_equirect(const ImageColor& equirect, Vec2f pixel) {
    const float fx = std::floor(pixel.x - 0.5f), fy = std::floor(pixel.y - 0.5f);
    const float u = pixel.x - 0.5f - fx, v = pixel.y - 0.5f - fy;
    const int x = static_cast<int>(fx), y = static_cast<int>(fy);
    return lerp(lerp(pixel_on_sphere(equirect, x, y), pixel_on_sphere(equirect, x + 1, y), u),
                lerp(pixel_on_sphere(equirect, x, y + 1), pixel_on_sphere(equirect, x + 1, y + 1), u), v);
}

Vec3f sample_flat(const ImageColor& picture, Vec2f pixel) {
    const float px = std::clamp(pixel.x - 0.5f, 0.f, static_cast<float>(picture.width - 1));
    const float py = std::clamp(pixel.y - 0.5f, 0.f, static_cast<float>(picture.height - 1));
    const int x = static_cast<int>(px), y = static_cast<int>(py);
    const int x1 = std::min(x + 1, picture.width - 1), y1 = std::min(y + 1, picture.height - 1);
    const float u = px - static_cast<float>(x), v = py - static_cast<float>(y);
    return lerp(lerp(picture.at(x, y), picture.at(x1, y), u), lerp(picture.at(x, y1), picture.at(x1, y1), u), v);
}

ImageColor pinhole_from_equirect(const ImageColor& equirect, const Pinhole& camera, const Mat3f& pano_from_camera) {
    const int n = samples_a_side(1.0 / static_cast<double>(camera.fx), 2 * std::numbers::pi / equirect.width);
    const EquirectSize size{equirect.width, equirect.height};
    return averaged(camera.width, camera.height, n, [&](Vec2f at) {
        return sample_equirect(equirect, pixel_of_direction(pano_from_camera * camera.direction_at(at), size));
    });
}

ImageColor equirect_from_equirect(const ImageColor& equirect, EquirectSize size, const Mat3f& source_from_target) {
    const int n = std::max(samples_a_side(1.0 / size.width, 1.0 / equirect.width),
                           samples_a_side(1.0 / size.height, 1.0 / equirect.height));
    const EquirectSize source{equirect.width, equirect.height};
    return averaged(size.width, size.height, n, [&](Vec2f at) {
        return sample_equirect(equirect, pixel_of_direction(source_from_target * direction_at(at, size), source));
    });
}

}  // namespace fastscene
