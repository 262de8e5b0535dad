#include "fastscene/walk/openings.h"

#include <algorithm>
#include <deque>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/reproject.h"

namespace fastscene {
namespace {

constexpr float kBehind_m = 0.03f;        // a surface this far behind a wall was seen through it
constexpr float kDeepestReveal_m = 0.6f;  // maximum wall thickness

// Propagates the nearest known value to unknown positions (those without an entry in `known`): one step per round,
// sources in order.
void spread(Image<Wall>& wall, ImageMask& known) {
    std::deque<std::pair<int, int>> queue;
    for (int y = 0; y < wall.height; ++y)
        for (int x = 0; x < wall.width; ++x)
            if (known.at(x, y)) queue.push_back({x, y});
    while (!queue.empty()) {
        const auto [x, y] = queue.front();
        queue.pop_front();
        const auto visit = [&](int i, int j) {
            if (i < 0 || j < 0 || i >= wall.width || j >= wall.height || known.at(i, j)) return;
            known.at(i, j) = 1;
            wall.at(i, j) = wall.at(x, y);
            queue.push_back({i, j});
        };
        visit(x - 1, y);
        visit(x + 1, y);
        visit(x, y - 1);
        visit(x, y + 1);
    }
}

}  // namespace

Openings find_openings(const ImageF& range, const ScenePlane& plane, EquirectSize grid, float metres_per_pixel) {
    const EquirectSize size{range.width, range.height};
    Openings out{Image<Wall>(grid.width, grid.height, Wall::solid), 0};
    ImageMask known(grid.width, grid.height);
    std::vector<float> depths;
    bool any = false;
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
            const Vec3f p = plane.at({plane.low.x + (static_cast<float>(x) + 0.5f) * metres_per_pixel,
                                      plane.low.y + (static_cast<float>(y) + 0.5f) * metres_per_pixel});
            const Vec2f at = pixel_of_direction(p, size);
            const float seen = range.at(wrap_column(static_cast<int>(at.x), size.width),
                                        std::min(static_cast<int>(at.y), size.height - 1));
            // How far the visible surface lies behind the plane; beyond the wall's own roughness it is an opening.
            const float behind = (seen / length(p) - 1.f) * -plane.offset;
            if (behind < -plane_tolerance(length(p))) continue;
            known.at(x, y) = 1;
            if (!(behind > kBehind_m + plane_tolerance(length(p)))) continue;
            any = true;
            out.wall.at(x, y) = std::isfinite(seen) ? Wall::open : Wall::sky;
            if (behind < kDeepestReveal_m) depths.push_back(behind);
        }
    if (!any) return {};
    spread(out.wall, known);
    if (!depths.empty()) {
        // Most of what is visible in a window's opening is its frame; the reveals are nearer.
        const auto deep = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() * 7 / 10);
        std::nth_element(depths.begin(), deep, depths.end());
        out.depth_m = *deep;
    }
    return out;
}

}  // namespace fastscene
