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
    const int log = k.material(wood), fire = k.material(flame("fire", {13.f, 3.f, 0.3f})),
              embers = k.material(flame("embers", {6.f, 0.9f, 0.06f}));
    for (const float sx : {-1.f, 1.f}) k.board(body, {sx * 0.56f, 0, 0}, {0.28f, 1.02f, 0.36f}, 0.01f);
    k.board(body, {0, 0.72f, 0}, {0.842f, 0.3f, 0.36f}, 0.008f);
    k.board(soot, {0, 0.03f, -0.16f}, {0.842f, 0.7f, 0.04f});
    k.board(body, {0, 0, 0.08f}, {1.5f, 0.035f, 0.56f}, 0.006f);
    k.board(top, {0, 1.02f, 0.02f}, {1.54f, 0.055f, 0.42f}, 0.008f);
    for (int i = 0; i < 3; ++i)
        k.rod(log, {-0.24f, 0.075f + (i == 2 ? 0.075f : 0.f), 0.f + 0.1f * static_cast<float>(i % 2)},
              {0.24f, 0.08f + (i == 2 ? 0.08f : 0.f), 0.03f + 0.07f * static_cast<float>(i % 2)}, 0.04f, 0.036f, 12);
    // Tongues that lick to one side and end in a point, the highest in the middle; embers between the logs.
    for (int i = 0; i < 11; ++i) {
        const float x = -0.2f + 0.04f * static_cast<float>(i), h = k.rng.uniform(0.13f, 0.3f) * (1.f - 9.f * x * x),
                    lean = k.rng.uniform(-0.3f, 0.3f);
        const std::array<Vec2f, 6> p{Vec2f{0, 0},        {0.026f, 0.12f * h}, {0.03f, 0.3f * h},
                                     {0.017f, 0.6f * h}, {0.006f, 0.85f * h}, {0, h}};
        Mesh tongue = shapes::lathe(shapes::curve(p, 2), 10, true);
        for (Vec3f& q : tongue.positions)
            q.x += lean * h * (q.y / h) * (q.y / h) + 0.012f * std::sin(22.f * q.y + static_cast<float>(i)) * q.y / h;
        shapes::smooth_normals(tongue);
        k.add(std::move(tongue), i % 3 == 1 ? embers : fire, {x, 0.11f, 0.05f + k.rng.uniform(-0.05f, 0.05f)});
    }
    k.board(embers, {0, 0.05f, 0.05f}, {0.4f, 0.03f, 0.12f}, 0.01f);
    k.top(1.075f, 0, 0.02f, 0.7f, 0.16f);
    k.piece.clearance_front_m = 0.9f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
