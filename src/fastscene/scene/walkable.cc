#include "fastscene/scene/walkable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fastscene/base/check.h"

namespace fastscene {
namespace {

// margin in metres that keeps projected points off the boundary, where rounding decides
constexpr double kOffBoundary_m = 1e-3;

Vec2d as_double(Vec2f p) { return {p.x, p.y}; }

template <class Take>
void each_edge(const std::vector<std::vector<Vec2f>>& rings, Take take) {
    for (const auto& ring : rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            take(as_double(ring[j]), as_double(ring[i]));
}

bool inside(const std::vector<std::vector<Vec2f>>& rings, Vec2d p) {
    bool inside = false;
    each_edge(rings, [&](Vec2d a, Vec2d b) {
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    });
    return inside;
}

double distance(const std::vector<std::vector<Vec2f>>& rings, Vec2d p) {
    double nearest = std::numeric_limits<double>::infinity();
    each_edge(rings, [&](Vec2d a, Vec2d b) {
        const Vec2d way = b - a;
        const double all = dot(way, way), t = all > 0 ? std::clamp(dot(p - a, way) / all, 0., 1.) : 0.;
        const Vec2d gap = p - (a + way * t);
        nearest = std::min(nearest, std::hypot(gap.x, gap.y));
    });
    return nearest;
}

}  // namespace

float floor_at(const WalkableArea& area, Vec2f point) {
    const Vec2d p = as_double(point);
    for (const WalkableArea::Level& level : area.levels)
        if (inside(level.rings_m, p)) return level.floor_y;
    float floor = area.floor_y;
    double nearest = std::numeric_limits<double>::infinity();
    for (const WalkableArea::Level& level : area.levels)
        if (const double far = distance(level.rings_m, p); far < nearest) nearest = far, floor = level.floor_y;
    return floor;
}

double signed_area(const std::vector<Vec2f>& ring) {
    double twice = 0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        twice += static_cast<double>(ring[j].x) * ring[i].y - static_cast<double>(ring[i].x) * ring[j].y;
    return twice / 2;
}

bool contains(const WalkableArea& area, Vec2f point) { return inside(area.rings_m, as_double(point)); }

bool contains(const WalkableArea& area, Vec3f position) {
    const Vec2f point{position.x, position.z};
    const float raised = raised_at(area, point);
    return position.y >= area.low_y - raised && position.y <= area.high_y - raised && contains(area, point);
}

Vec2f nearest_inside(const WalkableArea& area, Vec2f point) {
    if (contains(area, point)) return point;
    // Positions on either side of each edge, one of which the area contains; in a sharp corner only those farther from
    // its tip.
    std::vector<std::pair<double, Vec2f>> places;
    const Vec2d p = as_double(point);
    each_edge(area.rings_m, [&](Vec2d a, Vec2d b) {
        const Vec2d along = b - a;
        const double length = std::hypot(along.x, along.y);
        if (length < 1e-9) return;
        const Vec2d tangent = along * (1 / length), normal{-tangent.y, tangent.x};
        for (const double off_tip : {1, 8, 64}) {
            const double margin = std::min(off_tip * kOffBoundary_m, length / 2);
            const Vec2d nearest = a + tangent * std::clamp(dot(p - a, tangent), margin, length - margin);
            for (const double side : {kOffBoundary_m, -kOffBoundary_m}) {
                const Vec2d q = nearest + normal * side;
                places.push_back(
                    {std::hypot(q.x - p.x, q.y - p.y), Vec2f{static_cast<float>(q.x), static_cast<float>(q.y)}});
            }
        }
    });
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [distance, place] : places)
        if (contains(area, place)) return place;
    return point;  // no floor at all
}

Vec3f nearest_inside(const WalkableArea& area, Vec3f position) {
    const Vec2f place = nearest_inside(area, Vec2f{position.x, position.z});
    const float raised = raised_at(area, place);
    return {place.x, std::clamp(position.y, area.low_y - raised, area.high_y - raised), place.y};
}

std::size_t largest_ring(const WalkableArea& area) {
    FASTSCENE_CHECK(!area.rings_m.empty());
    const auto& rings = area.rings_m;
    const auto smaller = [](const auto& a, const auto& b) {
        return std::abs(signed_area(a)) < std::abs(signed_area(b));
    };
    return static_cast<std::size_t>(std::max_element(rings.begin(), rings.end(), smaller) - rings.begin());
}

}  // namespace fastscene
