#include "fastscene/walk/planes.h"

#include <algorithm>
#include <limits>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"

namespace fastscene {
namespace {

constexpr int kMostPlanes = 28;
constexpr int kDraws = 160;                // hypotheses a plane
constexpr float kLeastShare = 0.0025f;     // of the sphere that a plane must cover
constexpr float kAligned = 0.9f;           // cosine between a pixel's normal and its plane's
constexpr float kHullShare = 0.03f;        // of the scene may lie behind a hull plane: what windows and doors show
// A door, a panel, a picture's glass: parallel to a wall and this near to it, so a thing on the wall and not where the room ends.
constexpr float kOnWall_m = 0.2f, kOnWallAligned = 0.97f;

struct Sample {
    Vec3f point, normal;
    float weight;
};

Vec3f point_at(const ImageF& range, int x, int y) {
    const EquirectSize size{range.width, range.height};
    const int row = std::clamp(y, 0, range.height - 1), column = wrap_column(x, range.width);
    return direction_of_pixel(column, row, size) * range.at(column, row);
}
// Normal from the differences to both sides, towards the viewpoint; zero where there is no surface.
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
            samples.push_back({point_at(range, x, y), normal, static_cast<float>(pixel_solid_angle(y, size)) * static_cast<float>(step * step)});
        }
    return samples;
}

bool belongs(const Sample& s, Vec3f normal, float offset) {
    return std::fabs(dot(normal, s.point) - offset) < plane_tolerance(length(s.point)) && dot(normal, s.normal) > kAligned;
}
float support_of(const std::vector<Sample>& samples, Vec3f normal, float offset) {
    float sum = 0;
    for (const Sample& s : samples)
        if (belongs(s, normal, offset)) sum += s.weight;
    return sum;
}

// Weighted mean of normals, then of offsets: twice is enough.
void refine(const std::vector<Sample>& samples, ScenePlane& plane) {
    for (int round = 0; round < 2; ++round) {
        Vec3f normal;
        for (const Sample& s : samples)
            if (belongs(s, plane.normal, plane.offset)) normal += s.normal * s.weight;
        normal = normalize(normal);
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
        // A wall goes on wherever the room does; a face of furniture only as far as it was seen.
        if (!plane.hull && !belongs(s, plane.normal, plane.offset)) continue;
        const float a = dot(plane.u, s.point), b = dot(plane.v, s.point);
        plane.low = {std::min(plane.low.x, a), std::min(plane.low.y, b)};
        plane.high = {std::max(plane.high.x, a), std::max(plane.high.y, b)};
    }
}

}  // namespace

std::vector<ScenePlane> find_planes(const ImageF& range, std::uint64_t seed) {
    const std::vector<Sample> all = sample_scene(range);
    std::vector<Sample> left = all;
    std::vector<ScenePlane> planes;
    const float sphere = 4.f * std::numbers::pi_v<float>;
    while (static_cast<int>(planes.size()) < kMostPlanes && !left.empty()) {
        Random random(seed, "walk/planes", planes.size());
        std::vector<Sample> few;   // every eighth sample judges the hypotheses
        for (std::size_t i = 0; i < left.size(); i += 8) few.push_back(left[i]);
        ScenePlane best;
        float most = 0;
        for (int draw = 0; draw < kDraws; ++draw) {
            const Sample& s = left[static_cast<std::size_t>(random.index(static_cast<int>(left.size())))];
            const float offset = dot(s.normal, s.point), support = support_of(few, s.normal, offset);
            if (support > most) {
                most = support;
                best = {s.normal, offset, false, {}, {}, {}, {}};
            }
        }
        if (!(most > 0)) break;
        refine(left, best);
        if (support_of(left, best.normal, best.offset) < kLeastShare * sphere) break;
        float behind = 0;
        for (const Sample& s : all)
            if (dot(best.normal, s.point) - best.offset < -0.1f) behind += s.weight;
        const bool on_wall = std::any_of(planes.begin(), planes.end(), [&](const ScenePlane& wall) {
            return wall.hull && dot(wall.normal, best.normal) > kOnWallAligned && std::fabs(wall.offset - best.offset) < kOnWall_m;
        });
        best.hull = behind < kHullShare * sphere && !on_wall;
        measure_extent(best.hull ? all : left, best);
        std::erase_if(left, [&](const Sample& s) { return belongs(s, best.normal, best.offset); });
        planes.push_back(best);
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
