// Dressing table.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A table with drawers to either side, a mirror on it, and what one needs before it.
void build_dressing_table(Kit& k) {
    const Vec3f s = k.wanted({1.1f, 0.76f, 0.45f});
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal),
              frame = k.material(k.style.mouldings == Mouldings::rich ? k.style.metal : k.style.wood);
    Material silvered = plain("mirror", {0.85f, 0.85f, 0.85f}, 0.05f);
    silvered.mirror = 1.f;
    const int silver = k.material(silvered);
    const float hx = 0.5f * s.x, hz = 0.5f * s.z, low = s.y - 0.2f;
    legs(k, wood, hx - 0.05f, hz - 0.05f, low + 0.01f, 0.045f);
    k.board(wood, {0, s.y - 0.028f, 0}, {s.x, 0.028f, s.z}, 0.006f);
    for (const float sx : {-1.f, 1.f}) {
        const float cx = sx * (hx - 0.19f);
        k.board(wood, {cx, low, -0.01f}, {0.34f, 0.172f, s.z - 0.06f}, 0.004f);
        fronts(k, wood, metal, cx - 0.165f, cx + 0.165f, low + 0.004f, s.y - 0.032f, hz - 0.04f, 1, 1);
    }
    k.board(wood, {0, s.y - 0.1f, -0.02f}, {s.x - 0.7f, 0.07f, s.z - 0.1f}, 0.003f);
    // An oval mirror between two posts.
    const float wide = 0.5f, high = 0.66f, foot = s.y + 0.03f, z = -hz + 0.05f;
    std::vector<Vec2f> oval;
    for (int i = 0; i < 48; ++i) {
        const float a = kTau * static_cast<float>(i) / 48.f;
        oval.push_back({0.5f * wide * std::cos(a), 0.5f * high * std::sin(a)});
    }
    Mesh pane = shapes::prism(oval, -0.004f, 0.004f, 0.001f);
    shapes::turn(pane, {1, 0, 0}, 90);
    k.add(std::move(pane), silver, {0, foot + 0.5f * high, z + 0.008f});
    std::vector<Vec3f> rim;
    for (const Vec2f p : oval) rim.push_back({p.x, foot + 0.5f * high + p.y, z + 0.006f});
    rim.push_back(rim.front());
    k.add(shapes::tube(rim, 0.016f, 10), frame);
    k.board(frame, {0, s.y, z}, {0.3f, 0.04f, 0.06f}, 0.008f);
    // Bottles and a jar beside it.
    for (int i = 0; i < 4; ++i) {
        const float x = (i % 2 ? 1.f : -1.f) * (0.3f + 0.07f * static_cast<float>(i / 2)),
                    h = k.rng.uniform(0.06f, 0.14f), r = k.rng.uniform(0.016f, 0.026f);
        const std::array<Vec2f, 5> bottle{
            Vec2f{r, 0}, {r, 0.7f * h}, {0.4f * r, 0.8f * h}, {0.4f * r, h}, {0.2f * r, h}};
        k.add(shapes::lathe(bottle, 20, false),
              k.material(plain("perfume", lerp(k.accent(), {0.7f, 0.6f, 0.55f}, 0.4f), 0.12f)),
              {x, s.y, -0.25f * hz + 0.04f * static_cast<float>(i % 3)});
    }
    k.piece.surfaces.push_back({{0, s.y, 0.35f * hz}, {0.8f * hx, 0.3f * hz}});
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.75f;
}

}  // namespace fastscene::furniture
