// Chairs for tables and desks.
#include <utility>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {
namespace {

// Poles of cane, a woven seat and a high woven back that hugs a little.
void woven_chair(Kit& k) {
    const int cane = woven_main(k);
    Material pole = plain("cane", k.piece.materials[static_cast<std::size_t>(cane)].color_a * 0.85f, 0.5f);
    const int poles = k.material(pole);
    const float y = 0.45f;
    for (const float sx : {-1.f, 1.f}) {
        k.rod(poles, {sx * 0.2f, 0, 0.19f}, {sx * 0.21f, y, 0.18f}, 0.016f, -1, 12);
        k.rod(poles, {sx * 0.2f, 0, -0.2f}, {sx * 0.19f, y, -0.18f}, 0.016f, -1, 12);
        k.rod(poles, {sx * 0.19f, y - 0.01f, -0.185f}, {sx * 0.2f, 0.9f, -0.27f}, 0.016f, -1, 12);
        k.rod(poles, {sx * 0.2f, 0.2f, 0.188f}, {sx * 0.195f, 0.2f, -0.19f}, 0.01f, -1, 10);
    }
    k.rod(poles, {-0.2f, 0.9f, -0.27f}, {0.2f, 0.9f, -0.27f}, 0.016f, -1, 12);
    k.rod(poles, {-0.2f, 0.25f, 0.188f}, {0.2f, 0.25f, 0.188f}, 0.01f, -1, 10);
    k.add(shapes::prism(shapes::rounded_rectangle(0.46f, 0.43f, 0.06f), y - 0.03f, y, 0.01f), cane);
    k.add(shapes::slab(
              12, 6, 0.012f,
              [&](float u, float v) {
                  const float x = (u - 0.5f) * 0.4f, t = 0.12f + 0.86f * v;
                  return Vec3f{x, y + 0.45f * t, -0.18f - 0.085f * t - 0.02f * (1.f - 4.f * (u - 0.5f) * (u - 0.5f))};
              }),
          cane);
    k.top(y, 0, 0.03f, 0.18f, 0.16f);
    k.piece.clearance_front_m = 0.3f;
}

// A padded seat and a padded back on legs of the style: chairs that were asked for in cloth or leather.
void upholstered_chair(Kit& k) {
    const int cloth = k.main(k.style.fabric),
              frame = k.material(k.style.legs == LegType::metal_frame ? k.style.metal : k.style.wood);
    const float y = 0.47f, rise = 0.5f, lean = -8.f;
    legs(k, frame, 0.19f, 0.19f, y - 0.08f, 0.034f);
    k.soft(cloth, {0, y - 0.1f, 0.005f}, {0.47f, 0.11f, 0.47f}, {0.03f, 0.018f, 0.002f, 10});
    Mesh back = shapes::soft_box({0.46f, rise, 0.07f}, {0.032f, 0.014f, 0.002f, 10, k.seed()});
    shapes::turn(back, {1, 0, 0}, lean);
    k.add(std::move(back), cloth, {0, y - 0.02f + 0.5f * rise, -0.235f});
    for (const float sx : {-1.f, 1.f})  // what bears the back
        k.rod(frame, {sx * 0.17f, y - 0.09f, -0.19f}, {sx * 0.17f, y + 0.06f, -0.215f}, 0.013f, -1, 10);
    k.top(y + 0.012f, 0, 0.03f, 0.18f, 0.16f);
    k.piece.clearance_front_m = 0.3f;
}

}  // namespace

void build_chair(Kit& k) {
    if (is_woven(k)) return woven_chair(k);
    if (is_upholstery(k.request.material)) return upholstered_chair(k);
    const LegType type = k.style.legs;
    const bool metal = type == LegType::metal_frame, wooden = type == LegType::square || type == LegType::turned;
    const int body = k.main(wooden || !metal ? k.style.wood : k.style.leather), pad = k.material(k.style.fabric2),
              frame = metal ? k.material(k.style.metal) : body;
    const float y = 0.46f;
    legs(k, frame, 0.19f, 0.19f, y - 0.02f, 0.036f);
    if (metal) {
        k.soft(body, {0, y - 0.025f, 0.01f}, {0.46f, 0.07f, 0.46f}, {0.03f, 0.012f, 0.001f, 8});
        Mesh back = shapes::soft_box({0.44f, 0.34f, 0.05f}, {0.02f, 0.01f, 0.001f, 10, k.seed()});
        shapes::turn(back, {1, 0, 0}, -9);
        k.add(std::move(back), body, {0, 0.7f, -0.235f});
        for (const float sx : {-1.f, 1.f})
            k.rod(frame, {sx * 0.19f, y - 0.03f, -0.19f}, {sx * 0.19f, 0.78f, -0.265f}, 0.011f);
    } else {
        k.add(shapes::prism(shapes::rounded_rectangle(0.45f, 0.43f, 0.06f), y - 0.025f, y, 0.006f), body);
        if (k.style.sofa == SofaType::rolled || type == LegType::turned)
            k.soft(pad, {0, y - 0.006f, 0.01f}, {0.41f, 0.05f, 0.39f}, {0.02f, 0.012f, 0.001f, 10});
        for (const float sx : {-1.f, 1.f})
            k.rod(body, {sx * 0.19f, y - 0.01f, -0.185f}, {sx * 0.2f, 0.88f, -0.27f}, 0.018f, 0.013f, 12);
        const auto rail = [&](float yy, float h) {
            Mesh m = shapes::slab(10, 2, 0.016f, [&](float u, float v) {
                const float x = (u - 0.5f) * 0.4f, t = (yy + v * h - y) / 0.42f;
                return Vec3f{x, yy + v * h, -0.178f - 0.085f * t - 0.035f * (1.f - 4.f * (u - 0.5f) * (u - 0.5f))};
            });
            k.add(std::move(m), body);
        };
        if (type == LegType::square) {
            for (int i = 0; i < 3; ++i) rail(0.56f + 0.11f * static_cast<float>(i), 0.05f);
        } else if (type == LegType::turned) {
            rail(0.8f, 0.08f);
            for (int i = -2; i <= 2; ++i) {
                const float x = 0.065f * static_cast<float>(i), bow = 0.03f * (1.f - x * x / 0.04f);
                k.rod(body, {x, y - 0.01f, -0.185f}, {x, 0.815f, -0.262f - bow}, 0.008f, -1, 8);
            }
        } else {
            rail(0.7f, 0.17f);
        }
    }
    const bool padded = metal || k.style.sofa == SofaType::rolled || type == LegType::turned;
    k.top(padded ? y + 0.044f : y, 0, 0.03f, 0.18f, 0.16f);
    k.piece.clearance_front_m = 0.3f;
}

}  // namespace fastscene::furniture
