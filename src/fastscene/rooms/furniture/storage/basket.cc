// Basket.
#include <array>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_basket(Kit& k) {
    const int straw = k.main(*material_named("wicker"));
    const std::array<Vec2f, 5> p{Vec2f{0.15f, 0}, {0.17f, 0.02f}, {0.2f, 0.15f}, {0.19f, 0.28f}, {0.185f, 0.3f}};
    k.add(shapes::vessel(p, 0.012f, 32), straw);
    k.add(shapes::ring(0.185f, 0.02f, 32), straw, {0, 0.3f, 0});
    k.soft(k.material(tinted(k.style.fabric2, k.accent())), {0, 0.1f, 0}, {0.24f, 0.24f, 0.24f},
           {0.09f, 0.03f, 0.02f, 12});
}

}  // namespace fastscene::furniture
