// Big toys of playrooms, and what babies need: a slide, a swing, a play kitchen, a changing table, a stroller.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// A wheel across x, its tire round.
void playroom_wheel(Kit& k, int tire, int hub, Vec3f c, float r, float thick) {
    Mesh m = shapes::ring(r - thick, thick, 20);
    shapes::turn(m, {0, 0, 1}, 90);
    k.add(std::move(m), tire, c);
    k.rod(hub, c - Vec3f{0.7f * thick, 0, 0}, c + Vec3f{0.7f * thick, 0, 0}, r - 1.2f * thick, -1, 16);
}

}  // namespace

void build_slide(Kit& k) {
    const int chute = k.main(plain("slide", {0.65f, 0.06f, 0.04f}, 0.3f)),
              side = color(k, "ladder sides", {0.05f, 0.2f, 0.55f}, 0.35f),
              step = color(k, "steps", {0.7f, 0.5f, 0.05f}, 0.35f);
    const auto path = [](float v) {
        const float z = -0.25f + 1.25f * v, t = std::clamp((v - 0.08f) / 0.8f, 0.f, 1.f);
        return Vec2f{z, 0.95f - 0.85f * (t * t * (3 - 2 * t))};
    };
    k.add(shapes::slab(1, 22, 0.02f,
                       [&](float u, float v) {
                           return Vec3f{0.42f * (u - 0.5f), path(1 - v).y, path(1 - v).x};
                       }),
          chute);
    for (const float sx : {-1.f, 1.f}) {
        k.add(shapes::slab(1, 22, 0.03f,
                           [&](float u, float v) {
                               return Vec3f{sx * 0.225f, path(v).y - 0.03f + 0.16f * u, path(v).x};
                           }),
              chute);
        strut(k, side, {sx * 0.22f, 0, -0.75f}, {sx * 0.22f, 1.32f, -0.3f}, 0.05f, 0.09f),
            strut(k, side, {sx * 0.22f, 0, 0.02f}, {sx * 0.22f, 0.92f, -0.25f}, 0.05f, 0.07f);
        k.rod(side, {sx * 0.22f, 1.3f, -0.31f}, {sx * 0.22f, 1.05f, -0.05f}, 0.025f, -1, 8);
    }
    for (int i = 0; i < 4; ++i)
        k.board(step, {0, 0.18f + 0.22f * static_cast<float>(i), -0.69f + 0.077f * static_cast<float>(i)},
                {0.4f, 0.035f, 0.12f}, 0.01f);
    k.board(step, {0, 0.93f, -0.33f}, {0.4f, 0.03f, 0.2f}, 0.008f);
    k.piece.clearance_front_m = 0.7f;
}

void build_swing(Kit& k) {
    const int wood = k.main(k.style.wood), cord = color(k, "rope", {0.6f, 0.5f, 0.34f}, 0.9f),
              seat = color(k, "seat", k.accent(), 0.4f);
    const float h = 2.0f, w = 1.7f;
    for (const float sx : {-1.f, 1.f}) {
        for (const float sz : {-1.f, 1.f})
            strut(k, wood, {sx * 0.5f * w, 0, sz * 0.65f}, {sx * (0.5f * w - 0.05f), h, sz * 0.05f}, 0.07f, 0.07f);
        k.board(wood, {sx * (0.5f * w - 0.02f), 0.55f, 0}, {0.05f, 0.06f, 0.92f}, 0.006f);
        k.rod(cord, {sx * 0.21f, 0.46f, 0}, {sx * 0.21f, h, 0}, 0.009f, -1, 8);
        k.rod(cord, {sx * 0.21f, 0.46f, -0.1f}, {sx * 0.21f, 0.62f, 0}, 0.007f, -1, 6),
            k.rod(cord, {sx * 0.21f, 0.46f, 0.1f}, {sx * 0.21f, 0.62f, 0}, 0.007f, -1, 6);
    }
    k.rod(wood, {-0.5f * w - 0.1f, h, 0}, {0.5f * w + 0.1f, h, 0}, 0.05f, -1, 14),
        k.board(seat, {0, 0.43f, 0}, {0.5f, 0.035f, 0.24f}, 0.012f);
    k.piece.clearance_front_m = 0.6f;
}

