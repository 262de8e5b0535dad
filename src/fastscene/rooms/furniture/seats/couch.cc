// An upholstered seat with arms, back and cushions.
#include "fastscene/rooms/furniture/seats/couch.h"

#include <array>
#include <utility>

#include "fastscene/rooms/furniture/forms.h"

namespace fastscene::furniture {

void couch(Kit& k, float width, int seats, int pillows) {
    const SofaType type = k.style.sofa;
    const bool slim = type == SofaType::slim, rolled = type == SofaType::rolled;
    const int cloth = k.main(k.style.fabric), foot = k.material(slim ? k.style.wood : k.style.wood2);
    const float depth = slim ? 0.82f : 0.93f, seat_y = 0.43f,
                arm = slim     ? 0.07f
                      : rolled ? 0.17f
                               : 0.2f,
                back_y = slim     ? 0.8f
                         : rolled ? 0.9f
                                  : 0.84f;
    const float leg = slim ? 0.17f : rolled ? 0.09f : 0.05f, inside = width - 2 * arm, arm_y = slim ? 0.6f : 0.63f;
    const float z0 = -0.5f * depth;
    // Legs, base, back.
    for (const float sx : {-1.f, 1.f})
        for (const float z : {z0 + 0.1f, -z0 - 0.1f}) {
            const Vec3f top{sx * (0.5f * width - 0.12f), leg + 0.01f, z};
            k.rod(foot, {top.x + (slim ? sx * 0.03f : 0.f), 0, z * (slim ? 1.06f : 1.f)}, top, slim ? 0.013f : 0.022f,
                  slim ? 0.024f : 0.028f, 12);
        }
    k.soft(cloth, {0, leg, 0}, {width - (slim ? 0.02f : 0.04f), seat_y - 0.16f - leg, depth - 0.03f},
           {0.02f, 0.004f, 0.002f, 8});
    const float back_t = 0.2f;
    Mesh back = shapes::soft_box({inside + (slim ? 0.1f : 0.02f), back_y - leg - 0.04f, back_t},
                                 {0.05f, 0.01f, 0.002f, 6, k.seed()});
    k.add(std::move(back), cloth, {0, 0.5f * (back_y + leg) - 0.02f, z0 + 0.5f * back_t});
    // Arms.
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.5f * (width - arm);
        if (slim) {
            k.soft(cloth, {x, seat_y - 0.2f, 0}, {arm, arm_y - seat_y + 0.2f, depth - 0.02f},
                   {0.03f, 0.006f, 0.001f, 8});
        } else if (rolled) {
            k.soft(cloth, {x - sx * 0.02f, leg, 0}, {arm - 0.04f, arm_y - 0.06f - leg, depth - 0.03f},
                   {0.03f, 0.01f, 0.001f, 8});
            const std::array<Vec2f, 6> p{Vec2f{0.055f, 0},        {0.085f, 0.012f},         {0.092f, 0.05f},
                                         {0.092f, depth - 0.05f}, {0.085f, depth - 0.012f}, {0.055f, depth}};
            Mesh roll = shapes::lathe(p, 24, true);
            shapes::turn(roll, {1, 0, 0}, 90);
            k.add(std::move(roll), cloth, {x, arm_y - 0.02f, z0});
        } else {
            k.soft(cloth, {x, leg, 0}, {arm, arm_y - leg, depth}, {0.05f, 0.015f, 0.002f, 8});
        }
    }
    // Cushions.
    const float w = inside / static_cast<float>(seats);
    for (int i = 0; i < seats; ++i) {
        const float x = -0.5f * inside + (static_cast<float>(i) + 0.5f) * w;
        k.soft(cloth, {x, seat_y - 0.17f, 0.5f * back_t - 0.02f}, {w - 0.004f, 0.19f, depth - back_t + 0.01f},
               {0.05f, 0.035f, 0.004f, 9});
        Mesh pad = shapes::soft_box({w - 0.01f, back_y - seat_y + 0.06f, 0.2f}, {0.07f, 0.05f, 0.006f, 9, k.seed()});
        shapes::turn(pad, {1, 0, 0}, -11);
        k.add(std::move(pad), cloth, {x, 0.5f * (back_y + seat_y) + 0.04f, z0 + back_t + 0.06f});
    }
    for (int i = 0; i < pillows; ++i) {
        const int mat = accent_cloth(k);
        const float s = k.rng.uniform(0.4f, 0.47f), sx = i % 2 == 0 ? -1.f : 1.f;
        put_pillow(k, mat,
                   {sx * (0.5f * inside - 0.24f - 0.22f * static_cast<float>(i / 2)), seat_y + 0.005f,
                    z0 + back_t + 0.27f + 0.05f * static_cast<float>(i / 2)},
                   {s, s, 0.16f}, 20, -sx * 18.f + k.rng.uniform(-8, 8));
    }
    if (rolled)
        k.rod(cloth, {-0.5f * inside, back_y - 0.05f, z0 + 0.09f}, {0.5f * inside, back_y - 0.05f, z0 + 0.09f}, 0.075f,
              -1, 20);
    k.piece.clearance_front_m = 0.5f;
    k.piece.against_wall = true;
    k.top(seat_y + 0.02f, 0, 0.12f, 0.4f * inside, 0.2f);
}

}  // namespace fastscene::furniture
