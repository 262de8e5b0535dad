// Easel.
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Three legs and a canvas on a ledge.
void build_easel(Kit& k) {
    const int wood = k.main(k.style.wood), cloth = k.material(plain("canvas", {0.74f, 0.72f, 0.66f}, 0.85f));
    Material paint = plain("painting", k.style.palette[0], 0.6f);
    paint.pattern = Pattern::art;
    paint.color_b = k.style.palette[1];
    paint.color_c = k.style.palette[2];
    paint.seed = k.seed();
    paint.scale_m = 0.56f;
    for (const float sx : {-1.f, 1.f})
        k.rod(wood, {sx * 0.33f, 0, 0.26f}, {sx * 0.04f, 1.72f, -0.08f}, 0.019f, 0.015f, 8);
    k.rod(wood, {0, 0, -0.36f}, {0, 1.66f, -0.09f}, 0.018f, 0.014f, 8);
    k.rod(wood, {-0.25f, 0.48f, 0.17f}, {0.25f, 0.48f, 0.17f}, 0.014f, -1, 8);
    k.board(wood, {0, 0.74f, 0.15f}, {0.6f, 0.03f, 0.07f}, 0.004f);
    const float w = 0.6f, h = 0.76f;
    Mesh back = shapes::box({w, h, 0.024f}, 0.002f), front = shapes::box({w - 0.03f, h - 0.03f, 0.003f}, 0.0005f);
    front.coords = front.positions;
    for (Vec3f& c : front.coords) c = {c.x + 0.5f * w, 0.5f * h - c.y, c.z};
    shapes::move(front, {0, 0, 0.0125f});
    for (auto* m : {&back, &front}) shapes::turn(*m, {1, 0, 0}, -11.f);
    k.add(std::move(back), cloth, {0, 0.76f + 0.5f * h, 0.075f});
    k.add(std::move(front), k.material(paint), {0, 0.76f + 0.5f * h, 0.075f});
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture
