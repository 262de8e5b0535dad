// Sculpture.
#include <array>
#include <string>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_sculpture(Kit& k) {
    const int kind = k.rng.index(3);
    k.piece.form = "form " + std::to_string(kind);
    Material stone = *material_named("marble");
    if (kind != 0)
        stone = kind == 1 ? k.style.metal : plain("plaster", lerp(k.accent(), {0.74f, 0.72f, 0.68f}, 0.7f), 0.7f);
    const int mat = k.main(stone);
    k.board(mat, {}, {0.11f, 0.03f, 0.11f}, 0.004f);
    if (kind == 0) {
        const std::array<Vec2f, 9> p{Vec2f{0.03f, 0.03f}, {0.05f, 0.06f},  {0.07f, 0.12f},
                                     {0.04f, 0.17f},      {0.03f, 0.19f},  {0.055f, 0.23f},
                                     {0.06f, 0.27f},      {0.04f, 0.315f}, {0.f, 0.33f}};
        k.add(shapes::lathe(shapes::curve(p, 3), 24, true), mat);
    } else if (kind == 1) {
        Mesh ring = shapes::ring(0.1f, 0.017f, 36);
        shapes::turn(ring, {1, 0, 0}, 90);
        k.add(std::move(ring), mat, {0, 0.145f, 0});
    } else {
        k.add(shapes::ball({0, 0.08f, 0}, {0.075f, 0.055f, 0.07f}), mat);
        k.add(shapes::ball({0.01f, 0.165f, 0}, {0.055f, 0.045f, 0.05f}), mat);
        k.add(shapes::ball({0, 0.235f, 0}, {0.035f, 0.03f, 0.035f}), mat);
    }
    on_surface(k);
}

}  // namespace fastscene::furniture
