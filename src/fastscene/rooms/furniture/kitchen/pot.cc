// Pot.
#include <array>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_pot(Kit& k) {
    const int body = k.main(k.rng.chance(0.5f) ? steel() : plain("enamel", k.accent(), 0.25f));
    const std::array<Vec2f, 3> p{Vec2f{0.1f, 0}, {0.108f, 0.01f}, {0.108f, 0.12f}};
    k.add(shapes::vessel(p, 0.004f, 28), body);
    const std::array<Vec2f, 4> lid{Vec2f{0.108f, 0.12f}, {0.1f, 0.128f}, {0.03f, 0.14f}, {0.f, 0.142f}};
    k.add(shapes::lathe(lid, 28), body);
    k.add(shapes::ball({0, 0.152f, 0}, {0.018f, 0.014f, 0.018f}, 12), body);
    for (const float s : {-1.f, 1.f}) k.board(body, {s * 0.125f, 0.09f, 0}, {0.035f, 0.012f, 0.06f}, 0.004f);
    on_surface(k);
}

}  // namespace fastscene::furniture
