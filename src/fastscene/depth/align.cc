#include "fastscene/depth/align.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/math/solve.h"

namespace fastscene {
namespace {

constexpr int kReach = 2;             // in coarse pixels, to each side
constexpr float kColorSigma = 0.07f;  // of sRGB values: about the noise of a photo, far below an edge
constexpr float kPixelSigma = 1.1f;
// Plane fit of a coarse pixel: similarity of neighbours by color and relative range, and how far a plane is trusted.
constexpr float kSurfaceColorSigma = 0.3f, kSurfaceRangeSigma = 0.15f, kFarthestFromPlane = 1.25f;

Vec3f as_seen(Vec3f c) { return {srgb_from_linear(c.x), srgb_from_linear(c.y), srgb_from_linear(c.z)}; }

struct Neighbour {
    float value, weight;
};

// Planes through the coarse pixels: along a ray d, a plane has 1 / range = dot(g, d), which is linear, so g is a
// least-squares fit over a pixel and its eight neighbours, weighted towards those on the same surface.
Image<Vec3f> planes_of(const ImageF& coarse, const ImageColor& seen) {
    const EquirectSize size{coarse.width, coarse.height};
    Image<Vec3f> planes(size.width, size.height);
    parallel_for(size.height, 16, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < size.width; ++x) {
                const float here = coarse.at(x, y);
                // Weak regularization towards a surface facing the ray, so that an isolated pixel has a plane, too. In
                // units of the pixel's range.
                const auto facing = [&] {
                    const Vec3f d = direction_of_pixel(x, y, size);
                    return Vec3d{d.x, d.y, d.z};
                }();
                constexpr double kWhisper = 1e-3;
                Vec3d a{kWhisper, 0, 0}, b{0, kWhisper, 0}, c{0, 0, kWhisper}, right = facing * kWhisper;
                for (int j = std::max(0, y - 1); j <= std::min(size.height - 1, y + 1); ++j)
                    for (int i = x - 1; i <= x + 1; ++i) {
                        const int column = wrap_column(i, size.width);
                        const float ratio = here / coarse.at(column, j);
                        if (!(ratio > 0.f && std::isfinite(ratio))) continue;
                        const float color_gap = length(seen.at(column, j) - seen.at(x, y)) / kSurfaceColorSigma,
                                    range_gap = std::log(ratio) / kSurfaceRangeSigma;
                        const double weight = (i == x && j == y ? 2. : 1.) *
                                              std::exp(-0.5f * (color_gap * color_gap + range_gap * range_gap));
                        const Vec3f to = direction_of_pixel(column, j, size);
                        const Vec3d d{to.x, to.y, to.z}, w = d * weight;
                        a += d * w.x, b += d * w.y, c += d * w.z;
                        right += w * static_cast<double>(ratio);
                    }
                const Vec3d plane = solved(Mat3d{a, b, c}, right, 1e-15).value_or(facing) / static_cast<double>(here);
                planes.at(x, y) = {static_cast<float>(plane.x), static_cast<float>(plane.y),
                                   static_cast<float>(plane.z)};
            }
    });
    return planes;
}

// Predicted range along a nearby ray, by intersecting it with the plane of a coarse pixel of range `range`. Infinite
// and unknown ranges are returned unchanged.
float range_on_plane(float range, const Vec3f& plane, const Vec3f& ray) {
    if (!(range > 0.f && std::isfinite(range))) return range;
    return std::clamp(1.f / std::max(dot(plane, ray), 1e-6f), range / kFarthestFromPlane, range * kFarthestFromPlane);
}

float weighted_median(std::array<Neighbour, (2 * kReach + 2) * (2 * kReach + 2)>& items, std::size_t count) {
    std::sort(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Neighbour& a, const Neighbour& b) { return a.value < b.value; });
    float total = 0;
    for (std::size_t i = 0; i < count; ++i) total += items[i].weight;
    // Interpolates between the two middle values, so that smooth surfaces stay smooth.
    float sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const float before = sum;
        sum += items[i].weight;
        if (sum < 0.5f * total) continue;
        if (i == 0) return items[0].value;
        const float middle_here = before + 0.5f * items[i].weight, middle_before = before - 0.5f * items[i - 1].weight;
        if (0.5f * total >= middle_here) {
            if (i + 1 == count) return items[i].value;
            const float next = sum + 0.5f * items[i + 1].weight,
                        t = (0.5f * total - middle_here) / (next - middle_here);
            return items[i].value + t * (items[i + 1].value - items[i].value);
        }
        const float t = (0.5f * total - middle_before) / (middle_here - middle_before);
        return items[i - 1].value + t * (items[i].value - items[i - 1].value);
    }
    return items[count - 1].value;
}

}  // namespace

ImageF aligned_to_picture(const ImageF& coarse, const ImageColor& picture) {
    const EquirectSize small{coarse.width, coarse.height}, large{picture.width, picture.height};
    const ImageColor guide = equirect_from_equirect(picture, small);
    ImageColor seen(small.width, small.height);
    std::transform(guide.pixels.begin(), guide.pixels.end(), seen.pixels.begin(), as_seen);
    const Image<Vec3f> planes = planes_of(coarse, seen);

    ImageF out(large.width, large.height);
    const float sx = static_cast<float>(small.width) / static_cast<float>(large.width),
                sy = static_cast<float>(small.height) / static_cast<float>(large.height);
    parallel_for(large.height, 16, [&](std::int64_t begin, std::int64_t end) {
        std::array<Neighbour, (2 * kReach + 2) * (2 * kReach + 2)> items;
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < large.width; ++x) {
                const Vec3f color = as_seen(picture.at(x, y)), ray = direction_of_pixel(x, y, large);
                const float cx = (static_cast<float>(x) + 0.5f) * sx - 0.5f,
                            cy = (static_cast<float>(y) + 0.5f) * sy - 0.5f;
                const int x0 = static_cast<int>(std::floor(cx)), y0 = static_cast<int>(std::floor(cy));
                std::size_t count = 0;
                for (int j = y0 - kReach + 1; j <= y0 + kReach; ++j)
                    for (int i = x0 - kReach + 1; i <= x0 + kReach; ++i) {
                        if (j < 0 || j >= small.height) continue;
                        const int column = wrap_column(i, small.width);
                        const float dx = static_cast<float>(i) - cx, dy = static_cast<float>(j) - cy;
                        const float color_gap = length(seen.at(column, j) - color) / kColorSigma;
                        const float weight = std::exp(
                            -0.5f * ((dx * dx + dy * dy) / (kPixelSigma * kPixelSigma) + color_gap * color_gap));
                        items[count++] = {range_on_plane(coarse.at(column, j), planes.at(column, j), ray),
                                          weight + 1e-6f};
                    }
                out.at(x, y) = weighted_median(items, count);
            }
    });
    return out;
}

}  // namespace fastscene
