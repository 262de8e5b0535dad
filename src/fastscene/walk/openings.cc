#include "fastscene/walk/openings.h"

#include <algorithm>
#include <deque>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/reproject.h"

namespace fastscene {
namespace {

constexpr float kBehind_m = 0.03f;          // a surface so far behind the wall was seen through it
constexpr float kDeepestReveal_m = 0.6f;    // walls are not thicker

// Unknown places (no entry in `known`) take after the nearest known one: one step a round, the sources in order.
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

// A pixel of the outside with nothing else about it.
bool is_outside(const ImageF& range, int x, int y) {
    for (int j = std::max(0, y - 1); j <= std::min(range.height - 1, y + 1); ++j)
        for (int i = x - 1; i <= x + 1; ++i)
            if (std::isfinite(range.at(wrap_column(i, range.width), j))) return false;
    return true;
}

// Colors with the distances they come from; the nearer counts more.
struct Blend {
    Vec3f sum;
    float weight = 0;
    void add(Vec3f color, int distance) {
        const float w = 1.f / static_cast<float>(distance * distance);
        sum += color * w;
        weight += w;
    }
};

// Along a line of n pixels (wrapping or not): what the nearest known pixels on both sides say about each unknown one.
template <class ColorAt, class KnownAt, class BlendAt>
void blend_line(int n, bool wraps, ColorAt color_at, KnownAt known_at, BlendAt blend_at) {
    for (const int step : {1, -1}) {
        int distance = 0;   // 0: none seen yet
        Vec3f last;
        const int begin = step > 0 ? 0 : n - 1, rounds = wraps ? 2 * n : n;
        for (int k = 0; k < rounds; ++k) {
            const int i = wrap_column(begin + step * k, n);
            if (known_at(i)) {
                last = color_at(i);
                distance = 1;
            } else if (distance > 0) {
                if (!wraps || k >= n) blend_at(i).add(last, distance);
                ++distance;
            }
        }
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
            const float seen = range.at(wrap_column(static_cast<int>(at.x), size.width), std::min(static_cast<int>(at.y), size.height - 1));
            // How far behind the plane the seen surface lies; beyond a wall's own roughness, it is an opening.
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
        // Most of what is seen in a window's opening is its frame; the reveals are nearer.
        const auto deep = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() * 7 / 10);
        std::nth_element(depths.begin(), deep, depths.end());
        out.depth_m = *deep;
    }
    return out;
}

ImageColor outside_picture(const ImageColor& color, const ImageF& range) {
    const int w = color.width, h = color.height;
    ImageMask known(w, h);
    bool any = false;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            known.at(x, y) = is_outside(range, x, y);
            any |= known.at(x, y) != 0;
        }
    if (!any) return {};
    ImageColor out = color;
    // The outside lies in layers: sky, hills, ground. So it goes on along the rows first; above and below what was seen,
    // and across thin bars, along the columns.
    Image<Blend> blends(w, h);
    for (int y = 0; y < h; ++y)
        blend_line(w, true, [&](int x) { return color.at(x, y); }, [&](int x) { return known.at(x, y) != 0; }, [&](int x) -> Blend& { return blends.at(x, y); });
    for (int x = 0; x < w; ++x)
        blend_line(h, false, [&](int y) { return color.at(x, y); }, [&](int y) { return known.at(x, y) != 0; }, [&](int y) -> Blend& { return blends.at(x, y); });
    for (std::size_t i = 0; i < out.size(); ++i)
        if (!known.pixels[i] && blends.pixels[i].weight > 0) {
            out.pixels[i] = blends.pixels[i].sum / blends.pixels[i].weight;
            known.pixels[i] = 1;
        }
    Image<Blend> rest(w, h);
    for (int x = 0; x < w; ++x)
        blend_line(h, false, [&](int y) { return out.at(x, y); }, [&](int y) { return known.at(x, y) != 0; }, [&](int y) -> Blend& { return rest.at(x, y); });
    for (std::size_t i = 0; i < out.size(); ++i)
        if (!known.pixels[i] && rest.pixels[i].weight > 0) out.pixels[i] = rest.pixels[i].sum / rest.pixels[i].weight;
    return out;
}

}  // namespace fastscene
