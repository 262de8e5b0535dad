// Tables to play at: table tennis, pool.
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A low table with two stools of its kind; paper, pencils and bricks on it.
void build_play_table(Kit& k) {
    const bool light = k.style.lacquered_play;
    const int top = k.main(light ? *material_named("lacquer") : k.style.wood2),
              leg = k.material(light ? *material_named("birch") : k.style.wood2);
    const float high = 0.48f, half = 0.33f;
    const bool round = k.rng.chance(0.5f);
    k.add(shapes::prism(round ? shapes::circle(0.38f) : shapes::rounded_rectangle(0.78f, 0.6f, 0.08f), high - 0.026f,
                        high, 0.008f),
          top);
    const float lx = round ? 0.22f : 0.3f, lz = round ? 0.22f : 0.21f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(leg, {sx * (lx + 0.03f), 0, sz * (lz + 0.03f)}, {sx * lx, high - 0.02f, sz * lz}, 0.017f, 0.023f, 12);
    for (const float sx : {-1.f, 1.f}) {
        const Vec3f at{sx * (half + 0.25f), 0, k.rng.uniform(-0.06f, 0.06f)};
        const int seat = k.material(plain("stool", k.accent(), 0.4f));
        k.add(shapes::prism(shapes::circle(0.145f, 32), 0.265f, 0.29f, 0.008f), seat, at);
        for (int i = 0; i < 3; ++i) {
            const float a = kTau * (static_cast<float>(i) / 3.f + 0.1f), c = std::cos(a), s = std::sin(a);
            k.rod(leg, at + Vec3f{0.135f * c, 0, 0.135f * s}, at + Vec3f{0.09f * c, 0.27f, 0.09f * s}, 0.012f, 0.016f,
                  10);
        }
    }
    // Two sheets, one with a sun on it; pencils; a tower of bricks.
    const int paper = k.material(plain("paper", {0.76f, 0.75f, 0.72f}, 0.9f));
    for (const float s : {-1.f, 1.f}) {
        Mesh sheet = shapes::box({0.2f, 0.002f, 0.15f}, 0.0006f);
        shapes::turn(sheet, {0, 1, 0}, k.rng.uniform(-20, 20));
        k.add(std::move(sheet), paper, {0.13f * s, high + 0.001f, 0.07f});
    }
    k.add(shapes::prism(shapes::circle(0.03f, 24), high + 0.002f, high + 0.0032f, 0.0004f),
          k.material(plain("crayon", {0.75f, 0.5f, 0.06f}, 0.7f)), {0.13f, 0, 0.07f});
    for (int i = 0; i < 4; ++i) {
        const float a = k.rng.uniform(0.f, kTau);
        const Vec3f at{-0.1f + 0.06f * static_cast<float>(i), high + 0.005f,
                       -0.03f + 0.02f * static_cast<float>(i % 2)},
            along{0.045f * std::cos(a), 0, 0.045f * std::sin(a)};
        k.rod(k.material(plain("crayon", k.style.palette[static_cast<std::size_t>(i) % k.style.palette.size()], 0.5f)),
              at - along, at + along, 0.0045f, -1, 8);
    }
    float y = high;
    for (int i = 0; i < 4; ++i) {
        const Vec3f size{0.075f - 0.008f * static_cast<float>(i), 0.045f, 0.06f - 0.006f * static_cast<float>(i)};
        k.board(k.material(plain("toy block", k.accent(), 0.4f)), {0.02f + k.rng.uniform(-0.008f, 0.008f), y, -0.16f},
                size, 0.005f);
        y += size.y;
    }
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture
