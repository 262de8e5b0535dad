// Washbasin.
#include <array>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/kitchen/worktop.h"

namespace fastscene::furniture {

void build_washbasin(Kit& k) {
    const Vec3f s = k.wanted({0.9f, 0.86f, 0.5f});
    const int front = k.main(kitchen_front(k)), top = k.material(worktop(k)), metal = k.material(k.style.metal),
              white = k.material(porcelain()), chrome = k.material(k.style.tap);
    legs(k, metal, 0.5f * s.x - 0.06f, 0.5f * s.z - 0.06f, 0.3f, 0.04f);
    k.board(front, {0, 0.28f, -0.015f}, {s.x - 0.02f, 0.4f, s.z - 0.05f});
    fronts(k, front, metal, -0.5f * s.x + 0.015f, 0.5f * s.x - 0.015f, 0.285f, 0.675f, 0.5f * s.z - 0.04f, 2, 1);
    k.board(top, {0, 0.68f, 0}, {s.x, 0.035f, s.z}, 0.005f);
    const std::array<Vec2f, 5> bowl{Vec2f{0.1f, 0}, {0.14f, 0.01f}, {0.18f, 0.06f}, {0.2f, 0.13f}, {0.2f, 0.14f}};
    k.add(shapes::vessel(bowl, 0.012f, 36), white, {0, 0.714f, 0.01f});
    tap(k, chrome, {0, 0.714f, -0.205f}, 0.26f);
    k.top(0.715f, -0.34f * s.x, 0, 0.1f * s.x, 0.15f);
    k.rod(k.material(plain("soap bottle", k.accent(), 0.3f)), {0.33f * s.x, 0.714f, -0.05f},
          {0.33f * s.x, 0.85f, -0.05f}, 0.03f, 0.028f, 20);
    k.rod(chrome, {0.33f * s.x, 0.84f, -0.05f}, {0.33f * s.x, 0.89f, -0.05f}, 0.007f);
    k.piece.clearance_front_m = 0.7f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
