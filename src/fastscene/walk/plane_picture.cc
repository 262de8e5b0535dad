#include "fastscene/walk/plane_picture.h"

#include <algorithm>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/range_edges.h"
#include "fastscene/geometry/reproject.h"

namespace fastscene {
namespace {

constexpr float kReach_m = 8.f;        // a plane's picture ends here on each side of panorama 0
constexpr int kLongestSide = 640;
constexpr float kMargin_m = 0.15f;     // hidden part of a furniture face that we believe in

PlanePicture blank(ScenePlane plane) {
    PlanePicture picture{plane, 0.01f, {}, {}};
    Vec2f& low = picture.plane.low;
    Vec2f& high = picture.plane.high;
    low = {std::max(low.x - kMargin_m, -kReach_m), std::max(low.y - kMargin_m, -kReach_m)};
    high = {std::min(high.x + kMargin_m, kReach_m), std::min(high.y + kMargin_m, kReach_m)};
    const float longest = std::max(high.x - low.x, high.y - low.y);
    if (!(longest > 0.02f)) return picture;
    picture.metres_per_pixel = std::max(0.01f, longest / kLongestSide);
    const auto pixels = [&](float metres) { return std::max(2, static_cast<int>(std::ceil(metres / picture.metres_per_pixel))); };
    picture.color = ImageColor(pixels(high.x - low.x), pixels(high.y - low.y));
    return picture;
}

// Are all pixels about (x, y) on the plane? A pixel beside a crease or a silhouette holds some of what lies across it.
bool is_inside(const Image<std::int16_t>& label, const ImageMask& cuts, int x, int y, std::int16_t index) {
    if (cuts.at(x, y) & kFarSide) return false;
    for (int j = std::max(0, y - 1); j <= std::min(label.height - 1, y + 1); ++j)
        for (int i = x - 1; i <= x + 1; ++i)
            if (label.at(wrap_column(i, label.width), j) != index) return false;
    return true;
}

}  // namespace

Vec3f PlanePicture::color_at(Vec3f point) const {
    return sample_flat(color, {(dot(plane.u, point) - plane.low.x) / metres_per_pixel, (dot(plane.v, point) - plane.low.y) / metres_per_pixel});
}

bool PlanePicture::reaches(Vec3f point) const {
    if (plane.hull) return true;
    const float a = dot(plane.u, point), b = dot(plane.v, point);
    return a > plane.low.x && a < plane.high.x && b > plane.low.y && b < plane.high.y;
}

Wall PlanePicture::wall_at(Vec3f point) const {
    if (!openings.any()) return Wall::solid;
    const auto cell = [&](float from_low, int count) { return std::clamp(static_cast<int>(std::floor(from_low / metres_per_pixel)), 0, count - 1); };
    return openings.wall.at(cell(dot(plane.u, point) - plane.low.x, openings.wall.width), cell(dot(plane.v, point) - plane.low.y, openings.wall.height));
}

std::vector<PlanePicture> paint_planes(const ImageColor& color, const ImageF& range, const Image<std::int16_t>& label,
                                       const ImageMask& cuts, const std::vector<ScenePlane>& planes, const Inpainter& inpainter, const Run& run) {
    std::vector<PlanePicture> pictures(planes.size());
    const EquirectSize size{range.width, range.height};
    parallel_for(static_cast<std::int64_t>(planes.size()), 1, [&](std::int64_t begin, std::int64_t) {
        const auto index = static_cast<std::size_t>(begin);
        PlanePicture picture = blank(planes[index]);
        ImageMask hole(picture.color.width, picture.color.height, std::uint8_t{1});
        bool any = false;
        for (int y = 0; y < hole.height; ++y)
            for (int x = 0; x < hole.width; ++x) {
                const Vec3f p = picture.plane.at({picture.plane.low.x + (static_cast<float>(x) + 0.5f) * picture.metres_per_pixel,
                                                  picture.plane.low.y + (static_cast<float>(y) + 0.5f) * picture.metres_per_pixel});
                const Vec2f at = pixel_of_direction(p, size);
                const int px = wrap_column(static_cast<int>(at.x), size.width), py = std::min(static_cast<int>(at.y), size.height - 1);
                const float seen = range.at(px, py), wanted = length(p);
                if (!is_inside(label, cuts, px, py, static_cast<std::int16_t>(index))) continue;
                if (!(std::fabs(seen - wanted) < 0.02f + 0.03f * wanted)) continue;
                picture.color.at(x, y) = sample_equirect(color, at);
                hole.at(x, y) = 0;
                any = true;
            }
        if (!any) picture.color = {};
        else picture.color = inpainter.fill(picture.color, hole, run);
        if (any && picture.plane.hull)
            picture.openings = find_openings(range, picture.plane, {hole.width, hole.height}, picture.metres_per_pixel);
        pictures[index] = std::move(picture);
    });
    return pictures;
}

}  // namespace fastscene
