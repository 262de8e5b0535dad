#include "fastscene/walk/complete.h"

#include <algorithm>
#include <array>
#include <limits>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/cubemap.h"

namespace fastscene {
namespace {

constexpr float kNearShare = 0.8f;  // share of the rim's far range: anything nearer counts as foreground
constexpr int kRim = 2;             // width in pixels of a hole's rim
constexpr std::size_t kMostHits = 64;
constexpr int kOpeningSteps = 6;  // samples along the way through a wall
constexpr float kThickestWall_m = 0.6f;
constexpr float kNearer_m =
    0.02f;  // of side-by-side planes the one seen at closer range is preferred, if by at least this much
constexpr float kFaceFov_deg = 100.f;  // cube faces overlap, so that their borders do not show in a fill

// Whether panorama 0 would have seen this point if it were on a surface: then the space there is empty.
bool is_known_free(Vec3f p, const ImageF& range) {
    const EquirectSize size{range.width, range.height};
    const Vec2f at = pixel_of_direction(p, size);
    const float seen = range.at(wrap_column(static_cast<int>(at.x), size.width),
                                std::min(static_cast<int>(at.y), size.height - 1));
    return length(p) < 0.97f * seen - 0.02f;
}

// Where a ray ends, according to the planes.
struct Ending {
    enum What { unknown, surface, sky } what = unknown;
    float range = 0;
    std::int16_t plane = kNoPlane;
    Vec3f color;
};

Ending on_surface(Vec3f p, float range, std::size_t plane, const WalkWorld& world) {
    return {Ending::surface, range, static_cast<std::int16_t>(plane), world.planes[plane].color_at(p)};
}

// What a ray hits after it has passed wall `index` through an opening at range t: the opening's reveal, or the outside.
Ending beyond_opening(Vec3f position, Vec3f d, float t, std::size_t index, const WalkWorld& world) {
    const PlanePicture& wall = world.planes[index];
    const float towards = -dot(wall.plane.normal, d);
    bool sky = wall.wall_at(position + d * t) == Wall::sky;
    for (int step = 1; step <= kOpeningSteps; ++step) {
        const float deep = t + wall.openings.depth_m / towards * static_cast<float>(step) / kOpeningSteps;
        const Vec3f p = position + d * deep;
        if (wall.wall_at(p) == Wall::solid && !is_known_free(p, world.first_range))
            return on_surface(p, deep, index, world);
        sky |= wall.wall_at(p) == Wall::sky;
    }
    return sky ? Ending{Ending::sky, std::numeric_limits<float>::infinity(), kNoPlane, {}} : Ending{};
}

using Hits = std::array<std::pair<float, std::size_t>, kMostHits>;  // (range, plane index), nearest first

bool is_open(Vec3f p, std::size_t index, const WalkWorld& world) {
    return is_known_free(p, world.first_range) ||
           (world.planes[index].plane.hull && world.planes[index].wall_at(p) != Wall::solid);
}

// Index of hit k, or of one just behind it that is more likely to be there.
std::size_t likeliest(const Hits& hits, std::size_t count, std::size_t k, Vec3f position, Vec3f d,
                      const WalkWorld& world) {
    const ScenePlane& first = world.planes[hits[k].second].plane;
    std::size_t best = k;
    float least = world.planes[hits[k].second].unseen_at(position + d * hits[k].first);
    for (std::size_t j = k + 1; j < count; ++j) {
        const PlanePicture& other = world.planes[hits[j].second];
        const Vec3f p = position + d * hits[j].first;
        if (!are_side_by_side(other.plane, first) || is_open(p, hits[j].second, world)) continue;
        if (const float unseen = other.unseen_at(p); unseen < least - kNearer_m) least = unseen, best = j;
    }
    return best;
}

// Follows a ray through the planes. Furniture faces end where they were last seen; the room ends at the first wall,
// unless panorama 0 saw through it.
Ending follow(Vec3f position, Vec3f d, const WalkWorld& world) {
    Hits hits;
    std::size_t count = 0;
    for (std::size_t i = 0; i < world.planes.size() && count < kMostHits; ++i) {
        const PlanePicture& picture = world.planes[i];
        const float towards = dot(picture.plane.normal, d);
        if (picture.empty() || !(towards < -1e-3f)) continue;
        const float t = (picture.plane.offset - dot(picture.plane.normal, position)) / towards;
        if (t > 0.02f && picture.reaches(position + d * t)) hits[count++] = {t, i};
    }
    std::sort(hits.begin(), hits.begin() + static_cast<std::ptrdiff_t>(count));
    float room_ends = std::numeric_limits<float>::infinity();
    for (std::size_t k = 0; k < count && hits[k].first < room_ends; ++k) {
        const auto [t, index] = hits[k];
        const Vec3f p = position + d * t;
        const bool hull = world.planes[index].plane.hull;
        if (!is_open(p, index, world)) {
            const auto [range, plane] = hits[likeliest(hits, count, k, position, d, world)];
            return on_surface(position + d * range, range, plane, world);
        }
        if (!hull || !world.planes[index].openings.any()) continue;
        const Ending ending = beyond_opening(position, d, t, index, world);
        if (ending.what != Ending::unknown) return ending;
        room_ends = std::min(room_ends, t + kThickestWall_m);
    }
    return {};
}

bool fill_from_planes(CoarseView& view, int x, int y, Vec3f position, const WalkWorld& world) {
    const EquirectSize size{view.color.width, view.color.height};
    const Vec3f d = direction_of_pixel(x, y, size);
    const Ending ending = follow(position, d, world);
    if (view.cover.at(x, y) == Cover::guess && ending.what != Ending::surface) return true;
    if (ending.what == Ending::unknown) return false;
    view.range.at(x, y) = ending.range;
    view.plane.at(x, y) = ending.plane;
    view.color.at(x, y) = ending.what == Ending::surface ? ending.color : world.outside.at(x, y);
    return true;
}

// Marks known pixels on the rim of each connected hole that are clearly nearer than most of the rim: foreground, which
// must not be extended into the hole.
void mark_foreground(const CoarseView& view, const ImageMask& rest, const ImageMask& unknown, ImageMask& foreground) {
    const int w = rest.width, h = rest.height;
    ImageMask visited(w, h);
    for (int sy = 0; sy < h; ++sy)
        for (int sx = 0; sx < w; ++sx) {
            if (!rest.at(sx, sy) || visited.at(sx, sy)) continue;
            std::vector<std::pair<int, int>> stack{{sx, sy}}, rim;
            visited.at(sx, sy) = 1;
            while (!stack.empty()) {
                const auto [x, y] = stack.back();
                stack.pop_back();
                for (int j = std::max(0, y - kRim); j <= std::min(h - 1, y + kRim); ++j)
                    for (int i = x - kRim; i <= x + kRim; ++i) {
                        const int c = wrap_column(i, w);
                        if (!unknown.at(c, j)) rim.push_back({c, j});
                        else if (rest.at(c, j) && !visited.at(c, j)) {
                            visited.at(c, j) = 1;
                            stack.push_back({c, j});
                        }
                    }
            }
            if (rim.empty()) continue;
            std::vector<float> ranges;
            for (const auto& [x, y] : rim) ranges.push_back(view.range.at(x, y));
            const auto far = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() * 7 / 10);
            std::nth_element(ranges.begin(), far, ranges.end());
            for (const auto& [x, y] : rim)
                if (view.range.at(x, y) < kNearShare * *far) foreground.at(x, y) = 1;
        }
}

// Of a face's pixels, those without a known surface: holes and the outside.
ImageMask without_outside(const ImageMask& hole, const ImageColor& inverse) {
    ImageMask out = hole;
    for (std::size_t i = 0; i < out.size(); ++i) out.pixels[i] |= inverse.pixels[i].x <= 1.f / kFarthestRange;
    return out;
}
bool has(const ImageMask& mask, bool value) {
    return std::any_of(mask.pixels.begin(), mask.pixels.end(), [=](std::uint8_t v) { return (v != 0) == value; });
}

// Fills the pixels that no plane explains: color and inverse range are extended from the far rim, one cube face at a
// time. Nothing exists between a window frame and the outside, so where both are near, a pixel gets assigned to the one
// that the interpolated value is closer to.
void fill_rest(CoarseView& view, const ImageMask& rest, const WalkWorld& world, const Run& run) {
    const int w = rest.width, h = rest.height;
    const EquirectSize size{w, h};
    ImageMask avoid = rest;
    {
        ImageMask foreground(w, h);
        mark_foreground(view, rest, rest, foreground);
        for (std::size_t i = 0; i < avoid.size(); ++i) avoid.pixels[i] |= foreground.pixels[i];
    }
    // Faces that contain a hole, even one narrower than a pixel of the face.
    std::array<bool, std::size(kCubeFaces)> needed{};
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            if (rest.at(x, y))
                needed[static_cast<std::size_t>(face_of_direction(direction_of_pixel(x, y, size)))] = true;
    const auto reference = make_inpainter("harmonic");  // range is always interpolated, never painted
    const int face_size = std::max(16, w / 4);
    const Pinhole camera = Pinhole::with_fov(face_size, face_size, kFaceFov_deg);
    for (const CubeFace face : kCubeFaces) {
        run.check_stop();
        if (!needed[static_cast<std::size_t>(face)]) continue;
        const Mat3f pano_from_camera = pano_from_face(face);
        ImageColor color(face_size, face_size), inverse(face_size, face_size);
        ImageMask hole(face_size, face_size);
        for (int y = 0; y < face_size; ++y)
            for (int x = 0; x < face_size; ++x) {
                const Vec2f at = pixel_of_direction(
                    pano_from_camera *
                        camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}),
                    size);
                const int px = wrap_column(static_cast<int>(at.x), w), py = std::min(static_cast<int>(at.y), h - 1);
                const float q = inverse_range(view.range.at(px, py));
                color.at(x, y) = view.color.at(px, py);
                inverse.at(x, y) = {q, q, q};
                hole.at(x, y) = avoid.at(px, py);
            }
        color = world.inpainter->fill(color, hole, run);
        ImageColor surfaces;  // inverse range without the outside; empty if there is no outside, or nothing else
        if (const ImageMask open = without_outside(hole, inverse);
            !world.outside.empty() && open != hole && has(open, false))
            surfaces = reference->fill(inverse, open, run);
        inverse = reference->fill(inverse, hole, run);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                if (!rest.at(x, y)) continue;
                const Vec3f d = direction_of_pixel(x, y, size);
                if (face_of_direction(d) != face) continue;
                const Vec2f at = *camera.project(transpose(pano_from_camera) * d);
                view.plane.at(x, y) = kNoPlane;
                float q = sample_flat(inverse, at).x;
                if (!surfaces.empty()) {
                    const float surface = sample_flat(surfaces, at).x;
                    if (q < 0.5f * surface) {
                        view.color.at(x, y) = world.outside.at(x, y),
                                         view.range.at(x, y) = std::numeric_limits<float>::infinity();
                        continue;
                    }
                    q = surface;
                }
                view.color.at(x, y) = sample_flat(color, at);
                view.range.at(x, y) = 1.f / std::max(q, 1.f / kFarthestRange);
            }
    }
}

}  // namespace

void complete_holes(CoarseView& view, const ImageMask& hole, Vec3f position, const WalkWorld& world, const Run& run) {
    ImageMask rest(hole.width, hole.height);
    parallel_for(hole.height, 16, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < hole.width; ++x) {
                if (!hole.at(x, y) || (view.cover.at(x, y) != Cover::hole && view.cover.at(x, y) != Cover::guess))
                    continue;  // backs and bridges keep their values
                rest.at(x, y) = !fill_from_planes(view, x, y, position, world);
            }
    });
    if (std::any_of(rest.pixels.begin(), rest.pixels.end(), [](std::uint8_t v) { return v != 0; }))
        fill_rest(view, rest, world, run);
}

}  // namespace fastscene
