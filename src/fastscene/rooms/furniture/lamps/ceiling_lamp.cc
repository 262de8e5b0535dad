// Ceiling lamp.
#include <array>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/lamps/lamp_parts.h"

namespace fastscene::furniture {

void build_ceiling_lamp(Kit& k) {
    const int metal = lamp_metal(k);
    // The plate is smaller than the glass: it throws no shadow on the ceiling.
    k.add(shapes::prism(shapes::circle(0.14f, 40), -0.02f, 0.f, 0.004f), metal);
    k.add(shapes::ring(0.203f, 0.007f, 40), metal, {0, -0.036f, 0});
    Material milk = plain("opal glass", {0.8f, 0.78f, 0.74f}, 0.2f);
    milk.emission = k.style.lamp_light * 0.7f;
    const std::array<Vec2f, 6> p{Vec2f{0, -0.1f},   {0.1f, -0.095f}, {0.16f, -0.08f},
                                 {0.192f, -0.055f}, {0.2f, -0.036f}, {0.19f, -0.019f}};
    k.add(shapes::lathe(p, 40, true), k.material(milk));
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
