// Fish bowl.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/plants/foliage.h"

namespace fastscene::furniture {

// A bowl of clear glass with water, gravel, a weed and two goldfish.
void build_fish_bowl(Kit& k) {
    const float size = k.request.size_factor * (k.request.size_m.x > 0 ? k.request.size_m.x / 0.26f : 1.f);
    k.sized = true;
    const float r = 0.13f * size;
    const int fish = k.main(plain("goldfish", {0.7f, 0.22f, 0.02f}, 0.3f)), clear = k.material(glass()),
              gravel = k.material(plain("gravel", {0.52f, 0.46f, 0.36f}, 0.9f)),
              weed = k.material(foliage(k, {0.06f, 0.2f, 0.06f}, 0.08f)),
              eye = k.material(plain("eye", {0.02f, 0.02f, 0.02f}, 0.2f));
    Material water = glass();
    water.name = "water";
    water.color_a = water.color_b = water.color_c = {0.66f, 0.78f, 0.8f};
    std::vector<Vec2f> wall, inside;
    for (int i = 0; i <= 16; ++i) {
        const float a = -1.25f + 2.05f * static_cast<float>(i) / 16.f;
        wall.push_back({r * std::cos(a), r * (std::sin(a) + std::sin(1.25f))});
    }
    wall.push_back({wall.back().x * 1.04f, wall.back().y + 0.012f * size});
    k.add(shapes::vessel(wall, 0.004f * size, 40), clear);
    const float level = 1.38f * r, floor = 0.012f * size;
    k.add(shapes::shade(
              std::array<Vec2f, 2>{
                  Vec2f{std::sqrt(std::max(0.f, r * r - (level - 0.949f * r) * (level - 0.949f * r))) - 0.008f * size,
                        level},
                  Vec2f{0.001f, level}},
              36),
          k.material(water));
    const std::array<Vec2f, 4> bed{Vec2f{0.3f * r, floor},
                                   {0.52f * r, floor + 0.06f * r},
                                   {0.56f * r, floor + 0.13f * r},
                                   {0.1f * r, floor + 0.2f * r}};
    k.add(shapes::lathe(bed, 24, true), gravel);
    for (int i = 0; i < 9; ++i)
        k.add(blade({0.25f * r + 0.05f * r * std::cos(2.4f * static_cast<float>(i)), floor + 0.15f * r, -0.2f * r},
                    around(2.4f * static_cast<float>(i)), 0.22f * r, 0.07f * r, k.rng.uniform(2.2f, 4.2f), 0.4f, 1.1f),
              weed);
    for (const auto& [at, yaw] :
         {std::pair{Vec3f{-0.28f * r, 0.95f * r, 0.25f * r}, 25.f}, {Vec3f{0.2f * r, 0.66f * r, 0.3f * r}, 200.f}}) {
        const float l = 0.3f * r;
        const auto put = [&](Mesh m, int material, const Vec3f& p = Vec3f{}, float turn_deg = 0.f) {
            shapes::turn(m, {0, 1, 0}, turn_deg);
            k.add(std::move(m), material, p);
        };
        put(shapes::ball({0, 0, 0}, {l, 0.5f * l, 0.3f * l}, 16), fish, at, yaw);
        put(shapes::slab(3, 4, 0.0015f,
                         [&](float u, float v) {
                             return Vec3f{-0.8f * l - 0.75f * l * u, (v - 0.5f) * l * (0.2f + 1.1f * u),
                                          0.12f * l * std::sin(3 * u)};
                         }),
            fish, at, yaw);
        put(shapes::slab(
                3, 2, 0.001f,
                [&](float u, float v) {
                    return Vec3f{0.4f * l - 0.8f * l * u, 0.4f * l + 0.32f * l * v * std::sin(0.3f + 2.6f * u), 0};
                }),
            fish, at, yaw);
        for (const float sz : {-1.f, 1.f})
            put(shapes::ball({0.68f * l, 0.1f * l, sz * 0.2f * l}, {0.07f * l, 0.07f * l, 0.05f * l}, 8), eye, at, yaw);
    }
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
