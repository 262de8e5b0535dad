// Leaves and pots of plants.
#include "fastscene/rooms/furniture/plants/foliage.h"

#include <array>
#include <cmath>

namespace fastscene::furniture {

Material foliage(Kit& k, Vec3f tone, float scale) {
    Material m = plain("leaf", tone * k.rng.uniform(0.85f, 1.15f), 0.45f);
    m.pattern = Pattern::leaf;
    m.color_b = tone * 1.5f + Vec3f{0.02f, 0.03f, 0.f};
    m.scale_m = scale;
    m.transmission = 0.25f;
    m.seed = k.seed();
    return m;
}

Mesh blade(Vec3f base, Vec3f out, float length, float width, float lift, float droop, float point) {
    const Vec3f side = cross(Vec3f{0, 1, 0}, out);
    Mesh m = shapes::sheet(4, 10, [&](float u, float v) {
        const float a = 2 * u - 1, w = width * std::pow(std::sin(3.1f * std::pow(v * 0.97f + 0.02f, point)), 0.9f);
        return base + out * (length * v) + Vec3f{0, length * (lift * v - droop * v * v) + 0.12f * width * a * a, 0} +
               side * (0.5f * w * a);
    });
    for (std::size_t i = 0; i < m.coords.size(); ++i) {
        const float u = static_cast<float>(i % 5) / 4.f, v = static_cast<float>(i / 5) / 10.f;
        m.coords[i] = {(u - 0.5f) * width, v * length, 0};
    }
    return m;
}

float flower_pot(Kit& k, int mat, float r, float h) {
    const std::array<Vec2f, 4> p{Vec2f{0.7f * r, 0}, {0.74f * r, 0.01f}, {r, h - 0.03f}, {r, h}};
    k.add(shapes::vessel(p, 0.012f, 32), mat);
    k.add(shapes::prism(shapes::circle(0.9f * r, 24), 0.6f * h, 0.88f * h),
          k.material(plain("soil", {0.06f, 0.042f, 0.03f}, 0.95f)));
    return 0.88f * h;
}

}  // namespace fastscene::furniture
