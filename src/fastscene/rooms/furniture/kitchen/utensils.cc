// Utensils.
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/kitchen/tableware.h"

namespace fastscene::furniture {

// A jar with spoons, a board that leans behind it.
void build_utensils(Kit& k) {
    const int jar = glazed(k), wood = k.material(k.style.wood2), metal = k.material(steel());
    const std::array<Vec2f, 4> p{Vec2f{0.05f, 0}, {0.058f, 0.02f}, {0.058f, 0.12f}, {0.052f, 0.15f}};
    k.add(shapes::vessel(p, 0.005f, 20), jar);
    for (int i = 0; i < 5; ++i) {
        const float a = 1.3f * static_cast<float>(i);
        const Vec3f tip{0.07f * std::cos(a), k.rng.uniform(0.24f, 0.3f), 0.05f * std::sin(a)};
        k.rod(i % 2 ? metal : wood, {0.02f * std::cos(a), 0.01f, 0.02f * std::sin(a)}, tip, 0.005f);
        k.add(shapes::ball(tip, {0.02f, 0.03f, 0.008f}, 10), i % 2 ? metal : wood);
    }
    Mesh board = shapes::box({0.22f, 0.32f, 0.018f}, 0.008f);
    shapes::lay_grain(board);
    shapes::turn(board, {1, 0, 0}, -9);
    k.add(std::move(board), wood, {0.16f, 0.163f, -0.035f});
    on_surface(k);
}

}  // namespace fastscene::furniture
