// Clothes heap.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {
namespace {

// One garment dropped on the floor: a low mound with deep folds, wider than high.
void garment(Kit& k, Vec3f at, float rx, float rz, float high, Vec3f color, float turn) {
    Material m = tinted(k.style.fabric, color);
    m.name = "garment";
    m.pattern = k.rng.chance(0.3f) ? Pattern::knit : Pattern::fabric;
    if (m.pattern == Pattern::knit) m.scale_m = 0.008f, m.color_b = color * 0.7f;
    if (k.rng.chance(0.25f))
        m.pattern = Pattern::stripes, m.scale_m = 0.02f, m.color_b = lerp(color, {0.75f, 0.73f, 0.68f}, 0.8f);
    const std::uint32_t seed = k.seed();
    const float c = std::cos(turn), s = std::sin(turn);
    Mesh mound = shapes::slab(52, 22, 0.003f, [=](float u, float v) {
        const float a = kTau * u,
                    reach = 1.f + 0.28f * shapes::wobble({1.3f * std::cos(a), 2.f, 1.3f * std::sin(a)}, seed);
        const float r = 1.f - 0.985f * v, x = rx * reach * r * std::cos(a), z = -rz * reach * r * std::sin(a),
                    body = std::pow(std::max(0.f, 1.f - (1.f - v) * (1.f - v)), 0.7f);
        const float ridge = std::pow(1.f - std::fabs(shapes::wobble({x * 7.f, 3.f, z * 7.f}, seed + 1)), 2.f),
                    fine = shapes::wobble({x * 17.f, 6.f, z * 17.f}, seed + 2);
        const float y = high * body * (0.42f + 0.5f * ridge + 0.14f * fine) + 0.004f;
        return Vec3f{c * x + s * z, std::max(0.004f, y), c * z - s * x};
    });
    k.add(std::move(mound), k.material(m), at);
}

}  // namespace

void build_clothes_heap(Kit& k) {
    k.piece.main_material = 0;
    const std::array<Vec3f, 5> usual{Vec3f{0.06f, 0.09f, 0.19f},
                                     {0.5f, 0.48f, 0.44f},
                                     {0.05f, 0.05f, 0.055f},
                                     {0.3f, 0.05f, 0.05f},
                                     {0.24f, 0.25f, 0.27f}};  // denim, white, black, red, gray
    const auto color = [&] {
        return k.rng.chance(0.35f) ? k.accent() : usual[static_cast<std::size_t>(k.rng.index(5))];
    };
    const Vec3f first = k.request.color                ? *k.request.color
                        : k.request.color_name.empty() ? color()
                                                       : color_named(k.request.color_name).value_or(color());
    garment(k, {0, 0, 0}, 0.3f, 0.2f, 0.12f, first, k.rng.uniform(0.f, kTau));
    garment(k, {0.12f, 0.025f, 0.09f}, 0.19f, 0.14f, 0.1f, color(), k.rng.uniform(0.f, kTau));
    garment(k, {-0.3f, 0, 0.16f}, 0.2f, 0.11f, 0.06f, color(), k.rng.uniform(0.f, kTau));
    if (k.rng.chance(0.7f)) garment(k, {0.1f, 0, -0.28f}, 0.13f, 0.08f, 0.05f, color(), k.rng.uniform(0.f, kTau));
    for (Mesh& m : k.piece.meshes)
        for (Vec3f& p : m.positions) p.y = std::max(p.y, 0.f);
}

}  // namespace fastscene::furniture
