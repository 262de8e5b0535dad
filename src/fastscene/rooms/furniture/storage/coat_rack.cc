// Coat rack.
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_coat_rack(Kit& k) {
    const int wood = k.main(k.style.wood);
    const std::array<Vec2f, 4> foot{Vec2f{0.17f, 0}, {0.17f, 0.02f}, {0.04f, 0.045f}, {0.025f, 0.07f}};
    k.add(shapes::lathe(foot, 32), wood);
    k.rod(wood, {0, 0.04f, 0}, {0, 1.75f, 0}, 0.02f, 0.016f);
    for (int i = 0; i < 6; ++i)
        k.rod(wood, {0, 1.5f + 0.03f * static_cast<float>(i), 0},
              around(1.0472f * static_cast<float>(i)) * 0.19f + Vec3f{0, 1.62f + 0.03f * static_cast<float>(i), 0},
              0.01f, 0.012f);
    const int coat = k.material(tinted(k.style.fabric2, k.accent()));
    const std::uint32_t seed = k.seed();
    k.add(shapes::slab(32, 16, 0.02f,
                       [=](float u, float v) {
                           const float a = (u - 0.5f) * 4.4f, h = 1.6f - 0.95f * (1.f - v),
                                       r = (0.05f + 0.13f * std::sqrt(1.f - v)) *
                                           (1.f + 0.12f * std::sin(a * 7.f) * (1.f - v) +
                                            0.08f * shapes::wobble({a * 2, v * 4, 0}, seed));
                           return Vec3f{0.1f - r * std::sin(a) * 0.9f, h, 0.06f + r * std::cos(a)};
                       }),
          coat);
}

}  // namespace fastscene::furniture
