#include "fastscene/film/stereo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/base/check.h"
#include "fastscene/base/parallel.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

// At 6 degrees a slice's eye is at most 3.3 mm from where its column's would be: a pixel at 1 m in a picture 2048 wide.
constexpr int kSlices = 60;
// A slice is wider than its share, to be blended into the next.
constexpr float kSliceDeg = 2 * 360.f / kSlices;

Pinhole slice_camera(int width) {
    // As fine as the sphere at the horizon, and as high as the offset reaches.
    const float focal = static_cast<float>(width) / (2 * kPi);
    const float half_wide = focal * std::tan(kSliceDeg / 2 * kPi / 180) + 1,
                half_high = focal * std::tan(kNoOffsetDeg * kPi / 180) + 1;
    const int w = 2 * static_cast<int>(std::ceil(half_wide)), h = 2 * static_cast<int>(std::ceil(half_high));
    return {w, h, focal, focal, static_cast<float>(w) / 2, static_cast<float>(h) / 2};
}

}  // namespace

ImageRgb8 stacked(const ImageRgb8& above, const ImageRgb8& below) {
    FASTSCENE_CHECK(above.width == below.width);
    ImageRgb8 out(above.width, above.height + below.height);
    std::copy(above.pixels.begin(), above.pixels.end(), out.pixels.begin());
    std::copy(below.pixels.begin(), below.pixels.end(), out.pixels.begin() + static_cast<std::ptrdiff_t>(above.size()));
    return out;
}

ImageRgb8 beside(const ImageRgb8& left, const ImageRgb8& right) {
    FASTSCENE_CHECK(left.height == right.height);
    ImageRgb8 out(left.width + right.width, left.height);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) out.at(x, y) = x < left.width ? left.at(x, y) : right.at(x - left.width, y);
    return out;
}

ImageRgb8 front_half(const ImageRgb8& sphere) {
    ImageRgb8 out(sphere.width / 2, sphere.height);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) out.at(x, y) = sphere.at(sphere.width / 4 + x, y);
    return out;
}

Rigid displaced_eye(const Rigid& pose, float eye_m) { return {pose.rotation, pose * Vec3f{eye_m, 0, 0}}; }

ImageRgb8 eye_sphere_of(const SplatRenderer& splats, int width, const Rigid& world_from_pano, float eye_m,
                        Vec3f background) {
    const EquirectSize size{width, width / 2};
    const ImageRgb8 center = sphere_of(splats, width, world_from_pano, background).color;
    const Pinhole camera = slice_camera(width);
    ImageColor sum(size.width, size.height);
    ImageF weights(size.width, size.height);
    for (int slice = 0; slice < kSlices; ++slice) {
        const float middle = (static_cast<float>(slice) + 0.5f) * 2 * kPi / kSlices - kPi;  // longitude
        const Mat3f pano_from_slice = rotation_about(Vec3f{0, 1, 0}, middle);
        const Rigid pose{world_from_pano.rotation * pano_from_slice,
                         world_from_pano * (pano_from_slice * Vec3f{eye_m, 0, 0})};
        const ImageColor picture = splats.picture(camera, pose, background).color;
        const float reach = kSliceDeg / 2 / 360.f * static_cast<float>(width);  // columns on either side
        const float column = (middle / (2 * kPi) + 0.5f) * static_cast<float>(width);
        const int first = static_cast<int>(std::ceil(column - reach)),
                  last = static_cast<int>(std::floor(column + reach));
        parallel_for(size.height, 16, [&](std::int64_t begin, std::int64_t end) {
            for (auto y = static_cast<int>(begin); y < end; ++y)
                for (int c = first; c <= last; ++c) {
                    const float off = (static_cast<float>(c) + 0.5f - column) / reach;
                    if (!(std::fabs(off) < 1)) continue;
                    const int x = wrap_column(c, size.width);
                    const Vec3f direction = transpose(pano_from_slice) * direction_of_pixel(x, y, size);
                    const auto pixel = camera.project(direction);
                    if (!pixel || pixel->y < 0 || pixel->y > static_cast<float>(camera.height)) continue;
                    const float weight = 1 - std::fabs(off);
                    sum.at(x, y) += sample_flat(picture, *pixel) * weight;
                    weights.at(x, y) += weight;
                }
        });
    }
    ImageRgb8 out(size.width, size.height);
    for (int y = 0; y < size.height; ++y) {
        const float latitude = (0.5f - (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height)) * kPi;
        const float share = eye_share(latitude);
        for (int x = 0; x < size.width; ++x) {
            if (!(share > 0 && weights.at(x, y) > 0)) {
                out.at(x, y) = center.at(x, y);
                continue;
            }
            const Vec3f own = sum.at(x, y) / weights.at(x, y);
            const Rgb8 other = center.at(x, y);
            const auto mixed = [&](float a, std::uint8_t b) {
                return byte_from_unit(a * share + static_cast<float>(b) / 255.f * (1 - share));
            };
            out.at(x, y) = {mixed(own.x, other.r), mixed(own.y, other.g), mixed(own.z, other.b)};
        }
    }
    return out;
}

}  // namespace fastscene
