// Table lamp.
#include <array>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/kitchen/tableware.h"
#include "fastscene/rooms/furniture/lamps/lamp_parts.h"

namespace fastscene::furniture {

void build_table_lamp(Kit& k) {
    const int kind = k.rng.index(3);
    const int body = k.main(kind == 0 ? k.style.metal : plain("glazed ceramic", k.accent(), 0.2f));
    if (kind == 0) {
        foot_disc(k, body, 0.075f);
        k.rod(body, {0, 0.02f, 0}, {0, 0.3f, 0}, 0.009f);
    } else {
        const float b = kind == 1 ? 0.085f : 0.06f;
        const std::array<Vec2f, 8> p{Vec2f{0.05f, 0},   {0.06f, 0.01f},   {b, 0.07f},     {b * 1.05f, 0.11f},
                                     {b * 0.7f, 0.19f}, {0.022f, 0.235f}, {0.02f, 0.26f}, {0.012f, 0.3f}};
        k.add(shapes::lathe(shapes::curve(p, 3), 28, true), body);
    }
    lamp_head(k, 0.27f, 0.135f, false);
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
