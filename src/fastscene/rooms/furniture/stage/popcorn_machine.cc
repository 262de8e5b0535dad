// A cart with a lit glass case full of popcorn.
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

void build_popcorn_machine(Kit& k) {
    const Vec3f s = k.wanted({0.75f, 1.75f, 0.55f});
    const int red = k.main(plain("red enamel", {0.36f, 0.022f, 0.02f}, 0.25f)),
              brass = k.material(*material_named("brass")), pane = k.material(glass()), metal = k.material(steel()),
              tire = color(k, "tire", {0.03f, 0.03f, 0.03f}, 0.7f),
              corn = color(k, "popcorn", {0.68f, 0.58f, 0.34f}, 0.9f),
              light = k.material(glow("case light", {2.2f, 1.8f, 1.1f}));
    const float x = 0.5f * s.x, z = 0.5f * s.z - 0.06f, low = 0.78f, high = s.y - 0.3f;
    k.board(red, {0, 0.24f, 0}, {s.x - 0.06f, low - 0.26f, 2 * z}, 0.012f);
    k.board(brass, {0, low - 0.03f, 0}, {s.x, 0.03f, 2 * z + 0.06f}, 0.006f);
    for (const float side : {-1.f, 1.f}) {  // two spoked wheels, and feet behind
        const Vec3f hub{0.26f * side * s.x / 0.75f, 0.24f, z + 0.03f};
        Mesh rim = shapes::ring(0.22f, 0.022f, 28);
        shapes::turn(rim, {1, 0, 0}, 90);
        k.add(std::move(rim), tire, hub);
        for (int i = 0; i < 8; ++i) {
            const Vec3f d = around(kTau * static_cast<float>(i) / 8);
            k.rod(brass, hub, hub + Vec3f{0.21f * d.x, 0.21f * d.z, 0}, 0.006f, -1, 6);
        }
        k.rod(brass, hub - Vec3f{0, 0, 0.03f}, hub + Vec3f{0, 0, 0.012f}, 0.03f, -1, 12);
        k.rod(red, {side * (x - 0.1f), 0, -z + 0.05f}, {side * (x - 0.1f), 0.25f, -z + 0.05f}, 0.02f, -1, 10);
        for (const float d : {-1.f, 1.f})
            k.board(brass, {side * (x - 0.03f), low, d * (z - 0.015f)}, {0.03f, high - low, 0.03f}, 0.003f);
        k.board(pane, {side * (x - 0.03f), low, 0}, {0.005f, high - low, 2 * z - 0.05f}, 0.001f);
    }
    for (const float d : {-1.f, 1.f})
        k.board(pane, {0, low, d * (z - 0.015f)}, {s.x - 0.1f, high - low, 0.005f}, 0.001f);
    k.board(red, {0, high, 0}, {s.x, 0.05f, 2 * z + 0.06f}, 0.01f);
    k.board(red, {0, high + 0.05f, 0}, {s.x - 0.08f, s.y - high - 0.05f, 2 * z - 0.02f}, 0.02f);
    sign(k, "POPCORN", {0.66f, 0.6f, 0.45f}, {0.36f, 0.022f, 0.02f}, {-0.42f * s.x, high + 0.075f, z - 0.007f},
         {0.84f * s.x, s.y - high - 0.1f});
    k.board(light, {0, high - 0.02f, 0}, {0.3f, 0.02f, 0.2f}, 0.004f);
    // the kettle, and a heap that has grown against the panes
    const std::array<Vec2f, 5> kettle{Vec2f{0.05f, 0}, {0.1f, 0.02f}, {0.11f, 0.1f}, {0.1f, 0.13f}, {0.02f, 0.15f}};
    k.add(shapes::lathe(kettle, 20), metal, {0.02f, high - 0.32f, -0.03f});
    k.rod(metal, {0.02f, high - 0.18f, -0.03f}, {0.02f, high, -0.03f}, 0.012f, -1, 8);
    for (int i = 0; i < 240; ++i) {
        const float u = k.rng.uniform(-1, 1), v = k.rng.uniform(-1, 1),
                    heap = 0.1f + 0.14f * (1 - 0.6f * u * u) * (1 - 0.3f * v);
        const float r = k.rng.uniform(0.014f, 0.022f);
        k.add(shapes::ball({0, 0, 0}, {r, 0.8f * r, 0.9f * r}, 6), corn,
              {u * (x - 0.07f), low + k.rng.uniform(0.3f, 1.f) * heap, v * (z - 0.045f)});
    }
    k.board(corn, {0, low, 0}, {s.x - 0.09f, 0.09f, 2 * z - 0.06f}, 0.02f);
    k.rod(brass, {-x - 0.02f, low + 0.1f, -z + 0.03f}, {x + 0.02f, low + 0.1f, -z + 0.03f}, 0.012f, -1, 8);
    k.piece.clearance_front_m = 0.7f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
