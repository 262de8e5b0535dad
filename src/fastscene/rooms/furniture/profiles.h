// Prisms that stand: outlines seen from the front or from the side.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// The outline (x, y), clockwise seen from the front, from z0 to z1.
inline Mesh front_prism(std::span<const Vec2f> outline, float z0, float z1, float bevel_m = 0.003f) {
    std::vector<Vec2f> flat;
    for (const Vec2f p : outline) flat.push_back({p.x, -p.y});
    Mesh m = shapes::prism(flat, z0, z1, bevel_m);
    shapes::turn(m, {1, 0, 0}, 90);
    return m;
}

// The outline (z, y), counter-clockwise where z grows to the right, from x0 to x1.
inline Mesh side_prism(std::span<const Vec2f> outline, float x0, float x1, float bevel_m = 0.003f) {
    std::vector<Vec2f> flat;
    for (const Vec2f p : outline) flat.push_back({-p.y, p.x});
    Mesh m = shapes::prism(flat, x0, x1, bevel_m);
    shapes::turn(m, {0, 0, 1}, -90);
    return m;
}

// A bar of few triangles.
inline void wire(Kit& k, int material, Vec3f a, Vec3f b, float radius_m, int sides = 4) {
    const std::array<Vec3f, 2> path{a, b};
    k.add(shapes::tube(path, radius_m, sides), material);
}

// A hoop of few triangles; its axis is y.
inline Mesh hoop(float radius_m, float thickness_m, int sides = 14, int around_it = 5) {
    std::vector<Vec3f> path;
    for (int i = 0; i <= sides; ++i)
        path.push_back(around(kTau * static_cast<float>(i) / static_cast<float>(sides)) * radius_m);
    return shapes::tube(path, 0.5f * thickness_m, around_it);
}

// A ring that stands: its axis is z.
inline Mesh front_ring(float radius_m, float thickness_m, int sides = 24) {
    Mesh m = hoop(radius_m, thickness_m, sides);
    shapes::turn(m, {1, 0, 0}, 90);
    return m;
}

// A rectangle below and a half circle above, for front_prism.
inline std::vector<Vec2f> arch(float half_width, float straight, int steps = 12) {
    std::vector<Vec2f> outline{{-half_width, 0}};
    for (int i = 0; i <= steps; ++i) {
        const float a = kPi * (1.f - static_cast<float>(i) / static_cast<float>(steps));
        outline.push_back({half_width * std::cos(a), straight + half_width * std::sin(a)});
    }
    outline.push_back({half_width, 0});
    return outline;
}

}  // namespace fastscene::furniture