// A small cooker with an oven, a sink, a shelf and pots.
void build_play_kitchen(Kit& k) {
    const int body = k.main(plain("play kitchen paint", {0.72f, 0.71f, 0.68f}, 0.5f)),
              front = color(k, "doors", k.accent(), 0.5f), wood = k.material(materials::timber("natural", 0.5f)),
              metal = k.material(steel()), dark = color(k, "hob", {0.03f, 0.03f, 0.033f}, 0.3f),
              red = color(k, "ring", {0.5f, 0.06f, 0.03f}, 0.4f), pot = color(k, "pot", {0.55f, 0.05f, 0.05f}, 0.3f);
    const float w = 0.8f, d = 0.38f, top = 0.5f;
    k.board(body, {0, 0, 0}, {w, top - 0.025f, d - 0.03f}, 0.008f),
        k.board(wood, {0, top - 0.025f, 0}, {w + 0.02f, 0.025f, d}, 0.006f);
    k.board(front, {-0.2f, 0.05f, 0.5f * d - 0.012f}, {0.36f, 0.38f, 0.02f}, 0.006f),
        k.board(dark, {-0.2f, 0.12f, 0.5f * d}, {0.26f, 0.2f, 0.006f}, 0.004f),
        k.rod(metal, {-0.33f, 0.39f, 0.5f * d + 0.02f}, {-0.07f, 0.39f, 0.5f * d + 0.02f}, 0.009f, -1, 8);
    k.board(front, {0.2f, 0.05f, 0.5f * d - 0.012f}, {0.36f, 0.38f, 0.02f}, 0.006f),
        k.add(shapes::ball({0.06f, 0.26f, 0.5f * d + 0.015f}, {0.016f, 0.016f, 0.016f}, 10), metal);
    for (int i = 0; i < 4; ++i)
        k.rod(i % 2 ? dark : red, {-0.32f + 0.08f * static_cast<float>(i), 0.452f, 0.5f * d - 0.02f},
              {-0.32f + 0.08f * static_cast<float>(i), 0.452f, 0.5f * d + 0.015f}, 0.016f, -1, 10);
    block(k, dark, {-0.2f, top, 0}, {0.34f, 0.004f, 0.28f});
    for (const float e : {-1.f, 1.f})
        k.add(shapes::prism(shapes::circle(0.06f, 20), top + 0.004f, top + 0.006f, 0.0005f), red,
              {-0.2f + e * 0.085f, 0, 0});
    k.add(shapes::vessel(std::array<Vec2f, 3>{Vec2f{0.05f, 0}, {0.058f, 0.02f}, {0.058f, 0.07f}}, 0.004f, 18), pot,
          {-0.285f, top + 0.006f, 0}),
        k.rod(dark, {-0.23f, top + 0.06f, 0.02f}, {-0.15f, top + 0.07f, 0.06f}, 0.007f, -1, 6);
    k.add(shapes::vessel(std::array<Vec2f, 3>{Vec2f{0.1f, 0}, {0.115f, 0.005f}, {0.12f, 0.012f}}, 0.006f, 22), metal,
          {0.2f, top, 0.01f});
    k.add(shapes::tube(std::vector<Vec3f>{{0.2f, top, -0.13f},
                                          {0.2f, top + 0.14f, -0.13f},
                                          {0.2f, top + 0.17f, -0.1f},
                                          {0.2f, top + 0.16f, -0.05f},
                                          {0.2f, top + 0.12f, -0.04f}},
                       0.01f, 8),
          metal);
    k.board(body, {0, top, -0.5f * d + 0.015f}, {w, 0.5f, 0.025f}, 0.006f);
    for (const float sx : {-1.f, 1.f})
        k.board(body, {sx * (0.5f * w - 0.012f), top, -0.5f * d + 0.1f}, {0.024f, 0.5f, 0.18f}, 0.006f);
    k.board(wood, {0, 0.82f, -0.5f * d + 0.09f}, {w - 0.04f, 0.02f, 0.16f}, 0.004f),
        k.board(wood, {0, 0.98f, -0.5f * d + 0.1f}, {w + 0.02f, 0.025f, 0.2f}, 0.006f);
    for (int i = 0; i < 4; ++i)
        k.add(shapes::vessel(std::array<Vec2f, 3>{Vec2f{0.025f, 0}, {0.032f, 0.01f}, {0.034f, 0.06f}}, 0.004f, 12),
              i % 2 ? front : pot, {-0.25f + 0.16f * static_cast<float>(i), 0.84f, -0.5f * d + 0.09f});
    for (int i = 0; i < 3; ++i)
        k.rod(wood, {-0.3f + 0.06f * static_cast<float>(i), 0.62f, -0.5f * d + 0.035f},
              {-0.3f + 0.06f * static_cast<float>(i), 0.78f, -0.5f * d + 0.035f}, 0.008f, -1, 6);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.5f;
}

