// Coat hooks.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {

// A board with five hooks; a coat, a bag and a scarf hang there, and a hat.
void build_coat_hooks(Kit& k) {
    const Vec3f s = k.wanted({1.05f, 0.98f, 0.2f});
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal);
    const float board = s.y - 0.12f, reach = 0.075f;
    k.board(wood, {0, board, 0.011f}, {s.x, 0.12f, 0.022f}, 0.006f);
    const auto hook_x = [&](int i) { return (static_cast<float>(i) - 2.f) * 0.205f * s.x; };
    for (int i = 0; i < 5; ++i) {
        const float x = hook_x(i), y = board + 0.055f;
        const std::array<Vec3f, 5> bow{{{x, y, 0.02f},
                                        {x, y - 0.022f, 0.045f},
                                        {x, y - 0.02f, reach},
                                        {x, y + 0.008f, reach + 0.012f},
                                        {x, y + 0.02f, reach + 0.012f}}};
        k.add(shapes::tube(bow, 0.006f, 8), metal);
        k.add(shapes::ball({x, y + 0.022f, reach + 0.012f}, {0.01f, 0.01f, 0.01f}, 10), metal);
        k.board(metal, {x, y - 0.03f, 0.024f}, {0.026f, 0.06f, 0.006f}, 0.002f);
    }
    // A coat hangs from its collar: narrow there, wider below, in folds.
    const auto coat = [&](int hook, float down, float width, int cloth) {
        const float x = hook_x(hook), top = board + 0.05f;
        const std::uint32_t seed = k.seed();
        k.add(shapes::slab(36, 18, 0.016f,
                           [=](float u, float v) {
                               const float open = 0.16f + 0.84f * std::min(1.f, 2.6f * v) + 0.06f * v,
                                           a = (u - 0.5f) * 3.f;
                               const float fold = 1.f + 0.16f * v * std::sin(9.f * a) +
                                                  0.1f * shapes::wobble({3 * a, 4 * v, 0}, seed);
                               return Vec3f{x + 0.5f * width * open * std::sin(a) / std::sin(1.5f), top - down * v,
                                            0.028f + 0.085f * open * std::cos(a) * fold};
                           }),
              cloth);
    };
    coat(0, std::min(0.9f, board + 0.02f), 0.3f, k.material(tinted(k.style.fabric2, k.accent())));
    coat(3, std::min(0.62f, board), 0.26f,
         k.material(tinted(k.style.fabric, lerp(k.accent(), {0.12f, 0.1f, 0.08f}, 0.45f))));
    // A scarf over one hook, a straw hat on another.
    const int scarf = k.material(tinted(*material_named("wool"), k.accent()));
    for (const float side : {-1.f, 1.f})
        k.add(shapes::slab(8, 16, 0.01f,
                           [&, side](float u, float v) {
                               return Vec3f{hook_x(1) + side * (0.018f + 0.02f * v) + (u - 0.5f) * 0.075f,
                                            board + 0.07f - (side > 0 ? 0.52f : 0.44f) * v,
                                            0.05f + 0.02f * std::sin(2.6f * v) + 0.006f * std::sin(12.f * u)};
                           }),
              scarf);
    const int straw = k.material(*material_named("rattan"));
    const std::array<Vec2f, 6> brim{Vec2f{0.15f, 0.f}, {0.085f, 0.012f}, {0.08f, 0.03f},
                                    {0.076f, 0.075f},  {0.06f, 0.088f},  {0.f, 0.09f}};
    Mesh hat = shapes::shade(brim, 36);
    shapes::turn(hat, {1, 0, 0}, 78);
    k.add(std::move(hat), straw, {hook_x(4), board + 0.03f, 0.05f});
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.82f;
}

}  // namespace fastscene::furniture
