// Pen.
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/kitchen/tableware.h"

namespace fastscene::furniture {

// A jar of pencils and brushes, and what lies before it: pens alone nobody would see from across the room.
void build_pen(Kit& k) {
    const int jar = glazed(k), wood = k.material(k.style.wood2);
    const std::array<Vec2f, 4> p{Vec2f{0.046f, 0}, {0.052f, 0.01f}, {0.052f, 0.1f}, {0.048f, 0.115f}};
    Mesh vessel = shapes::vessel(p, 0.004f, 20);
    k.add(std::move(vessel), jar, {-0.05f, 0, -0.03f});
    for (int i = 0; i < 8; ++i) {
        const float a = 0.8f * static_cast<float>(i);
        const Vec3f foot{-0.05f + 0.025f * std::cos(a), 0.01f, -0.03f + 0.025f * std::sin(a)},
            tip{-0.05f + 0.06f * std::cos(a), k.rng.uniform(0.17f, 0.24f), -0.03f + 0.05f * std::sin(a)};
        const int paint = k.material(plain("paint", k.accent(), 0.4f));
        k.rod(i % 2 ? wood : paint, foot, tip, 0.004f);
        k.add(shapes::ball(tip, {0.008f, 0.018f, 0.008f}, 8), paint);
    }
    for (int i = 0; i < 3; ++i) {
        const float z = 0.045f + 0.022f * static_cast<float>(i), x = k.rng.uniform(-0.01f, 0.03f);
        k.rod(k.material(plain("paint", k.accent(), 0.4f)), {x - 0.07f, 0.009f, z}, {x + 0.06f, 0.009f, z + 0.01f},
              0.009f, 0.007f);
    }
    on_surface(k);
}

}  // namespace fastscene::furniture