void build_tricycle(Kit& k) {
    const int frame = k.main(plain("tricycle lacquer", {0.58f, 0.04f, 0.03f}, 0.25f)),
              tire = color(k, "tire", {0.03f, 0.03f, 0.03f}, 0.8f), hub = color(k, "hub", {0.7f, 0.7f, 0.68f}, 0.4f),
              metal = k.material(steel()), dark = color(k, "saddle", {0.03f, 0.03f, 0.03f}, 0.5f);
    playroom_wheel(k, tire, hub, {0, 0.17f, 0.26f}, 0.17f, 0.022f);
    for (const float sx : {-1.f, 1.f}) {
        playroom_wheel(k, tire, hub, {sx * 0.21f, 0.11f, -0.25f}, 0.11f, 0.02f),
            k.rod(metal, {sx * 0.045f, 0.17f, 0.26f}, {sx * 0.03f, 0.42f, 0.19f}, 0.01f, -1, 8);
        k.rod(metal, {0, 0.17f, 0.26f}, {sx * 0.1f, 0.17f + sx * 0.06f, 0.26f}, 0.008f, -1, 6),
            k.board(dark, {sx * 0.12f, 0.16f + sx * 0.06f, 0.26f}, {0.08f, 0.02f, 0.06f}, 0.006f);
        k.rod(metal, {0, 0.58f, 0.14f}, {sx * 0.18f, 0.6f, 0.08f}, 0.011f, -1, 8),
            k.rod(dark, {sx * 0.15f, 0.597f, 0.09f}, {sx * 0.22f, 0.604f, 0.07f}, 0.016f, -1, 8);
    }
    k.rod(frame, {0, 0.38f, 0.2f}, {0, 0.58f, 0.14f}, 0.018f, -1, 10),
        k.add(shapes::tube(
                  std::vector<Vec3f>{{0, 0.42f, 0.19f}, {0, 0.3f, 0.05f}, {0, 0.22f, -0.12f}, {0, 0.16f, -0.25f}},
                  0.02f, 10),
              frame);
    k.rod(metal, {-0.2f, 0.11f, -0.25f}, {0.2f, 0.11f, -0.25f}, 0.012f, -1, 8),
        k.board(frame, {0, 0.15f, -0.27f}, {0.26f, 0.02f, 0.12f}, 0.008f);
    k.rod(frame, {0, 0.24f, -0.08f}, {0, 0.36f, -0.12f}, 0.016f, -1, 8),
        k.add(shapes::ball({0, 0.38f, -0.12f}, {0.09f, 0.035f, 0.12f}, 14), dark);
    for (const float sx : {-1.f, 1.f})
        k.rod(hub, {sx * 0.22f, 0.6f, 0.07f}, {sx * 0.24f, 0.52f, 0.05f}, 0.005f, 0.012f, 6);
}

// A scooter to kick, on its stand.
void build_scooter(Kit& k) {
    const int metal = k.material(steel()), deck = k.main(plain("scooter deck", k.accent(), 0.4f)),
              dark = color(k, "grip", {0.03f, 0.03f, 0.03f}, 0.8f), hub = color(k, "hub", {0.6f, 0.6f, 0.58f}, 0.4f);
    for (const float z : {-0.36f, 0.36f}) playroom_wheel(k, dark, hub, {0, 0.075f, z}, 0.075f, 0.016f);
    k.board(deck, {0, 0.08f, -0.03f}, {0.11f, 0.03f, 0.5f}, 0.01f),
        k.board(dark, {0, 0.11f, -0.03f}, {0.09f, 0.003f, 0.42f}, 0.001f);
    for (const float sx : {-1.f, 1.f})
        k.rod(metal, {sx * 0.03f, 0.075f, 0.36f}, {sx * 0.025f, 0.19f, 0.32f}, 0.01f, -1, 6),
            k.board(metal, {sx * 0.03f, 0.06f, -0.31f}, {0.012f, 0.03f, 0.12f}, 0.003f),
            k.rod(dark, {sx * 0.12f, 0.93f, 0.17f}, {sx * 0.22f, 0.93f, 0.16f}, 0.016f, -1, 10);
    k.rod(metal, {0, 0.18f, 0.325f}, {0, 0.93f, 0.17f}, 0.018f, 0.016f, 10),
        k.rod(metal, {-0.2f, 0.93f, 0.165f}, {0.2f, 0.93f, 0.165f}, 0.012f, -1, 8);
    k.rod(deck, {0, 0.09f, 0.2f}, {0, 0.22f, 0.3f}, 0.02f, -1, 8),
        k.board(deck, {0, 0.13f, -0.37f}, {0.04f, 0.012f, 0.14f}, 0.004f),
        k.rod(metal, {0.05f, 0.09f, -0.05f}, {0.11f, 0.0f, -0.1f}, 0.007f, -1, 6);
}

