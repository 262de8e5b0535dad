// Drop cloth.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A sheet over the floor, with folds and splashes; of plastic it is thin and lets light through.
void build_drop_cloth(Kit& k) {
    const Vec3f s = k.wanted({1.9f, 0.012f, 1.4f});
    const bool film = k.request.material == "plastic" || k.request.material == "lacquer";
    Material cloth = plain(film ? "plastic sheet" : "canvas sheet",
                           film ? Vec3f{0.7f, 0.72f, 0.73f} : Vec3f{0.6f, 0.56f, 0.47f}, film ? 0.25f : 0.95f);
    if (film) cloth.specular = 0.06f;
    else cloth.pattern = Pattern::fabric, cloth.scale_m = 0.002f;
    if (const auto color = k.request.color ? k.request.color : color_named(k.request.color_name);
        color && (k.request.color || !k.request.color_name.empty()))
        cloth = tinted(cloth, *color);
    const int sheet = k.piece.main_material = k.material(cloth);
    const std::uint32_t seed = k.seed();
    k.add(shapes::slab(
              56, 44, 0.001f,
              [=](float u, float v) {
                  const float x = (u - 0.5f) * s.x, z = (0.5f - v) * s.z;
                  const float edge = std::min(std::min(u, 1.f - u), std::min(v, 1.f - v));
                  const float fold = std::pow(1.f - std::fabs(shapes::wobble({x * 2.3f, 1.f, z * 2.3f}, seed)), 5.f);
                  const float ragged = 0.04f * shapes::wobble({x * 1.7f, 4.f, z * 1.7f}, seed + 1);
                  return Vec3f{x * (1.f - 0.03f * edge) + ragged * (edge < 0.2f ? 1.f : 0.4f), 0.0015f + 0.0065f * fold,
                               z + 0.8f * ragged};
              }),
          sheet);
    for (int i = 0; i < (film ? 3 : 9); ++i) {
        const int splash = k.material(plain("paint splash", i % 3 == 0 ? k.accent() : Vec3f{0.74f, 0.73f, 0.7f}, 0.4f));
        const float r = k.rng.uniform(0.012f, 0.045f);
        k.add(shapes::ball({k.rng.uniform(-0.4f, 0.4f) * s.x, 0.0045f, k.rng.uniform(-0.4f, 0.4f) * s.z},
                           {r, 0.004f, r * k.rng.uniform(0.6f, 1.f)}, 14),
              splash);
    }
}

}  // namespace fastscene::furniture
