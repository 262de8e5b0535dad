// Of baths and porches.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// The heated slab of a Turkish bath: eight sides of marble, bowls and folded cloths on it.
void build_hammam_slab(Kit& k) {
    const Vec3f s = k.wanted({2.3f, 0.62f, 2.3f});
    const int stone = k.main(*material_named("marble")), copper = k.material(*material_named("copper")),
              cloth = color(k, "bath cloth", {0.5f, 0.1f, 0.07f}, 0.9f),
              white = color(k, "towel", {0.72f, 0.7f, 0.66f}, 0.95f);
    const float r = std::min(s.x, s.z) / 2 - 0.06f, foot = 0.46f;
    k.add(shapes::prism(shapes::circle(r - 0.08f, 8), 0, foot - 0.1f, 0.02f), stone),
        k.add(shapes::prism(shapes::circle(r, 8), foot - 0.1f, foot, 0.03f), stone);
    for (int i = 0; i < 4; ++i) {
        const Vec3f at = around(kTau * static_cast<float>(i) / 4 + 0.5f) * (0.62f * r) + Vec3f{0, foot, 0};
        if (i % 2 == 0) {
            const std::array<Vec2f, 4> bowl{Vec2f{0.08f, 0}, {0.15f, 0.05f}, {0.18f, 0.1f}, {0.19f, 0.11f}};
            k.add(shapes::vessel(bowl, 0.006f, 24), copper, at);
        } else {
            for (int j = 0; j < 3; ++j)
                k.soft(j == 1 ? cloth : white, at + Vec3f{0, 0.05f * static_cast<float>(j), 0}, {0.36f, 0.05f, 0.26f},
                       {0.02f, 0.008f, 0.004f, 10});
        }
    }
    k.piece.clearance_front_m = 0.6f;
}

// A railing with turned balusters.
void build_balustrade(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 0.92f, 0.1f});
    const int wood = k.main(plain("white paint", {0.7f, 0.7f, 0.68f}, 0.4f));
    k.board(wood, {0, s.y - 0.06f, 0}, {s.x, 0.06f, s.z}, 0.012f),
        k.board(wood, {0, 0.1f, 0}, {s.x, 0.06f, 0.06f}, 0.008f);
    for (const float side : {-1.f, 1.f}) k.board(wood, {side * (s.x / 2 - 0.05f), 0, 0}, {0.1f, s.y, 0.1f}, 0.01f);
    const int count = std::max(2, static_cast<int>((s.x - 0.2f) / 0.13f));
    for (int i = 0; i < count; ++i) {
        const float x = (s.x - 0.2f) * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f),
                    h = s.y - 0.22f;
        const std::array<Vec2f, 7> p{Vec2f{0.022f, 0},    {0.022f, 0.12f * h}, {0.014f, 0.2f * h}, {0.03f, 0.42f * h},
                                     {0.014f, 0.75f * h}, {0.022f, 0.86f * h}, {0.022f, h}};
        k.add(shapes::lathe(p, 10, true), wood, {x, 0.16f, 0});
    }
}

}  // namespace fastscene::furniture