// Drawers below a padded top with rims, nappies and a lotion.
void build_changing_table(Kit& k) {
    const Vec3f s = k.wanted({0.9f, 1.0f, 0.55f});
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal),
              pad = k.material(tinted(k.style.fabric, lerp(k.accent(), {0.75f, 0.74f, 0.7f}, 0.6f))),
              white = color(k, "nappies", {0.76f, 0.75f, 0.72f}, 0.8f),
              pale = color(k, "lotion", {0.5f, 0.65f, 0.7f}, 0.3f);
    const float top = s.y - 0.13f;
    k.board(wood, {0, 0.08f, -0.01f}, {s.x, top - 0.08f, s.z - 0.03f}, 0.006f),
        legs(k, wood, 0.5f * s.x - 0.06f, 0.5f * s.z - 0.06f, 0.09f),
        fronts(k, wood, metal, -0.5f * s.x + 0.015f, 0.5f * s.x - 0.015f, 0.1f, top - 0.015f, 0.5f * s.z - 0.026f, 1,
               3);
    for (const float sx : {-1.f, 1.f})
        k.board(wood, {sx * (0.5f * s.x - 0.01f), top, -0.01f}, {0.02f, 0.13f, s.z - 0.03f}, 0.006f);
    k.board(wood, {0, top, -0.5f * s.z + 0.015f}, {s.x, 0.13f, 0.02f}, 0.006f);
    k.soft(pad, {-0.08f, top, 0}, {s.x - 0.24f, 0.07f, s.z - 0.08f}, {0.03f, 0.012f, 0.001f, 8});
    for (const float sz : {-1.f, 1.f})
        k.soft(pad, {-0.08f, top + 0.04f, sz * 0.19f}, {s.x - 0.24f, 0.075f, 0.09f}, {0.035f, 0.01f, 0.001f, 6});
    for (int i = 0; i < 4; ++i)
        k.board(white, {0.5f * s.x - 0.11f, top + 0.025f * static_cast<float>(i), 0.12f}, {0.15f, 0.024f, 0.2f},
                0.008f);
    k.add(shapes::lathe(
              std::array<Vec2f, 5>{Vec2f{0.03f, 0}, {0.032f, 0.1f}, {0.012f, 0.12f}, {0.012f, 0.14f}, {0.016f, 0.16f}},
              14),
          pale, {0.5f * s.x - 0.12f, top, -0.1f});
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

