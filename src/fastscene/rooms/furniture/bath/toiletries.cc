// Toiletries.
#include <array>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/kitchen/tableware.h"

namespace fastscene::furniture {

void build_toiletries(Kit& k) {
    const int first = glazed(k), white = k.material(porcelain()), metal = k.material(k.style.metal);
    bottle_at(k, first, {-0.07f, 0, 0}, 0.03f, 0.16f);
    k.rod(metal, {-0.07f, 0.155f, 0}, {-0.07f, 0.19f, 0}, 0.006f);
    k.rod(metal, {-0.07f, 0.188f, 0}, {-0.07f, 0.183f, 0.04f}, 0.006f, 0.004f);
    const std::array<Vec2f, 2> cup{Vec2f{0.03f, 0}, {0.034f, 0.1f}};
    k.add(shapes::vessel(cup, 0.004f, 18), white, {0.02f, 0, -0.01f});
    k.rod(metal, {0.02f, 0.01f, -0.01f}, {0.045f, 0.18f, 0.01f}, 0.004f);
    k.rod(first, {0.015f, 0.01f, -0.01f}, {-0.015f, 0.175f, -0.02f}, 0.004f);
    k.add(shapes::prism(shapes::circle(0.035f), 0, 0.03f, 0.008f), k.material(plain("soap", {0.7f, 0.62f, 0.5f}, 0.5f)),
          {0.1f, 0, 0.01f});
    on_surface(k);
}

}  // namespace fastscene::furniture
