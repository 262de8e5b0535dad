// Bathtub.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/kitchen/worktop.h"

namespace fastscene::furniture {

void build_bathtub(Kit& k) {
    const int white = k.main(porcelain()), chrome = k.material(k.style.tap);
    const float w = 1.7f, d = 0.76f, h = 0.58f;
    // One closed skin: up the outside, over the rim, down the inside.
    const std::vector<Vec2f> unit = shapes::circle(1.f, 56);
    struct Level {
        float grow, y;
    };
    const std::array<Level, 10> skin{Level{0.74f, 0.f}, {0.78f, 0.02f},  {0.88f, 0.25f},  {0.97f, 0.53f},
                                     {1.f, 0.56f},      {0.985f, 0.58f}, {0.855f, 0.58f}, {0.82f, 0.45f},
                                     {0.72f, 0.2f},     {0.55f, 0.15f}};
    Mesh m;
    const auto point = [&](const Level& l, const Vec2f& p) {
        const float e = 0.62f;  // between an ellipse and a rectangle
        const float x = std::copysign(std::pow(std::fabs(p.x), e), p.x),
                    z = std::copysign(std::pow(std::fabs(p.y), e), p.y);
        const float in = (1.f - l.grow) * 0.5f * d * 1.3f;
        return Vec3f{x * (0.5f * w - in), l.y * h / 0.58f, z * (0.5f * d - in)};
    };
    const auto n = static_cast<std::uint32_t>(unit.size());
    for (const Level& l : skin)
        for (const Vec2f& p : unit) m.positions.push_back(point(l, p));
    for (std::uint32_t j = 0; j + 1 < skin.size(); ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * n + i, b = j * n + (i + 1) % n;
            m.triangles.insert(m.triangles.end(), {a, a + n, b + n, a, b + n, b});
        }
    for (const bool inside : {false, true}) {
        const auto hub = static_cast<std::uint32_t>(m.positions.size()),
                   ring = inside ? static_cast<std::uint32_t>(skin.size() - 1) * n : 0u;
        m.positions.push_back({0, inside ? skin.back().y - 0.005f : 0.f, 0});
        for (std::uint32_t i = 0; i < n; ++i)
            m.triangles.insert(m.triangles.end(),
                               {hub, inside ? ring + (i + 1) % n : ring + i, inside ? ring + i : ring + (i + 1) % n});
    }
    m.normals.assign(m.positions.size(), {0, 1, 0});
    shapes::smooth_normals(m);
    shapes::lay_grain(m);
    k.add(std::move(m), white);
    tap(k, chrome, {-0.5f * w + 0.05f, 0.56f, 0}, 0.22f);
    // Candles and bottles stand on the rim's long sides, where it is straight: more room behind than where one climbs
    // in.
    k.piece.surfaces.push_back({{0, h, -0.5f * d + 0.039f}, {0.2f * w, 0.03f}});
    k.piece.surfaces.push_back({{0, h, 0.5f * d - 0.039f}, {0.16f * w, 0.03f}});
    k.piece.clearance_front_m = 0.6f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
