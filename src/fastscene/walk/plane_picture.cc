#include "fastscene/walk/plane_picture.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/range_edges.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/walk/repeats.h"

namespace fastscene {
namespace {

constexpr float kReach_m = 8.f;  // metres: extent of a plane's picture on each side of panorama 0,
// or this many times the plane's distance, if larger: walls of a hall are visible beyond 8 m
constexpr float kReach = 2.f;
constexpr int kLongestSide = 640;
constexpr float kMargin_m =
    // metres: how far a furniture face is extended into its hidden part; tuned on walks through rooms with ground truth
    0.3f;
constexpr float kWidestGap_m = 0.8f;  // metres: widest hidden part that is bridged between two seen ones

PlanePicture blank(ScenePlane plane) {
    PlanePicture picture{plane, 0.01f, {}, {}, {}, {}};
    Vec2f& low = picture.plane.low;
    Vec2f& high = picture.plane.high;
    const float reach = std::max(kReach_m, kReach * -plane.offset);
    low = {std::max(low.x - kMargin_m, -reach), std::max(low.y - kMargin_m, -reach)};
    high = {std::min(high.x + kMargin_m, reach), std::min(high.y + kMargin_m, reach)};
    const float longest = std::max(high.x - low.x, high.y - low.y);
    if (!(longest > 0.02f)) return picture;
    picture.metres_per_pixel = std::max(0.01f, longest / kLongestSide);
    const auto pixels = [&](float metres) {
        return std::max(2, static_cast<int>(std::ceil(metres / picture.metres_per_pixel)));
    };
    picture.color = ImageColor(pixels(high.x - low.x), pixels(high.y - low.y));
    return picture;
}

// Whether all pixels around (x, y) are on the plane. Pixels next to a crease or silhouette contain color from across
// it.
bool is_inside(const Image<std::int16_t>& label, const ImageMask& cuts, int x, int y, std::int16_t index) {
    if (cuts.at(x, y) & kFarSide) return false;
    for (int j = std::max(0, y - 1); j <= std::min(label.height - 1, y + 1); ++j)
        for (int i = x - 1; i <= x + 1; ++i)
            if (label.at(wrap_column(i, label.width), j) != index) return false;
    return true;
}

enum class Place : std::uint8_t {
    seen,
    hidden,
    empty
};  // empty: panorama 0 saw past the plane there, or saw another plane close to it

// Classifies the point `p` of a plane by what panorama 0 shows in pixel (x, y): the plane itself, an occluder, or empty
// space.
Place place_at(Vec3f p, std::size_t index, const std::vector<ScenePlane>& planes, const ImageF& range,
               const Image<std::int16_t>& label, int x, int y) {
    const ScenePlane& plane = planes[index];
    const int there = label.at(x, y);
    const float far = length(p), seen = range.at(x, y),
                behind = (seen / far - 1.f) * -plane.offset;  // along the normal
    if (there == static_cast<int>(index) && std::fabs(seen - far) < 0.02f + 0.03f * far) return Place::seen;
    const bool beside = there >= 0 && there != static_cast<int>(index) &&
                        are_side_by_side(planes[static_cast<std::size_t>(there)], plane);
    return beside || behind > plane_tolerance(far) ? Place::empty : Place::hidden;
}

// Distance in metres from each position to the nearest `goal` without crossing `barred` ones (infinite if there is
// none): a chamfer distance transform with steps of 3 and, diagonally, 4 thirds of a pixel (Borgefors 1986).
ImageF distance_to(Place goal, const Image<Place>& places, float metres_per_pixel, std::optional<Place> barred = {}) {
    constexpr int kStraight = 3, kDiagonal = 4;
    constexpr int kNever = std::numeric_limits<int>::max();
    Image<int> least(places.width, places.height, kNever);
    std::array<std::vector<std::pair<int, int>>, kDiagonal + 1> rounds;  // circular buckets by distance
    std::size_t waiting = 0;
    for (int y = 0; y < places.height; ++y)
        for (int x = 0; x < places.width; ++x)
            if (places.at(x, y) == goal) least.at(x, y) = 0, rounds[0].push_back({x, y}), ++waiting;
    for (int distance = 0; waiting > 0; ++distance) {
        auto& now = rounds[static_cast<std::size_t>(distance % (kDiagonal + 1))];
        for (const auto& [x, y] : now)
            for (int j = std::max(0, y - 1); least.at(x, y) == distance && j <= std::min(places.height - 1, y + 1); ++j)
                for (int i = std::max(0, x - 1); i <= std::min(places.width - 1, x + 1); ++i) {
                    const int further = distance + (i != x && j != y ? kDiagonal : kStraight);
                    if (further >= least.at(i, j) || places.at(i, j) == barred) continue;
                    least.at(i, j) = further;
                    rounds[static_cast<std::size_t>(further % (kDiagonal + 1))].push_back({i, j});
                    ++waiting;
                }
        waiting -= now.size();
        now.clear();
    }
    ImageF out(places.width, places.height);
    for (std::size_t i = 0; i < out.size(); ++i)
        out.pixels[i] = least.pixels[i] == kNever ? std::numeric_limits<float>::infinity()
                                                  : static_cast<float>(least.pixels[i]) * metres_per_pixel / kStraight;
    return out;
}

// Several objects may share a plane (the seats of two chairs). Each is extended slightly past where it was seen, and
// gaps between seen parts are closed if narrow, but never across a position where panorama 0 saw past the plane, nor to
// positions closer to such an empty one than to a seen one: the occluder of a seat's edge also hides the empty space
// beyond. On a wall, floor or ceiling only things that lie on it are extended: frames are slender, and panes are seen
// through.
ImageMask face_of(const ScenePlane& plane, const Image<Place>& places, const ImageF& unseen_m, float metres_per_pixel) {
    const int gap = static_cast<int>(kWidestGap_m / metres_per_pixel);
    ImageMask face(places.width, places.height);
    for (std::size_t i = 0; i < face.size(); ++i) face.pixels[i] = unseen_m.pixels[i] <= kMargin_m;
    const auto bridge = [&](int count, auto&& place, auto&& mark) {  // a single line
        for (int i = 0, last = -1; i < count; ++i) {
            if (place(i) == Place::empty) last = -1;
            if (place(i) != Place::seen) continue;
            if (last >= 0 && i - last <= gap)
                for (int k = last + 1; k < i; ++k) mark(k);
            last = i;
        }
    };
    for (int y = 0; y < places.height; ++y)
        bridge(
            places.width, [&](int x) { return places.at(x, y); }, [&](int x) { face.at(x, y) = 1; });
    for (int x = 0; x < places.width; ++x)
        bridge(
            places.height, [&](int y) { return places.at(x, y); }, [&](int y) { face.at(x, y) = 1; });
    if (plane.on_hull) return face;
    const ImageF empty_m = distance_to(Place::empty, places, metres_per_pixel);
    for (std::size_t i = 0; i < face.size(); ++i)
        if (empty_m.pixels[i] < unseen_m.pixels[i]) face.pixels[i] = 0;
    return face;
}

}  // namespace

Vec3f PlanePicture::color_at(Vec3f point) const {
    return sample_flat(color, {(dot(plane.u, point) - plane.low.x) / metres_per_pixel,
                               (dot(plane.v, point) - plane.low.y) / metres_per_pixel});
}

bool PlanePicture::reaches(Vec3f point) const {
    if (plane.hull) return true;
    if (plane.all_along && std::isfinite(unseen_at(point))) return true;
    const float a = (dot(plane.u, point) - plane.low.x) / metres_per_pixel,
                b = (dot(plane.v, point) - plane.low.y) / metres_per_pixel;
    if (!(a >= 0 && b >= 0 && a < static_cast<float>(face.width) && b < static_cast<float>(face.height))) return false;
    return face.at(static_cast<int>(a), static_cast<int>(b)) != 0;
}

float PlanePicture::unseen_at(Vec3f point) const {
    const auto cell = [&](float from_low, int count) {
        return std::clamp(static_cast<int>(std::floor(from_low / metres_per_pixel)), 0, count - 1);
    };
    return unseen_m.at(cell(dot(plane.u, point) - plane.low.x, unseen_m.width),
                       cell(dot(plane.v, point) - plane.low.y, unseen_m.height));
}

Wall PlanePicture::wall_at(Vec3f point) const {
    if (!openings.any()) return Wall::solid;
    const auto cell = [&](float from_low, int count) {
        return std::clamp(static_cast<int>(std::floor(from_low / metres_per_pixel)), 0, count - 1);
    };
    return openings.wall.at(cell(dot(plane.u, point) - plane.low.x, openings.wall.width),
                            cell(dot(plane.v, point) - plane.low.y, openings.wall.height));
}

std::vector<PlanePicture> paint_planes(const ImageColor& color, const ImageF& range, const Image<std::int16_t>& label,
                                       const ImageMask& cuts, const std::vector<ScenePlane>& planes,
                                       const Inpainter& inpainter, const Run& run) {
    std::vector<PlanePicture> pictures(planes.size());
    const EquirectSize size{range.width, range.height};
    parallel_for(static_cast<std::int64_t>(planes.size()), 1, [&](std::int64_t begin, std::int64_t) {
        const auto index = static_cast<std::size_t>(begin);
        PlanePicture picture = blank(planes[index]);
        ImageMask hole(picture.color.width, picture.color.height, std::uint8_t{1});
        Image<Place> places(hole.width, hole.height);
        bool any = false;
        for (int y = 0; y < hole.height; ++y)
            for (int x = 0; x < hole.width; ++x) {
                const Vec3f p = picture.plane.at(
                    {picture.plane.low.x + (static_cast<float>(x) + 0.5f) * picture.metres_per_pixel,
                     picture.plane.low.y + (static_cast<float>(y) + 0.5f) * picture.metres_per_pixel});
                const Vec2f at = pixel_of_direction(p, size);
                const int px = wrap_column(static_cast<int>(at.x), size.width),
                          py = std::min(static_cast<int>(at.y), size.height - 1);
                const float seen = range.at(px, py), wanted = length(p);
                places.at(x, y) = place_at(p, index, planes, range, label, px, py);
                if (!is_inside(label, cuts, px, py, static_cast<std::int16_t>(index))) continue;
                if (!(std::fabs(seen - wanted) < 0.02f + 0.03f * wanted)) continue;
                picture.color.at(x, y) = sample_equirect(color, at);
                hole.at(x, y) = 0;
                any = true;
            }
        if (any) {
            fill_from_repeats(picture.color, hole, picture.metres_per_pixel);
            picture.color = inpainter.fill(picture.color, hole, run);
            picture.unseen_m = distance_to(Place::seen, places, picture.metres_per_pixel, Place::empty);
            if (picture.plane.hull)
                picture.openings = find_openings(range, picture.plane, {hole.width, hole.height},
                                                 picture.metres_per_pixel);
            else picture.face = face_of(picture.plane, places, picture.unseen_m, picture.metres_per_pixel);
        } else {
            picture.color = {};
        }
        pictures[index] = std::move(picture);
    });
    return pictures;
}

}  // namespace fastscene
