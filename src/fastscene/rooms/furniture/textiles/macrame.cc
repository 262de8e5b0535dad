// Macrame.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Knotted cords on a branch: a net of lozenges that ends in a point, long ends below.
void build_macrame(Kit& k) {
    const Vec3f s = k.wanted({0.8f, 1.15f, 0.05f});
    Material cotton = plain("cotton cord", {0.7f, 0.65f, 0.54f}, 0.95f);
    cotton.specular = 0.02f;
    const int cord = k.main(cotton), wood = k.material(*material_named("walnut"));
    const float half = 0.5f * s.x, top = s.y - 0.3f * half - 0.02f;
    // A branch is not quite straight.
    std::vector<Vec3f> branch;
    for (int i = 0; i <= 12; ++i) {
        const float t = static_cast<float>(i) / 6.f - 1.f;
        branch.push_back({t * half, top + 0.006f * std::sin(5 * t + 1.f), 0.026f + 0.003f * std::sin(7 * t)});
    }
    k.add(shapes::tube(branch, 0.012f, 10), wood);
    for (const float sx : {-1.f, 1.f})
        k.add(shapes::tube(
                  std::array{Vec3f{sx * 0.8f * half, top, 0.03f}, Vec3f{sx * 0.4f * half, top + 0.15f * half, 0.02f},
                             Vec3f{0, top + 0.3f * half, 0.012f}},
                  0.004f, 6),
              cord);
    k.rod(k.material(k.style.metal), {0, top + 0.29f * half, 0}, {0, top + 0.29f * half, 0.025f}, 0.004f, -1, 8);
    constexpr int kPairs = 14;
    const float step = 2 * 0.9f * half / (kPairs - 1), row = 0.95f * step;
    const auto x_of = [&](float i) { return (i - 0.5f * (kPairs - 1)) * step; };
    Mesh all;
    const auto tie = [&](float x, float y, float size) {
        shapes::append(all, shapes::ball({x, y, 0.03f}, {size, 0.8f * size, 0.75f * size}, 10));
    };
    // Rows of knots: each lower row has one less, until a point is left; cords run between them.
    const auto knot_y = [&](int j) { return top - 0.055f - row * static_cast<float>(j); };
    for (int i = 0; i < kPairs; ++i) {
        shapes::append(all, shapes::ball({x_of(static_cast<float>(i)), top, 0.026f}, {0.011f, 0.0165f, 0.0165f},
                                         10));  // the lark's head about the branch
        for (const float d : {-0.005f, 0.005f})
            shapes::append(
                all, shapes::rod({x_of(static_cast<float>(i)) + d, top - 0.01f, 0.038f},
                                 {x_of(static_cast<float>(i)) + 0.4f * d, knot_y(0), 0.03f}, 0.0042f, 0.0042f, 6));
    }
    constexpr int kRows = 9;
    for (int j = 0; j < kRows; ++j) {
        const int count = kPairs - j;
        for (int i = 0; i < count; ++i) {
            const float x = x_of(static_cast<float>(i) + 0.5f * static_cast<float>(j));
            tie(x, knot_y(j), 0.0145f);
            if (j + 1 == kRows) continue;
            for (const float way : {-0.5f, 0.5f}) {
                const float to = static_cast<float>(i) + 0.5f * static_cast<float>(j) + way;
                if (to < 0.5f * static_cast<float>(j + 1) - 0.01f ||
                    to > static_cast<float>(kPairs - 1) - 0.5f * static_cast<float>(j + 1) + 0.01f)
                    continue;
                shapes::append(
                    all, shapes::rod({x, knot_y(j), 0.03f}, {x_of(to), knot_y(j + 1), 0.03f}, 0.0065f, 0.0065f, 6));
            }
        }
    }
    // Long ends: from the slanting edge down, shortest at the sides.
    for (int i = 0; i < 3 * kPairs; ++i) {
        const float at = (static_cast<float>(i) + 0.5f) / 3.f - 0.5f,
                    side = std::min(at + 0.5f, static_cast<float>(kPairs) - 0.5f - at), x = x_of(at);
        const float from = knot_y(
                        static_cast<int>(std::min(static_cast<float>(kRows - 1), std::max(0.f, 2.f * side - 1.f)))),
                    to = (0.34f * s.y) * std::abs(x) / half + k.rng.uniform(0.f, 0.018f);
        if (to > from - 0.06f) continue;
        const float sway = k.rng.uniform(-0.006f, 0.006f);
        shapes::append(all, shapes::tube(std::array{Vec3f{x, from, 0.026f}, Vec3f{x + sway, 0.5f * (from + to), 0.022f},
                                                    Vec3f{x + 0.4f * sway, to + 0.03f, 0.02f}, Vec3f{x, to, 0.02f}},
                                         0.0058f, 6));
    }
    k.add(std::move(all), cord);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.95f;
}

}  // namespace fastscene::furniture
