#include "fastscene/walk/planes.h"

#include <algorithm>
#include <limits>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"

namespace fastscene {
namespace {

constexpr int kMostPlanes = 28;
constexpr int kDraws = 160;             // RANSAC hypotheses per plane
constexpr float kLeastShare = 0.0025f;  // minimum share of the sphere that a plane must cover
constexpr float kAligned = 0.9f;        // minimum cosine between a pixel's normal and its plane's
constexpr float kHullShare =
    0.03f;  // maximum share of the scene behind a hull plane, as seen through windows and doors
constexpr float kBehindPlane_m =
    // metres: farther behind a plane than this counts as behind; in a hall, farther than the tolerance of points on the
    // plane
    0.1f;
// A door, a panel, a picture's glass: parallel to a wall and at most this far in front of it, so an object on the wall
// and not the boundary of the room.
constexpr float kOnWall_m = 0.2f;
// Wall visible beside its tiles or above the cupboards forms narrow strips: layers behind a hull plane may be small.
// Anything in front of it is an object.
constexpr float kLeastLayer = 0.0005f;
constexpr float kAllAlong = 0.9f;  // share of the width or height of what was seen of the plane it lies on
constexpr int kMostLayers = 3, kLayerDraws = 64;
// Man-made surfaces are parallel to a larger plane if they nearly are. A plane tilted by more than kExact needs this
// much more support to be accepted: with few normals, or on relief, its tilt is noise.
constexpr float kExact = 0.9998f, kLeaning = 0.985f, kLeaningGains = 1.5f;

struct Sample {
    Vec3f point, normal;
    float weight;
};

Vec3f point_at(const ImageF& range, int x, int y) {
    const EquirectSize size{range.width, range.height};
    const int row = std::clamp(y, 0, range.height - 1), column = wrap_column(x, range.width);
    return direction_of_pixel(column, row, size) * range.at(column, row);
}
// Normal from central differences, facing the viewpoint; zero where there is no surface.
Vec3f normal_at(const ImageF& range, int x, int y) {
    const Vec3f across = point_at(range, x + 1, y) - point_at(range, x - 1, y);
    const Vec3f down = point_at(range, x, y + 1) - point_at(range, x, y - 1);
    const Vec3f n = normalize(cross(across, down));
    if (!std::isfinite(n.x + n.y + n.z)) return {};
    return dot(n, point_at(range, x, y)) > 0 ? -n : n;
}

std::vector<Sample> sample_scene(const ImageF& range) {
    const int step = std::max(1, range.width / 256);
    const EquirectSize size{range.width, range.height};
    std::vector<Sample> samples;
    for (int y = step / 2; y < range.height; y += step)
        for (int x = step / 2; x < range.width; x += step) {
            const Vec3f normal = normal_at(range, x, y);
            if (!std::isfinite(range.at(x, y)) || dot(normal, normal) < 0.5f) continue;
            samples.push_back({point_at(range, x, y), normal,
                               static_cast<float>(pixel_solid_angle(y, size)) * static_cast<float>(step * step)});
        }
    return samples;
}

bool belongs(const Sample& s, Vec3f normal, float offset) {
    return std::fabs(dot(normal, s.point) - offset) < plane_tolerance(length(s.point)) &&
           dot(normal, s.normal) > kAligned;
}
float support_of(const std::vector<Sample>& samples, Vec3f normal, float offset) {
    float sum = 0;
    for (const Sample& s : samples)
        if (belongs(s, normal, offset)) sum += s.weight;
    return sum;
}

// The normal of the first larger plane that is nearly parallel to this one.
Vec3f straightened(Vec3f normal, const std::vector<ScenePlane>& larger, float least_cosine) {
    for (const ScenePlane& p : larger)
        if (const float c = dot(p.normal, normal); std::fabs(c) > least_cosine) return c > 0 ? p.normal : -p.normal;
    return normal;
}

// Weighted mean of normals, then of offsets, iterated twice. Planes parallel to a larger one stay so.
void refine(const std::vector<Sample>& samples, const std::vector<ScenePlane>& larger, ScenePlane& plane) {
    const bool parallel = std::any_of(larger.begin(), larger.end(), [&](const ScenePlane& p) {
        return std::fabs(dot(p.normal, plane.normal)) > kExact;
    });
    const float least_cosine = parallel ? kLeaning : kExact;
    for (int round = 0; round < 2; ++round) {
        Vec3f normal;
        for (const Sample& s : samples)
            if (belongs(s, plane.normal, plane.offset)) normal += s.normal * s.weight;
        normal = straightened(normalize(normal), larger, least_cosine);
        double offset = 0, weight = 0;
        for (const Sample& s : samples)
            if (belongs(s, plane.normal, plane.offset)) {
                offset += static_cast<double>(dot(normal, s.point) * s.weight);
                weight += static_cast<double>(s.weight);
            }
        if (!(weight > 0)) return;
        plane.normal = normal;
        plane.offset = static_cast<float>(offset / weight);
    }
}

void measure_extent(const std::vector<Sample>& samples, ScenePlane& plane) {
    make_frame(plane.normal, plane.u, plane.v);
    plane.low = {1e9f, 1e9f};
    plane.high = {-1e9f, -1e9f};
    for (const Sample& s : samples) {
        // A wall extends as far as the room, and things on it may too; a furniture face extends only as far as it was
        // seen.
        if (!plane.hull && !plane.on_hull && !belongs(s, plane.normal, plane.offset)) continue;
        const float a = dot(plane.u, s.point), b = dot(plane.v, s.point);
        plane.low = {std::min(plane.low.x, a), std::min(plane.low.y, b)};
        plane.high = {std::max(plane.high.x, a), std::max(plane.high.y, b)};
    }
}

// Extent in metres, along the axes of `hull`, of what was seen of a plane parallel to it.
Vec2f spread_of(const std::vector<Sample>& samples, const ScenePlane& hull, float offset) {
    ScenePlane plane = hull;
    plane.hull = plane.on_hull = false;
    plane.offset = offset;
    measure_extent(samples, plane);
    return {std::max(0.f, plane.high.x - plane.low.x), std::max(0.f, plane.high.y - plane.low.y)};
}
// A wall behind tiles that is visible over their full width does not end beside a cupboard; objects in front of a wall,
// however many, do.
bool spreads_all_along(const std::vector<Sample>& samples, const ScenePlane& hull, float offset) {
    if (offset > hull.offset) return false;
    const Vec2f whole = spread_of(samples, hull, hull.offset), part = spread_of(samples, hull, offset);
    return part.x >= kAllAlong * whole.x || part.y >= kAllAlong * whole.y;
}

// Finds the next layer of a hull plane: parallel, slightly behind it, on samples that belong to no plane yet. False if
// there is none.
bool find_layer(const std::vector<Sample>& left, const ScenePlane& hull, ScenePlane& layer) {
    std::vector<Sample> near;
    for (const Sample& s : left) {
        const float before = dot(hull.normal, s.point) - hull.offset;
        if (dot(hull.normal, s.normal) > kAligned && before > -kOnWall_m && before < 0) near.push_back(s);
    }
    layer = hull;
    layer.hull = false;
    layer.on_hull = true;
    float most = 0;
    const std::size_t step = std::max<std::size_t>(1, near.size() / kLayerDraws);
    for (std::size_t i = step / 2; i < near.size(); i += step) {
        const float offset = dot(hull.normal, near[i].point), support = support_of(near, hull.normal, offset);
        if (support > most) most = support, layer.offset = offset;
    }
    if (!(most > 0)) return false;
    refine(near, {hull}, layer);
    return support_of(near, layer.normal, layer.offset) >= kLeastLayer * 4.f * std::numbers::pi_v<float>;
}

}  // namespace

std::vector<ScenePlane> find_planes(const ImageF& range, std::uint64_t seed) {
    const std::vector<Sample> all = sample_scene(range);
    std::vector<Sample> left = all;
    std::vector<ScenePlane> planes;
    const float sphere = 4.f * std::numbers::pi_v<float>;
    while (static_cast<int>(planes.size()) < kMostPlanes && !left.empty()) {
        Random random(seed, "walk/planes", planes.size());
        std::vector<Sample> few;  // every eighth sample scores the hypotheses
        for (std::size_t i = 0; i < left.size(); i += 8) few.push_back(left[i]);
        ScenePlane best;
        float most = 0;
        for (int draw = 0; draw < kDraws; ++draw) {
            const Sample& s = left[static_cast<std::size_t>(random.index(static_cast<int>(left.size())))];
            const auto judge = [&](Vec3f normal, float gains) {
                const float offset = dot(normal, s.point), support = support_of(few, normal, offset) / gains;
                if (!(support > most)) return;
                most = support;
                best = {normal, offset, false, false, false, {}, {}, {}, {}};
            };
            const Vec3f straight = straightened(s.normal, planes, kLeaning);
            judge(straight, 1);
            if (dot(straight, s.normal) < kExact) judge(s.normal, kLeaningGains);
        }
        if (!(most > 0)) break;
        refine(left, planes, best);
        if (support_of(left, best.normal, best.offset) < kLeastShare * sphere) break;
        float behind = 0;
        for (const Sample& s : all)
            if (dot(best.normal, s.point) - best.offset < -std::max(kBehindPlane_m, plane_tolerance(length(s.point))))
                behind += s.weight;
        const auto wall = std::find_if(planes.begin(), planes.end(),
                                       [&](const ScenePlane& p) { return p.hull && are_side_by_side(p, best); });
        best.on_hull = wall != planes.end();
        best.all_along = best.on_hull && spreads_all_along(all, *wall, best.offset);
        best.hull = behind < kHullShare * sphere && !best.on_hull;
        measure_extent(best.hull || best.on_hull ? all : left, best);
        std::erase_if(left, [&](const Sample& s) { return belongs(s, best.normal, best.offset); });
        planes.push_back(best);
    }
    for (std::size_t i = 0, found = planes.size(); i < found; ++i) {
        ScenePlane layer;
        for (int k = 0; k < kMostLayers && planes[i].hull && find_layer(left, planes[i], layer); ++k) {
            measure_extent(all, layer);
            layer.all_along = spreads_all_along(all, planes[i], layer.offset);
            std::erase_if(left, [&](const Sample& s) { return belongs(s, layer.normal, layer.offset); });
            planes.push_back(layer);
        }
    }
    return planes;
}

Image<std::int16_t> label_planes(const ImageF& range, const std::vector<ScenePlane>& planes) {
    Image<std::int16_t> label(range.width, range.height, std::int16_t{-1});
    parallel_for(range.height, 16, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < range.width; ++x) {
                if (!std::isfinite(range.at(x, y))) continue;
                const Vec3f p = point_at(range, x, y), n = normal_at(range, x, y);
                float nearest = plane_tolerance(range.at(x, y));
                for (std::size_t i = 0; i < planes.size(); ++i) {
                    const float off = std::fabs(dot(planes[i].normal, p) - planes[i].offset);
                    if (!(off < nearest) || dot(n, planes[i].normal) < 0.6f) continue;
                    nearest = off;
                    label.at(x, y) = static_cast<std::int16_t>(i);
                }
            }
    });
    return label;
}

}  // namespace fastscene
