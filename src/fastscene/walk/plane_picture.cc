#include "fastscene/walk/plane_picture.h"

#include <algorithm>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/range_edges.h"
#include "fastscene/geometry/reproject.h"

namespace fastscene {
namespace {

constexpr float kReach_m = 8.f;        // a plane's picture ends here on each side of panorama 0
constexpr int kLongestSide = 640;
constexpr float kMargin_m = 0.3f;      // hidden part of a furniture face that we believe in; chosen on walked rooms with known truth
constexpr float kWidestGap_m = 0.8f;   // hidden part between two seen ones

PlanePicture blank(ScenePlane plane) {
    PlanePicture picture{plane, 0.01f, {}, {}, {}};
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

// Steps to the last nonzero pixel before each pixel of a line, in both directions; `far` where there is none.
struct Steps {
    std::vector<int> before, after;
};
template <class SeenAt>
Steps steps_along(int n, int far, SeenAt seen_at) {
    Steps out{std::vector<int>(static_cast<std::size_t>(n)), std::vector<int>(static_cast<std::size_t>(n))};
    for (int i = 0, steps = far; i < n; ++i) out.before[static_cast<std::size_t>(i)] = steps = seen_at(i) ? 0 : std::min(far, steps + 1);
    for (int i = n - 1, steps = far; i >= 0; --i) out.after[static_cast<std::size_t>(i)] = steps = seen_at(i) ? 0 : std::min(far, steps + 1);
    return out;
}

// Several things may share a plane (the seats of two chairs): each goes on a little past where it was seen, and
// between places seen that are not far apart.
ImageMask face_of(const ImageMask& hole, float metres_per_pixel) {
    const int margin = static_cast<int>(kMargin_m / metres_per_pixel), gap = static_cast<int>(kWidestGap_m / metres_per_pixel), far = 1 << 20;
    ImageMask face(hole.width, hole.height), beside(hole.width, hole.height);
    for (int y = 0; y < hole.height; ++y) {
        const Steps steps = steps_along(hole.width, far, [&](int x) { return !hole.at(x, y); });
        for (int x = 0; x < hole.width; ++x) {
            const int before = steps.before[static_cast<std::size_t>(x)], after = steps.after[static_cast<std::size_t>(x)];
            beside.at(x, y) = std::min(before, after) <= margin;
            face.at(x, y) = before + after <= gap;
        }
    }
    for (int x = 0; x < hole.width; ++x) {
        const Steps seen = steps_along(hole.height, far, [&](int y) { return !hole.at(x, y); });
        const Steps near = steps_along(hole.height, far, [&](int y) { return beside.at(x, y) != 0; });
        for (int y = 0; y < hole.height; ++y) {
            const auto i = static_cast<std::size_t>(y);
            if (seen.before[i] + seen.after[i] <= gap || std::min(near.before[i], near.after[i]) <= margin) face.at(x, y) = 1;
        }
    }
    return face;
}

}  // namespace

Vec3f PlanePicture::color_at(Vec3f point) const {
    return sample_flat(color, {(dot(plane.u, point) - plane.low.x) / metres_per_pixel, (dot(plane.v, point) - plane.low.y) / metres_per_pixel});
}

bool PlanePicture::reaches(Vec3f point) const {
    if (plane.hull) return true;
    const float a = (dot(plane.u, point) - plane.low.x) / metres_per_pixel, b = (dot(plane.v, point) - plane.low.y) / metres_per_pixel;
    if (!(a >= 0 && b >= 0 && a < static_cast<float>(face.width) && b < static_cast<float>(face.height))) return false;
    return face.at(static_cast<int>(a), static_cast<int>(b)) != 0;
}

Wall PlanePicture::wall_at(Vec3f point) const {
    if (!openings.any()) return Wall::solid;
    const auto cell = [&](float from_low, int count) { return std::clamp(static_cast<int>(std::floor(from_low / metres_per_pixel)), 0, count - 1); };
    return openings.wall.at(cell(dot(plane.u, point) - plane.low.x, openings.wall.width),
                            cell(dot(plane.v, point) - plane.low.y, openings.wall.height));
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
        if (any && !picture.plane.hull) picture.face = face_of(hole, picture.metres_per_pixel);
        if (any && picture.plane.hull)
            picture.openings = find_openings(range, picture.plane, {hole.width, hole.height}, picture.metres_per_pixel);
        pictures[index] = std::move(picture);
    });
    return pictures;
}

}  // namespace fastscene
