#include "fastscene/walk/walkable_walk.h"

#include <algorithm>
#include <cmath>

#include "fastscene/geometry/sphere.h"

namespace fastscene {
namespace {

constexpr float kLowestEye_m = 0.6f, kTallestEye_m = 1.9f;  // eye heights: crouching, and a tall adult
// Inpainted pixels have the right mean but wrong details: beyond this share of the view it becomes visible.
constexpr double kHolds = 0.15;
constexpr float kBeyond_m = 0.1f;  // margin in metres beyond the acceptable viewpoints

float turn(Vec2f a, Vec2f b, Vec2f c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// Convex hull by Andrew's monotone chain (1979), counterclockwise with x to the right and z up.
std::vector<Vec2f> convex_hull(std::vector<Vec2f> points) {
    std::sort(points.begin(), points.end(), [](Vec2f a, Vec2f b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<Vec2f> hull;
    const auto chain = [&](auto begin, auto end) {
        const std::size_t start = hull.size();
        for (auto it = begin; it != end; ++it) {
            while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), *it) <= 0) hull.pop_back();
            hull.push_back(*it);
        }
        hull.pop_back();  // the next chain starts with it
    };
    chain(points.begin(), points.end());
    chain(points.rbegin(), points.rend());
    return hull;
}

}  // namespace

WalkableArea walkable_room(const StandableFloor& floor) {
    WalkableArea area{outlines(floor), floor.floor_y - kTallestEye_m, floor.floor_y - kLowestEye_m, floor.floor_y};
    if (const std::vector<float> levels = levels_of(floor); levels.size() > 1 || levels[0] != floor.floor_y)
        for (const float y : levels) area.levels.push_back({outlines(at_level(floor, y)), y});
    return area;
}

Invention invention_of(const Panorama& panorama) {
    Invention out{panorama.world_from_pano.translation};
    if (panorama.known.empty()) return out;
    const EquirectSize size = panorama.size();
    double all = 0;
    for (int y = 0; y < size.height; ++y) {
        const double angle = pixel_solid_angle(y, size);
        for (int x = 0; x < size.width; ++x) {
            const Known known = panorama.known.at(x, y);
            all += angle;
            if (known == Known::invented) out.invented_share += angle;
            if (known == Known::carried) out.carried_share += angle;
        }
    }
    out.invented_share /= all, out.carried_share /= all;
    return out;
}

Json to_json(const std::vector<Invention>& inventions) {
    Json out = Json::array();
    for (const Invention& i : inventions)
        out.push_back({{"position_m", {i.position_m.x, i.position_m.y, i.position_m.z}},
                       {"invented_share", i.invented_share},
                       {"carried_share", i.carried_share}});
    return out;
}

WalkableArea walkable_of(const std::vector<Invention>& inventions, float floor_y) {
    // A square around each acceptable viewpoint; panorama 0 always counts.
    std::vector<Vec2f> corners;
    float low = 0, high = 0;
    const auto add = [&](Vec3f p) {
        for (const float dx : {-kBeyond_m, kBeyond_m})
            for (const float dz : {-kBeyond_m, kBeyond_m}) corners.push_back({p.x + dx, p.z + dz});
        low = std::min(low, p.y), high = std::max(high, p.y);
    };
    add({});
    for (const Invention& i : inventions)
        if (i.invented_share + i.carried_share <= kHolds) add(i.position_m);
    return {
        {convex_hull(std::move(corners))}, low - kBeyond_m, std::min(high + kBeyond_m, floor_y - kBeyond_m), floor_y};
}

float floor_below(const Panorama& first) {
    const ImageF& range = first.range;
    constexpr float kUsual_m = 1.5f;  // camera height in metres if the range straight down is unknown
    std::vector<float> down;
    for (int y = range.height - std::max(1, range.height / 36); y < range.height; ++y)
        for (int x = 0; x < range.width; ++x) {
            const float r = range.at(x, y);
            if (std::isfinite(r) && r > 0) down.push_back(direction_of_pixel(x, y, {range.width, range.height}).y * r);
        }
    if (down.empty()) return kUsual_m;
    std::nth_element(down.begin(), down.begin() + static_cast<std::ptrdiff_t>(down.size() / 2), down.end());
    return down[down.size() / 2];
}

}  // namespace fastscene
