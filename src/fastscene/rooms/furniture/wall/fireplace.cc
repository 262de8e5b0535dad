// Fireplace.
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_fireplace(Kit& k) {
    Material stone = k.style.mouldings == Mouldings::none ? k.style.accent_wall : *material_named("marble");
    const int body = k.main(stone), soot = k.material(plain("soot", {0.035f, 0.032f, 0.03f}, 0.95f)),
              top = k.material(k.style.mouldings == Mouldings::rich ? stone : k.style.wood);
    Material wood = plain("log", {0.2f, 0.12f, 0.07f}, 0.9f);
    wood.pattern = Pattern::bark;
    wood.scale_m = 0.05f;
    wood.color_b = {0.06f, 0.04f, 0.03f};
    const int log = k.material(wood), fire = k.material(flame("fire", {9.f, 2.1f, 0.2f})),
              core = k.material(flame("fire core", {21.f, 9.f, 1.4f})),
              embers = k.material(flame("embers", {5.f, 0.7f, 0.05f}));
    for (const float sx : {-1.f, 1.f}) k.board(body, {sx * 0.56f, 0, 0}, {0.28f, 1.02f, 0.36f}, 0.01f);
    k.board(body, {0, 0.72f, 0}, {0.842f, 0.3f, 0.36f}, 0.008f);
    k.board(soot, {0, 0.03f, -0.16f}, {0.842f, 0.7f, 0.04f});
    k.board(body, {0, 0, 0.08f}, {1.5f, 0.035f, 0.56f}, 0.006f);
    k.board(top, {0, 1.02f, 0.02f}, {1.54f, 0.055f, 0.42f}, 0.008f);
    for (int i = 0; i < 3; ++i)
        k.rod(log, {-0.24f, 0.075f + (i == 2 ? 0.075f : 0.f), 0.f + 0.1f * static_cast<float>(i % 2)},
              {0.24f, 0.08f + (i == 2 ? 0.08f : 0.f), 0.03f + 0.07f * static_cast<float>(i % 2)}, 0.04f, 0.036f, 12);
    // Tongues that lick to one side and end in a point, the highest in the middle, each about a bright core; embers
    // between the logs.
    for (int i = 0; i < 9; ++i) {
        const float x = -0.2f + 0.05f * static_cast<float>(i), h = k.rng.uniform(0.2f, 0.42f) * (1.f - 9.f * x * x),
                    lean = k.rng.uniform(-0.25f, 0.25f), twist = k.rng.uniform(0, kTau);
        const Vec3f at{x, 0.09f, 0.05f + k.rng.uniform(-0.06f, 0.06f)};
        const auto tongue = [&](float high, float wide, int material) {
            const std::array<Vec2f, 6> p{Vec2f{0, 0},
                                         {0.7f * wide, 0.1f * high},
                                         {wide, 0.28f * high},
                                         {0.6f * wide, 0.58f * high},
                                         {0.22f * wide, 0.82f * high},
                                         {0, high}};
            Mesh m = shapes::lathe(shapes::curve(p, 3), 16, true);
            for (Vec3f& q : m.positions) {
                const float up = q.y / h;
                q.x += lean * h * up * up + 0.022f * std::sin(16.f * q.y + twist) * up;
                q.z += 0.015f * std::sin(13.f * q.y + 2.f * twist) * up;
            }
            shapes::smooth_normals(m);
            k.add(std::move(m), material, at);
        };
        tongue(h, 0.05f, fire);
        tongue(0.55f * h, 0.028f, core);
    }
    k.board(embers, {0, 0.05f, 0.05f}, {0.4f, 0.03f, 0.12f}, 0.01f);
    k.top(1.075f, 0, 0.02f, 0.7f, 0.16f);
    k.piece.clearance_front_m = 0.9f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
