// Grandfather clock.
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A tall case: plinth, trunk with a glass door before the pendulum, hood with the dial; its top is arched, stepped or
// plain as the style has it.
void build_grandfather_clock(Kit& k) {
    const Vec3f s = k.wanted({0.5f, 2.02f, 0.28f});
    const int wood = k.main(k.style.of(k.style.made_of.clock_case)), brass = k.material(*material_named("brass")),
              face = k.material(plain("dial", {0.72f, 0.68f, 0.57f}, 0.5f)),
              dark = k.material(plain("clock hands", {0.035f, 0.035f, 0.035f}, 0.5f)),
              shade = k.material(plain("clock case", {0.06f, 0.04f, 0.028f}, 0.8f)), pane = k.material(glass());
    const bool formal = k.style.formal_clocks;
    const float h = s.y, w = s.x, d = s.z, plinth = 0.19f * h, hood = 0.72f * h, top = 0.945f * h, trunk = 0.76f * w,
                deep = 0.8f * d;
    const auto moulding = [&](float y, float width, float depth, float high) {
        k.board(wood, {0, y, 0}, {width, high, depth}, 0.35f * high);
    };
    // Plinth.
    k.board(wood, {0, 0, 0}, {w, 0.05f, d}, 0.006f);
    k.board(wood, {0, 0.05f, 0}, {0.92f * w, plinth - 0.05f, 0.93f * d}, 0.004f);
    if (formal) k.board(wood, {0, 0.09f, 0.465f * d}, {0.66f * w, plinth - 0.14f, 0.012f}, 0.005f);
    moulding(plinth, 0.9f * w, 0.92f * d, 0.03f);
    if (formal) moulding(plinth + 0.03f, 0.83f * w, 0.86f * d, 0.02f);
    // Trunk: its back and sides, a door with a pane, the pendulum and the weights behind it.
    const float t0 = plinth + (formal ? 0.05f : 0.03f), t1 = hood - 0.05f, front = 0.5f * deep, stile = 0.055f;
    k.board(shade, {0, t0, -0.5f * deep + 0.01f}, {trunk, t1 - t0, 0.02f}, 0.002f);
    for (const float sx : {-1.f, 1.f}) {
        k.board(wood, {sx * (0.5f * trunk - 0.01f), t0, 0}, {0.02f, t1 - t0, deep}, 0.003f);
        k.board(wood, {sx * (0.5f * trunk - 0.5f * stile), t0, front}, {stile, t1 - t0, 0.022f}, 0.004f);
    }
    k.board(wood, {0, t0, front}, {trunk - 2 * stile, 0.07f, 0.022f}, 0.004f);
    k.board(wood, {0, t1 - 0.07f, front}, {trunk - 2 * stile, 0.07f, 0.022f}, 0.004f);
    k.board(pane, {0, t0 + 0.07f, front - 0.003f}, {trunk - 2 * stile, t1 - t0 - 0.14f, 0.003f}, 0.0008f);
    k.add(shapes::ball({0.5f * trunk - 0.5f * stile, 0.5f * (t0 + t1), front + 0.018f}, {0.009f, 0.009f, 0.009f}, 10),
          brass);
    const float bob = t0 + 0.25f;
    k.rod(brass, {0.02f, bob, 0}, {0, t1, 0}, 0.005f, -1, 8);
    Mesh disc = shapes::prism(shapes::circle(0.065f, 36), -0.011f, 0.011f, 0.009f);
    shapes::turn(disc, {1, 0, 0}, 90);
    k.add(std::move(disc), brass, {0.02f, bob, 0.004f});
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.075f, y = t1 - (sx > 0 ? 0.42f : 0.56f);
        k.rod(brass, {x, y, -0.03f}, {x, y + 0.19f, -0.03f}, 0.021f, -1, 18);
        k.rod(brass, {x, y + 0.19f, -0.03f}, {x, t1, -0.03f}, 0.0022f, -1, 6);
    }
    moulding(t1, 0.84f * w, 0.88f * d, 0.02f);
    moulding(t1 + 0.02f, 0.94f * w, 0.95f * d, 0.03f);
    // Hood: a box with the dial, columns at its corners.
    const float hw = 0.88f * w, hd = 0.9f * d, hz = 0.5f * hd, dial = 0.185f * h * 0.9f * 0.5f + 0.03f,
                cy = 0.5f * (hood + top);
    k.board(wood, {0, hood, -0.01f}, {hw, top - hood, hd - 0.03f}, 0.004f);
    Mesh ring = shapes::ring(dial, 0.022f, 48), plate = shapes::prism(shapes::circle(dial, 48), 0.f, 0.006f, 0.001f);
    shapes::turn(ring, {1, 0, 0}, 90), shapes::turn(plate, {1, 0, 0}, 90);
    const float fz = hz - 0.024f;
    k.board(brass, {0, cy - dial - 0.02f, fz}, {2 * dial + 0.04f, 2 * dial + 0.04f, 0.006f}, 0.001f);
    k.add(std::move(plate), face, {0, cy, fz});
    k.add(std::move(ring), brass, {0, cy, fz + 0.008f});
    const auto hand = [&](float from, float to, float wide, float degrees, float z, int material) {
        Mesh m = shapes::box({wide, to - from, 0.002f}, 0.0005f);
        shapes::move(m, {0, 0.5f * (from + to), 0});
        shapes::turn(m, {0, 0, 1}, degrees);
        k.add(std::move(m), material, {0, cy, z});
    };
    for (int i = 0; i < 12; ++i)
        hand(0.72f * dial, 0.88f * dial, i % 3 == 0 ? 0.011f : 0.006f, 30.f * static_cast<float>(i), fz + 0.0068f,
             dark);
    hand(-0.02f, 0.5f * dial, 0.011f, k.rng.uniform(0, 360), fz + 0.0095f, dark);
    hand(-0.025f, 0.76f * dial, 0.008f, k.rng.uniform(0, 360), fz + 0.0125f, dark);
    if (formal)
        for (const float sx : {-1.f, 1.f}) {
            k.rod(wood, {sx * (0.5f * hw - 0.012f), hood + 0.03f, hz - 0.014f},
                  {sx * (0.5f * hw - 0.012f), top - 0.02f, hz - 0.014f}, 0.015f, 0.012f, 14);
            for (const float y : {hood, top - 0.03f})
                k.board(brass, {sx * (0.5f * hw - 0.012f), y, hz - 0.014f}, {0.036f, 0.03f, 0.036f}, 0.004f);
        }
    moulding(top, 0.96f * w, 0.97f * d, 0.025f);
    moulding(top + 0.02f, w, d, 0.022f);
    if (formal) {
        // An arch over the hood, a brass ball on it.
        std::vector<Vec2f> arch;
        const float rise = h - top - 0.075f;
        for (int i = 0; i <= 20; ++i) {
            const float t = static_cast<float>(i) / 10.f - 1.f;
            arch.push_back(
                {0.46f * w * t, -(0.25f * rise + 0.75f * rise * std::cos(0.5f * kPi * t) * std::cos(0.5f * kPi * t))});
        }
        arch.push_back({0.46f * w, 0}), arch.push_back({-0.46f * w, 0});
        Mesh m = shapes::prism(arch, -0.4f * d, 0.46f * d, 0.006f);
        shapes::turn(m, {1, 0, 0}, 90);
        k.add(std::move(m), wood, {0, top + 0.042f, 0});
        k.rod(brass, {0, h - 0.05f, 0}, {0, h - 0.028f, 0}, 0.008f, -1, 10);
        k.add(shapes::ball({0, h - 0.017f, 0}, {0.017f, 0.017f, 0.017f}, 16), brass);
    } else {
        k.board(wood, {0, top + 0.042f, 0}, {0.8f * w, h - top - 0.042f, 0.8f * d}, 0.004f);
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture
