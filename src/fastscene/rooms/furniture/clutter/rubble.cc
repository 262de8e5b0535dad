// Rubble.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Plaster and brick that came down, on its own dust.
void build_rubble(Kit& k) {
    const int plaster = k.main(plain("plaster rubble", {0.5f, 0.47f, 0.42f}, 0.95f)),
              brick = k.material(plain("brick rubble", {0.33f, 0.13f, 0.08f}, 0.95f)),
              dust = k.material(plain("plaster dust", {0.46f, 0.43f, 0.385f}, 1.f));
    const std::uint32_t seed = k.seed();
    k.add(shapes::slab(
              48, 14, 0.002f,
              [=](float u, float v) {
                  const float a = kTau * u,
                              r = 0.5f * (1.f - 0.985f * v) *
                                  (1.f + 0.25f * shapes::wobble({1.5f * std::cos(a), 1.f, 1.5f * std::sin(a)}, seed));
                  const float x = r * std::cos(a), z = -0.75f * r * std::sin(a);
                  return Vec3f{
                      x,
                      std::max(0.002f, 0.05f * (v * (2.f - v)) *
                                               (0.8f + 0.6f * shapes::wobble({9.f * x, 2.f, 9.f * z}, seed + 1)) +
                                           0.002f),
                      z};
              }),
          dust);
    const int chunks = 16 + k.rng.index(6);
    for (int i = 0; i < chunks; ++i) {
        const bool red = k.rng.chance(0.35f);
        const float size = k.rng.uniform(0.035f, 0.1f), far = std::sqrt(k.rng.uniform()) * 0.42f,
                    a = k.rng.uniform(0.f, kTau);
        Mesh m = shapes::box(red ? Vec3f{size, 0.5f * size, 0.6f * size}
                                 : Vec3f{size * k.rng.uniform(0.8f, 1.6f), size * k.rng.uniform(0.25f, 0.5f), size},
                             0.12f * size);
        const std::uint32_t chip = k.seed();
        for (Vec3f& p : m.positions) p = p * (1.f + 0.22f * shapes::wobble(p * (2.f / size), chip));
        shapes::turn(m, {1, 0, 0}, k.rng.uniform(-25, 25));
        shapes::turn(m, {0, 1, 0}, k.rng.uniform(0.f, 360.f));
        const shapes::Box box = shapes::bounds(m);
        const float bed = 0.045f * std::max(0.f, 1.f - far / 0.5f);
        k.add(std::move(m), red ? brick : plaster,
              {far * std::cos(a), std::max(0.f, bed) - box.low.y - 0.006f * bed, 0.75f * far * std::sin(a)});
    }
}

}  // namespace fastscene::furniture
