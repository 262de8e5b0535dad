#include <algorithm>

#include "fastscene/walk/free_space.h"
#include "fastscene/walk/walk.h"

namespace fastscene {
namespace {

constexpr float kUpDown = 0.6f;  // vertical scale of the viewpoint pattern: people stand and bend, they do not fly
constexpr float kFarthest = 1e9f;

// Evenly distributed directions. 8: a cube's corners; 14: also its face centers; otherwise a spiral.
std::vector<Vec3f> spread_directions(int count) {
    std::vector<Vec3f> out;
    if (count == 8 || count == 14) {
        for (const float x : {-1.f, 1.f})
            for (const float y : {-1.f, 1.f})
                for (const float z : {-1.f, 1.f}) out.push_back(normalize(Vec3f{x, y, z}));
        if (count == 14)
            for (const float s : {-1.f, 1.f}) {
                out.push_back({s, 0, 0});
                out.push_back({0, s, 0});
                out.push_back({0, 0, s});
            }
        return out;
    }
    const float golden = std::numbers::pi_v<float> * (3.f - std::sqrt(5.f));
    for (int i = 0; i < count; ++i) {
        const float y = 1.f - 2.f * (static_cast<float>(i) + 0.5f) / static_cast<float>(count),
                    r = std::sqrt(1.f - y * y);
        const float a = golden * static_cast<float>(i);
        out.push_back({r * std::cos(a), y, r * std::sin(a)});
    }
    return out;
}

}  // namespace

std::vector<Vec3f> choose_viewpoints(const Panorama& first, const WalkParams& params) {
    if (first.range.empty()) throw Error("walk: the first panorama has no range; expected the depth stage's result");
    std::vector<Vec3f> left;
    for (Vec3f d : spread_directions(params.viewpoints)) {
        const Vec3f step = normalize(Vec3f{d.x, d.y * kUpDown, d.z});
        const float longest = std::fabs(d.y) > 0.99f ? kUpDown * params.reach_m : params.reach_m;
        left.push_back(step * std::min(longest, params.clearance * free_distance(first.range, step)));
    }
    // Ordered so that each viewpoint is the nearest to any visited one, the start included.
    std::vector<Vec3f> visited{{}};
    while (!left.empty()) {
        const auto distance = [&](const Vec3f& p) {
            float least = kFarthest;
            for (const Vec3f& v : visited) least = std::min(least, length(p - v));
            return least;
        };
        const auto next = std::min_element(left.begin(), left.end(),
                                           [&](const Vec3f& a, const Vec3f& b) { return distance(a) < distance(b); });
        visited.push_back(*next);
        left.erase(next);
    }
    visited.erase(visited.begin());
    for (Vec3f& p : visited) p = first.world_from_pano * p;
    return visited;
}

}  // namespace fastscene
