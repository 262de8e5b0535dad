// Washing machine.
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_washing_machine(Kit& k) {
    const int body = k.main(plain("white enamel", {0.76f, 0.76f, 0.75f}, 0.25f)), chrome = k.material(steel()),
              dark = k.material(plain("door glass", {0.04f, 0.045f, 0.05f}, 0.08f));
    k.board(body, {0, 0, 0}, {0.6f, 0.85f, 0.58f}, 0.012f);
    Mesh rim = shapes::ring(0.17f, 0.05f, 36);
    shapes::turn(rim, {1, 0, 0}, 90);
    k.add(std::move(rim), chrome, {0, 0.42f, 0.29f});
    k.add(shapes::ball({0, 0.42f, 0.285f}, {0.155f, 0.155f, 0.045f}, 28), dark);
    k.board(dark, {0.1f, 0.75f, 0.288f}, {0.26f, 0.05f, 0.006f}, 0.002f);
    k.rod(chrome, {-0.14f, 0.775f, 0.285f}, {-0.14f, 0.775f, 0.315f}, 0.03f, 0.027f, 24);
    k.top(0.85f, 0, 0, 0.26f, 0.24f);
    k.piece.clearance_front_m = 0.7f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
