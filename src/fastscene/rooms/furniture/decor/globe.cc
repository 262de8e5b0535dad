// Globe.
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_globe(Kit& k) {
    const int metal = k.main(k.style.metal);
    Material sea = plain("globe", {0.2f, 0.36f, 0.45f}, 0.35f);
    sea.pattern = Pattern::marble;
    sea.color_b = {0.55f, 0.47f, 0.25f};
    sea.scale_m = 0.15f;
    const std::array<Vec2f, 4> foot{Vec2f{0.075f, 0}, {0.07f, 0.014f}, {0.015f, 0.03f}, {0.012f, 0.09f}};
    k.add(shapes::lathe(foot, 24), metal);
    k.add(shapes::ball({0, 0.22f, 0}, {0.11f, 0.11f, 0.11f}, 24), k.material(sea));
    Mesh ring = shapes::ring(0.122f, 0.005f, 32);
    shapes::turn(ring, {1, 0, 0}, 90);
    shapes::turn(ring, {0, 0, 1}, 20);
    k.add(std::move(ring), metal, {0, 0.22f, 0});
    on_surface(k);
}

}  // namespace fastscene::furniture