void build_baby_high_chair(Kit& k) {
    const int wood = k.main(k.style.wood), tray = color(k, "tray", {0.75f, 0.74f, 0.71f}, 0.35f),
              cloth = k.material(tinted(k.style.fabric, k.accent())), bowl = color(k, "bowl", k.accent(), 0.3f);
    const float seat = 0.54f;
    for (const float sx : {-1.f, 1.f}) {
        strut(k, wood, {sx * 0.22f, 0, 0.26f}, {sx * 0.19f, 0.76f, 0.13f}, 0.035f, 0.045f),
            strut(k, wood, {sx * 0.22f, 0, -0.27f}, {sx * 0.19f, 0.98f, -0.17f}, 0.035f, 0.045f);
        k.board(wood, {sx * 0.2f, 0.74f, 0.0f}, {0.035f, 0.03f, 0.36f}, 0.008f),
            k.board(wood, {sx * 0.205f, 0.22f, 0}, {0.025f, 0.035f, 0.44f}, 0.006f);
    }
    k.board(wood, {0, seat - 0.03f, -0.02f}, {0.38f, 0.03f, 0.32f}, 0.01f),
        k.board(wood, {0, 0.24f, 0.24f}, {0.42f, 0.025f, 0.13f}, 0.008f),
        k.board(wood, {0, 0.14f, -0.25f}, {0.4f, 0.035f, 0.025f}, 0.006f);
    k.soft(cloth, {0, seat, -0.02f}, {0.34f, 0.04f, 0.28f}, {0.018f, 0.006f, 0.001f, 5}),
        k.soft(cloth, {0, seat + 0.06f, -0.16f}, {0.32f, 0.34f, 0.04f}, {0.018f, 0.006f, 0.001f, 5});
    for (int i = 0; i < 2; ++i)
        k.board(wood, {0, 0.84f + 0.1f * static_cast<float>(i), -0.185f}, {0.38f, 0.06f, 0.02f}, 0.008f);
    k.add(shapes::prism(shapes::rounded_rectangle(0.48f, 0.3f, 0.09f), 0.77f, 0.79f, 0.006f), tray, {0, 0, 0.2f}),
        k.add(shapes::prism(shapes::rounded_rectangle(0.48f, 0.3f, 0.09f), 0.785f, 0.8f, 0.004f), wood,
              {0, -0.03f, 0.2f});
    k.add(shapes::vessel(std::array<Vec2f, 3>{Vec2f{0.04f, 0}, {0.06f, 0.02f}, {0.068f, 0.045f}}, 0.005f, 18), bowl,
          {-0.06f, 0.79f, 0.2f});
    k.piece.clearance_front_m = 0.4f;
}

void build_stroller(Kit& k) {
    const int cloth = k.main(tinted(k.style.fabric, k.rng.chance(0.5f) ? Vec3f{0.06f, 0.08f, 0.14f} : k.accent())),
              metal = k.material(steel()), dark = color(k, "tire", {0.03f, 0.03f, 0.03f}, 0.8f),
              hub = color(k, "hub", {0.5f, 0.5f, 0.5f}, 0.4f), white = color(k, "pillow", {0.74f, 0.73f, 0.7f}, 0.9f);
    for (const float sx : {-1.f, 1.f}) {
        playroom_wheel(k, dark, hub, {sx * 0.26f, 0.15f, -0.3f}, 0.15f, 0.022f),
            playroom_wheel(k, dark, hub, {sx * 0.24f, 0.11f, 0.38f}, 0.11f, 0.02f);
        k.rod(metal, {sx * 0.23f, 0.11f, 0.38f}, {sx * 0.22f, 1.02f, -0.55f}, 0.014f, -1, 8),
            k.rod(metal, {sx * 0.23f, 0.15f, -0.3f}, {sx * 0.22f, 0.62f, 0.12f}, 0.014f, -1, 8);
    }
    k.rod(dark, {-0.22f, 1.02f, -0.55f}, {0.22f, 1.02f, -0.55f}, 0.019f, -1, 10),
        k.rod(metal, {-0.25f, 0.15f, -0.3f}, {0.25f, 0.15f, -0.3f}, 0.01f, -1, 8);
    // The cot: rounded ends, open above, its hood over the head.
    const auto hull = shapes::rounded_rectangle(0.42f, 0.82f, 0.19f, 5);
    k.add(shapes::prism(hull, 0.56f, 0.8f, 0.03f), cloth, {0, 0, 0.02f}),
        k.add(shapes::prism(shapes::rounded_rectangle(0.36f, 0.74f, 0.16f, 5), 0.8f, 0.815f, 0.006f), white,
              {0, 0, 0.02f});
    k.soft(white, {0, 0.8f, -0.2f}, {0.26f, 0.06f, 0.2f}, {0.025f, 0.01f, 0.001f, 5}),
        k.soft(cloth, {0, 0.795f, 0.2f}, {0.38f, 0.06f, 0.44f}, {0.025f, 0.012f, 0.001f, 6});
    k.add(shapes::slab(14, 8, 0.012f,
                       [](float u, float v) {
                           const float a = kPi * u, b = 0.5f * kPi * v + 0.02f, r = 0.225f;
                           return Vec3f{r * std::cos(a), 0.79f + 0.34f * std::sin(a) * std::cos(0.55f * b),
                                        -0.03f - 0.37f * std::sin(b) * (0.55f + 0.45f * std::sin(a))};
                       }),
          cloth);
    k.board(dark, {0, 0.2f, 0.02f}, {0.38f, 0.12f, 0.44f}, 0.03f);
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture
