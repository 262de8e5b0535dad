// Pc tower.
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A player's computer: a dark tower, a glass side, fans that glow.
void build_pc_tower(Kit& k) {
    const int body = k.main(plain("black steel", {0.035f, 0.035f, 0.038f}, 0.4f)),
              grille = k.material(plain("grille", {0.02f, 0.02f, 0.022f}, 0.7f));
    const float w = 0.22f, h = 0.46f, d = 0.42f;
    k.board(body, {0, 0.012f, 0}, {w, h - 0.012f, d}, 0.006f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) k.board(body, {sx * 0.08f, 0, sz * 0.16f}, {0.03f, 0.013f, 0.05f}, 0.002f);
    k.board(grille, {0, 0.035f, 0.5f * d}, {w - 0.03f, h - 0.06f, 0.006f}, 0.002f);
    static constexpr std::array<Vec3f, 3> kGlow{Vec3f{0.3f, 1.3f, 3.2f}, {2.6f, 0.25f, 2.2f}, {0.25f, 2.4f, 1.5f}};
    const auto first = static_cast<std::size_t>(k.rng.index(3));
    for (std::size_t i = 0; i < 3; ++i) {
        Material light = glow("computer fan", kGlow[(first + i / 2) % 3]);
        light.pattern = Pattern::screen;  // glows at any hour
        Mesh ring = shapes::ring(0.05f, 0.006f, 24);
        shapes::turn(ring, {1, 0, 0}, 90);
        k.add(std::move(ring), k.material(light), {0, 0.1f + 0.125f * static_cast<float>(i), 0.5f * d + 0.006f});
    }
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
