// An office chair.
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_office_chair(Kit& k) {
    const int cloth = k.main(k.style.leather),
              dark = k.material(plain("black plastic", {0.035f, 0.035f, 0.037f}, 0.4f)), chrome = k.material(steel());
    for (int i = 0; i < 5; ++i) {
        const float a = 1.2566f * static_cast<float>(i), c = std::cos(a), s = std::sin(a);
        k.rod(chrome, {0.03f * c, 0.11f, 0.03f * s}, {0.29f * c, 0.075f, 0.29f * s}, 0.022f, 0.014f);
        k.add(shapes::ball({0.29f * c, 0.03f, 0.29f * s}, {0.03f, 0.03f, 0.03f}, 10), dark);
    }
    k.rod(chrome, {0, 0.09f, 0}, {0, 0.4f, 0}, 0.026f, 0.02f);
    k.board(dark, {0, 0.39f, 0}, {0.24f, 0.04f, 0.24f}, 0.01f);
    k.soft(cloth, {0, 0.42f, 0.02f}, {0.5f, 0.09f, 0.48f}, {0.04f, 0.02f, 0.002f, 8});
    Mesh back = shapes::slab(10, 14, 0.055f, [](float u, float v) {
        const float x = u - 0.5f;
        return Vec3f{x * (0.46f - 0.12f * v * v), 0.56f + 0.58f * v,
                     -0.2f - 0.1f * v + 0.16f * x * x + 0.03f * std::sin(3.1f * v)};
    });
    k.add(std::move(back), cloth);
    k.board(dark, {0, 0.42f, -0.24f}, {0.06f, 0.34f, 0.025f}, 0.008f);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(dark, {sx * 0.22f, 0.43f, 0}, {sx * 0.29f, 0.66f, 0}, 0.014f);
        k.board(dark, {sx * 0.29f, 0.655f, 0.02f}, {0.06f, 0.03f, 0.26f}, 0.012f);
    }
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture
