// What one cooks and bakes on: ranges, stoves, fryers, griddles, ovens, and the small machines of kitchens.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/profiles.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

void cooker_knob(Kit& k, int material, Vec3f at, float radius = 0.018f) {
    k.rod(material, at, at + Vec3f{0, 0, 0.025f}, radius, 0.85f * radius, 12);
}

void cooker_bar(Kit& k, int metal, Vec3f at, float width) {  // a handle across a door
    k.rod(metal, at + Vec3f{-0.5f * width, 0, 0.035f}, at + Vec3f{0.5f * width, 0, 0.035f}, 0.009f, -1, 8);
    for (const float s : {-1.f, 1.f})
        k.rod(metal, at + Vec3f{s * 0.42f * width, 0, 0}, at + Vec3f{s * 0.42f * width, 0, 0.035f}, 0.007f, -1, 6);
}

}  // namespace

// A freestanding range: four burners, an oven with a window, a low splashback.
void build_stove(Kit& k) {
    const Vec3f s = k.wanted({0.75f, 0.91f, 0.64f});
    const int body = k.main(k.rng.chance(0.5f) ? steel() : plain("enamel", {0.72f, 0.71f, 0.67f}, 0.2f)),
              metal = k.material(steel()), dark = color(k, "black enamel", {0.018f, 0.018f, 0.019f}, 0.15f),
              iron = color(k, "cast iron", {0.03f, 0.03f, 0.031f}, 0.7f),
              pane = color(k, "oven window", {0.02f, 0.017f, 0.015f}, 0.05f);
    const float z = 0.5f * s.z - 0.03f, top = s.y;
    block(k, dark, {0, 0, -0.02f}, {s.x - 0.04f, 0.09f, s.z - 0.1f});
    k.board(body, {0, 0.08f, -0.015f}, {s.x, top - 0.11f, s.z - 0.03f}, 0.006f),
        k.board(dark, {0, top - 0.03f, -0.01f}, {s.x, 0.03f, s.z - 0.02f}, 0.006f);
    k.board(body, {0, 0.1f, z}, {s.x - 0.02f, 0.14f, 0.025f}, 0.006f),
        k.board(body, {0, 0.26f, z}, {s.x - 0.02f, top - 0.42f, 0.03f}, 0.008f),
        k.board(pane, {0, 0.34f, z + 0.008f}, {0.66f * s.x, top - 0.63f, 0.018f}, 0.004f);
    cooker_bar(k, metal, {0, top - 0.22f, z + 0.015f}, 0.86f * s.x),
        cooker_bar(k, metal, {0, 0.2f, z + 0.012f}, 0.5f * s.x);
    k.board(dark, {0, top - 0.13f, z}, {s.x - 0.004f, 0.095f, 0.03f}, 0.006f);
    for (int i = 0; i < 5; ++i)
        cooker_knob(k, metal, {s.x * (static_cast<float>(i) - 2.f) / 5.6f, top - 0.083f, z + 0.015f}, 0.022f);
    k.board(body, {0, top, -0.5f * s.z + 0.02f}, {s.x, 0.09f, 0.04f}, 0.006f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) {
            const Vec3f at{sx * 0.23f * s.x, top, sz * 0.21f * s.z + 0.01f};
            k.rod(iron, at, at + Vec3f{0, 0.016f, 0}, 0.05f, 0.042f, 16);
            for (int i = 0; i < 4; ++i) {
                const Vec3f d = around(kTau * (static_cast<float>(i) + 0.5f) / 4.f);
                k.rod(iron, at + d * 0.045f + Vec3f{0, 0.026f, 0}, at + d * 0.14f + Vec3f{0, 0.026f, 0}, 0.006f, -1, 5),
                    k.rod(iron, at + d * 0.138f, at + d * 0.138f + Vec3f{0, 0.026f, 0}, 0.006f, -1, 5);
            }
        }
    k.top(top + 0.032f, 0, 0, 0.3f * s.x, 0.28f * s.z);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.8f;
}

// Of cast iron, on feet, with a fire behind glass and a pipe.
void build_iron_stove(Kit& k) {
    const int iron = k.main(plain("cast iron", {0.022f, 0.022f, 0.023f}, 0.6f)),
              brass = k.material(*material_named("brass")), fire = k.material(flame("fire", {14, 5.5f, 1.2f})),
              coal = color(k, "embers", {0.02f, 0.012f, 0.01f}, 0.9f),
              log = color(k, "log", {0.1f, 0.05f, 0.02f}, 0.9f);
    const float w = 0.56f, d = 0.44f, y0 = 0.16f, h = 0.52f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(iron, {sx * 0.24f, 0, sz * 0.18f}, {sx * 0.21f, y0, sz * 0.15f}, 0.018f, 0.035f, 8);
    k.board(iron, {0, y0 - 0.02f, 0}, {w + 0.06f, 0.035f, d + 0.06f}, 0.012f),
        k.board(iron, {0, y0, -0.02f}, {w, h, d - 0.04f}, 0.012f),
        k.board(iron, {0, y0 + h, 0}, {w + 0.08f, 0.04f, d + 0.08f}, 0.014f);
    const float z = 0.5f * d - 0.04f;
    const auto frame = arch(0.2f, 0.2f), pane = arch(0.155f, 0.17f);
    k.add(front_prism(frame, z, z + 0.03f, 0.006f), iron, {0, y0 + 0.06f, 0});
    k.add(front_prism(pane, z + 0.022f, z + 0.034f, 0.002f), coal, {0, y0 + 0.09f, 0});
    for (int i = 0; i < 6; ++i) {
        const float x = -0.1f + 0.04f * static_cast<float>(i), t = k.rng.uniform(0.07f, 0.16f);
        k.add(shapes::ball({x, y0 + 0.12f + 0.5f * t, z + 0.035f}, {0.022f, 0.5f * t, 0.004f}, 8), fire);
    }
    k.rod(log, {-0.13f, y0 + 0.11f, z + 0.034f}, {0.13f, y0 + 0.125f, z + 0.034f}, 0.022f, -1, 8);
    for (const float x : {-0.05f, 0.05f}) block(k, iron, {x, y0 + 0.09f, z + 0.036f}, {0.01f, 0.3f, 0.01f});
    k.rod(brass, {0.225f, y0 + 0.24f, z + 0.03f}, {0.225f, y0 + 0.24f, z + 0.075f}, 0.012f, 0.018f, 10);
    for (const float s : {-1.f, 1.f})
        k.board(iron, {s * (0.5f * w + 0.004f), y0 + 0.08f, -0.02f}, {0.012f, h - 0.16f, d - 0.16f}, 0.004f);
    k.rod(iron, {0, y0 + h + 0.03f, -0.08f}, {0, 2.15f, -0.08f}, 0.065f, -1, 18);
    for (const float y : {y0 + h + 0.05f, 1.45f}) k.rod(iron, {0, y, -0.08f}, {0, y + 0.035f, -0.08f}, 0.076f, -1, 18);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.7f;
}

void build_microwave(Kit& k) {
    const int body = k.main(k.rng.chance(0.5f) ? steel() : plain("enamel", {0.04f, 0.04f, 0.042f}, 0.3f)),
              pane = color(k, "oven window", {0.015f, 0.015f, 0.016f}, 0.06f),
              dark = color(k, "panel", {0.03f, 0.03f, 0.032f}, 0.3f),
              key = color(k, "key", {0.35f, 0.35f, 0.35f}, 0.5f), clock = lit(k, "clock", {0.1f, 1.1f, 0.6f}),
              metal = k.material(steel());
    k.board(body, {0, 0.012f, -0.01f}, {0.5f, 0.28f, 0.34f}, 0.01f),
        k.board(dark, {0, 0.014f, 0.165f}, {0.496f, 0.276f, 0.018f}, 0.006f);
    k.board(pane, {-0.075f, 0.045f, 0.172f}, {0.3f, 0.21f, 0.008f}, 0.003f),
        block(k, clock, {0.185f, 0.235f, 0.174f}, {0.09f, 0.026f, 0.004f});
    k.rod(metal, {0.103f, 0.06f, 0.2f}, {0.103f, 0.24f, 0.2f}, 0.008f, -1, 8);
    for (const float y : {0.07f, 0.23f}) k.rod(metal, {0.103f, y, 0.17f}, {0.103f, y, 0.2f}, 0.006f, -1, 6);
    for (int i = 0; i < 9; ++i)
        block(k, key, {0.152f + 0.033f * static_cast<float>(i % 3), 0.11f + 0.034f * static_cast<float>(i / 3), 0.174f},
              {0.024f, 0.02f, 0.004f});
    block(k, metal, {0.185f, 0.05f, 0.175f}, {0.09f, 0.035f, 0.008f});
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) block(k, dark, {sx * 0.21f, 0, sz * 0.13f}, {0.03f, 0.014f, 0.03f});
    k.top(0.292f, 0, 0, 0.2f, 0.13f);
    on_surface(k);
}

// A base with a dial, a jug of glass with something in it.
void build_blender(Kit& k) {
    const int base = k.main(k.rng.chance(0.5f) ? steel() : plain("enamel", k.accent(), 0.25f)),
              dark = color(k, "black plastic", {0.03f, 0.03f, 0.032f}, 0.4f),
              jug = color(k, "jug", {0.45f, 0.48f, 0.47f}, 0.06f),
              mix = color(k, "smoothie", k.rng.chance(0.5f) ? Vec3f{0.45f, 0.1f, 0.16f} : Vec3f{0.3f, 0.38f, 0.1f},
                          0.15f),
              metal = k.material(steel());
    const std::array<Vec2f, 5> b{Vec2f{0.09f, 0}, {0.092f, 0.012f}, {0.08f, 0.08f}, {0.062f, 0.13f}, {0.058f, 0.14f}},
        full{Vec2f{0.05f, 0.14f}, {0.053f, 0.16f}, {0.066f, 0.27f}},
        air{Vec2f{0.066f, 0.27f}, {0.07f, 0.31f}, {0.078f, 0.36f}},
        lid{Vec2f{0.08f, 0.36f}, {0.08f, 0.378f}, {0.05f, 0.384f}},
        cap{Vec2f{0.028f, 0.384f}, {0.026f, 0.405f}, {0, 0.407f}};
    k.add(shapes::lathe(b, 24), base), k.add(shapes::lathe(full, 20), mix), k.add(shapes::lathe(air, 20), jug),
        k.add(shapes::lathe(lid, 20), dark), k.add(shapes::lathe(cap, 14), dark);
    const std::array<Vec3f, 4> handle{
        Vec3f{0.068f, 0.34f, 0}, {0.12f, 0.33f, 0}, {0.118f, 0.22f, 0}, {0.06f, 0.19f, 0}};
    k.add(shapes::tube(handle, 0.011f, 8), dark);
    cooker_knob(k, metal, {0, 0.06f, 0.078f}, 0.022f);
    on_surface(k);
}

// Two vats of oil with baskets, on a cabinet.
void build_deep_fryer(Kit& k) {
    const Vec3f s = k.wanted({0.6f, 0.9f, 0.75f});
    const int body = k.main(steel()), oil = color(k, "frying oil", {0.3f, 0.17f, 0.02f}, 0.04f),
              dark = color(k, "black plastic", {0.03f, 0.03f, 0.032f}, 0.5f),
              chips = color(k, "chips", {0.6f, 0.38f, 0.08f}, 0.6f), rail = k.material(steel()),
              red = color(k, "lamp", {0.6f, 0.03f, 0.02f}, 0.2f);
    k.board(body, {0, 0.1f, 0}, {s.x, s.y - 0.18f, s.z - 0.04f}, 0.006f),
        block(k, dark, {0, 0, -0.02f}, {s.x - 0.06f, 0.1f, s.z - 0.14f});
    k.board(body, {0, s.y - 0.08f, 0.5f * s.z - 0.06f}, {s.x, 0.08f, 0.12f}, 0.006f),
        k.board(body, {0, s.y - 0.08f, -0.5f * s.z + 0.06f}, {s.x, 0.3f, 0.08f}, 0.006f);
    for (const float x : {-0.5f * s.x + 0.02f, 0.f, 0.5f * s.x - 0.02f})
        k.board(body, {x, s.y - 0.08f, 0}, {0.04f, 0.08f, s.z - 0.1f}, 0.004f);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.25f * s.x, up = sx > 0 ? 0.13f : 0.01f;
        block(k, oil, {x, s.y - 0.08f, 0}, {0.5f * s.x - 0.04f, 0.045f, s.z - 0.16f});
        const float y = s.y - 0.06f + up, w = 0.5f * s.x - 0.09f, d = s.z - 0.3f, zc = sx > 0 ? -0.03f : 0.02f;
        for (int i = 0; i <= 6; ++i) {
            const float z = zc + d * (static_cast<float>(i) / 6 - 0.5f);
            for (const float e : {-1.f, 1.f})
                wire(k, rail, {x + e * 0.5f * w, y, z}, {x + e * 0.5f * w, y + 0.1f, z}, 0.002f);
        }
        for (const float e : {-1.f, 1.f})
            wire(k, rail, {x + e * 0.5f * w, y + 0.1f, zc - 0.5f * d}, {x + e * 0.5f * w, y + 0.1f, zc + 0.5f * d},
                 0.004f),
                wire(k, rail, {x - 0.5f * w, y + 0.1f, zc + e * 0.5f * d}, {x + 0.5f * w, y + 0.1f, zc + e * 0.5f * d},
                     0.004f);
        block(k, chips, {x, y + 0.002f, zc}, {w - 0.02f, 0.05f, d - 0.02f});
        for (int i = 0; i < 16; ++i) {
            const std::array<Vec3f, 2> stick{Vec3f{0, 0, -0.04f}, {0, 0, 0.04f}};
            Mesh chip = shapes::tube(stick, 0.007f, 4);
            shapes::turn(chip, {1, 0, 0}, k.rng.uniform(-25, 25)), shapes::turn(chip, {0, 1, 0}, k.rng.uniform(0, 180));
            k.add(std::move(chip), chips,
                  {x + k.rng.uniform(-0.3f, 0.3f) * w, y + 0.06f, zc + k.rng.uniform(-0.36f, 0.36f) * d});
        }
        k.rod(dark, {x, y + 0.1f, zc + 0.5f * d}, {x, y + 0.19f, 0.5f * s.z + 0.05f}, 0.012f, -1, 8);
        k.board(body, {x, 0.16f, 0.5f * s.z - 0.02f}, {0.5f * s.x - 0.02f, s.y - 0.36f, 0.02f}, 0.005f),
            cooker_bar(k, rail, {x, s.y - 0.26f, 0.5f * s.z - 0.01f}, 0.16f);
        cooker_knob(k, dark, {x, s.y - 0.13f, 0.5f * s.z - 0.022f}, 0.024f),
            block(k, red, {x + 0.07f, s.y - 0.137f, 0.5f * s.z - 0.018f}, {0.014f, 0.014f, 0.006f});
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.8f;
}

// A plate of steel half smooth, half ribbed, with a rim, over a cabinet; burgers fry on it.
void build_griddle(Kit& k) {
    const Vec3f s = k.wanted({0.9f, 0.92f, 0.75f});
    const int body = k.main(steel()), plate = color(k, "griddle plate", {0.07f, 0.068f, 0.065f}, 0.3f),
              dark = color(k, "black plastic", {0.03f, 0.03f, 0.032f}, 0.5f),
              meat = color(k, "patty", {0.11f, 0.045f, 0.02f}, 0.6f), metal = k.material(steel());
    block(k, dark, {0, 0, -0.02f}, {s.x - 0.06f, 0.1f, s.z - 0.14f});
    k.board(body, {0, 0.1f, 0}, {s.x, s.y - 0.16f, s.z - 0.04f}, 0.006f),
        k.board(plate, {0, s.y - 0.06f, 0.01f}, {s.x - 0.04f, 0.02f, s.z - 0.1f}, 0.003f);
    k.board(body, {0, s.y - 0.06f, -0.5f * s.z + 0.03f}, {s.x, 0.16f, 0.025f}, 0.004f);
    for (const float sx : {-1.f, 1.f})
        k.board(body, {sx * (0.5f * s.x - 0.012f), s.y - 0.06f, -0.06f}, {0.024f, 0.12f, s.z - 0.2f}, 0.004f),
            k.board(body, {sx * 0.25f * s.x, 0.16f, 0.5f * s.z - 0.02f}, {0.5f * s.x - 0.03f, s.y - 0.42f, 0.02f},
                    0.005f),
            cooker_bar(k, metal, {sx * 0.25f * s.x, s.y - 0.32f, 0.5f * s.z - 0.01f}, 0.2f);
    for (int i = 0; i < 11; ++i)
        block(k, plate, {0.05f + (0.5f * s.x - 0.1f) * static_cast<float>(i) / 10, s.y - 0.04f, 0.01f},
              {0.012f, 0.01f, s.z - 0.14f});
    for (int i = 0; i < 4; ++i)
        k.rod(meat,
              {-0.32f + 0.14f * static_cast<float>(i % 2), s.y - 0.04f, -0.1f + 0.16f * static_cast<float>(i / 2)},
              {-0.32f + 0.14f * static_cast<float>(i % 2), s.y - 0.022f, -0.1f + 0.16f * static_cast<float>(i / 2)},
              0.052f, -1, 14);
    for (int i = 0; i < 3; ++i)
        cooker_knob(k, dark, {0.26f * (static_cast<float>(i) - 1.f), s.y - 0.13f, 0.5f * s.z - 0.02f}, 0.026f);
    Mesh blade = shapes::box({0.08f, 0.003f, 0.1f}, 0.001f);
    k.add(std::move(blade), metal, {-0.1f, s.y - 0.036f, 0.2f}),
        k.rod(dark, {-0.1f, s.y - 0.03f, 0.24f}, {-0.1f, s.y + 0.02f, 0.42f}, 0.011f, -1, 8);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.8f;
}

// A vault of bricks on a plinth, fire in its mouth, a pizza before it.
void build_pizza_oven(Kit& k) {
    const Material brick = material_named("brick").value_or(plain("brick", {0.32f, 0.12f, 0.07f}, 0.85f));
    const int wall = k.main(brick), stone = color(k, "stone slab", {0.3f, 0.28f, 0.25f}, 0.7f),
              soot = color(k, "soot", {0.008f, 0.007f, 0.006f}, 0.95f), fire = k.material(flame("fire", {16, 6, 1.2f})),
              log = color(k, "log", {0.09f, 0.045f, 0.02f}, 0.9f), dough = color(k, "crust", {0.5f, 0.3f, 0.12f}, 0.8f),
              sauce = color(k, "tomato sauce", {0.42f, 0.06f, 0.02f}, 0.5f),
              cheese = color(k, "cheese", {0.66f, 0.52f, 0.24f}, 0.5f), wood = k.material(k.style.wood);
    const float w = 1.5f, d = 1.3f, y = 0.95f;
    k.board(wall, {0, 0, -0.05f}, {w - 0.1f, y - 0.06f, d - 0.15f}, 0.01f),
        k.board(stone, {0, y - 0.06f, 0}, {w, 0.06f, d}, 0.012f);
    const auto store = arch(0.36f, 0.24f);
    k.add(front_prism(store, 0.5f * d - 0.13f, 0.5f * d - 0.12f, 0.001f), soot, {0, 0.06f, 0});
    for (int i = 0; i < 9; ++i)
        k.rod(log,
              {-0.27f + 0.135f * static_cast<float>(i % 5) + (i > 4 ? 0.07f : 0), 0.13f + (i > 4 ? 0.12f : 0), 0.45f},
              {-0.27f + 0.135f * static_cast<float>(i % 5) + (i > 4 ? 0.07f : 0), 0.13f + (i > 4 ? 0.12f : 0), 0.57f},
              0.062f, -1, 9);
    std::vector<Vec2f> dome;
    for (int i = 0; i <= 8; ++i)
        dome.push_back({0.66f * std::cos(0.5f * kPi * static_cast<float>(i) / 8.f),
                        y + 0.62f * std::sin(0.5f * kPi * static_cast<float>(i) / 8.f)});
    dome.back().x = 0;
    k.add(shapes::lathe(dome, 36, true), wall, {0, 0, -0.08f});
    const auto mouth = arch(0.36f, 0.12f, 16), hole = arch(0.27f, 0.09f, 16);
    k.add(front_prism(mouth, 0.3f, 0.56f, 0.012f), wall, {0, y, 0}),
        k.add(front_prism(hole, 0.5f, 0.565f, 0.001f), soot, {0, y + 0.002f, 0});
    for (int i = 0; i < 13; ++i) {  // the stones of the arch
        const float a = kPi * (static_cast<float>(i) + 0.5f) / 13.f;
        Mesh v = shapes::box({0.075f, 0.095f, 0.03f}, 0.004f);
        shapes::turn(v, {0, 0, 1}, a * 180.f / kPi - 90.f);
        k.add(std::move(v), wall, {0.32f * std::cos(a), y + 0.1f + 0.32f * std::sin(a), 0.568f});
    }
    k.rod(log, {-0.18f, y + 0.03f, 0.572f}, {0.05f, y + 0.04f, 0.572f}, 0.025f, -1, 8);
    for (int i = 0; i < 7; ++i) {
        const float t = k.rng.uniform(0.08f, 0.2f);
        k.add(shapes::ball({-0.19f + 0.04f * static_cast<float>(i), y + 0.04f + 0.5f * t, 0.568f},
                           {0.026f, 0.5f * t, 0.005f}, 8),
              fire);
    }
    k.rod(wall, {0, y + 0.5f, -0.1f}, {0, 2.1f, -0.1f}, 0.12f, -1, 20);
    const Vec3f at{0.42f, y, 0.45f};
    k.rod(wood, at, at + Vec3f{0, 0.014f, 0}, 0.17f, -1, 24),
        k.rod(dough, at + Vec3f{0, 0.014f, 0}, at + Vec3f{0, 0.03f, 0}, 0.15f, -1, 24),
        k.rod(sauce, at + Vec3f{0, 0.028f, 0}, at + Vec3f{0, 0.033f, 0}, 0.13f, -1, 24);
    for (int i = 0; i < 7; ++i)
        k.rod(
            cheese,
            at + around(1.3f * static_cast<float>(i)) * (0.028f + 0.011f * static_cast<float>(i)) + Vec3f{0, 0.03f, 0},
            at + around(1.3f * static_cast<float>(i)) * (0.028f + 0.011f * static_cast<float>(i)) + Vec3f{0, 0.037f, 0},
            0.024f, -1, 9);
    k.piece.against_wall = true, k.piece.clearance_front_m = 1.0f;
}

// A wheel of steel with a guard, a carriage, and a ham on it.
void build_food_slicer(Kit& k) {
    const int body = k.main(plain("enamel", {0.4f, 0.03f, 0.025f}, 0.25f)), metal = k.material(steel()),
              dark = color(k, "black plastic", {0.03f, 0.03f, 0.032f}, 0.5f),
              ham = color(k, "ham", {0.52f, 0.2f, 0.17f}, 0.5f);
    k.board(body, {0, 0.02f, 0}, {0.46f, 0.09f, 0.34f}, 0.03f);
    for (const float sx : {-1.f, 1.f})
        k.rod(dark, {sx * 0.17f, 0, 0.1f}, {sx * 0.17f, 0.03f, 0.1f}, 0.02f, -1, 8),
            k.rod(dark, {sx * 0.17f, 0, -0.1f}, {sx * 0.17f, 0.03f, -0.1f}, 0.02f, -1, 8);
    k.board(body, {-0.05f, 0.1f, -0.1f}, {0.22f, 0.12f, 0.1f}, 0.03f);
    k.rod(metal, {0, 0.24f, -0.05f}, {0, 0.24f, -0.04f}, 0.15f, 0.147f, 32),
        k.rod(body, {0, 0.24f, -0.04f}, {0, 0.24f, -0.02f}, 0.085f, 0.07f, 24),
        k.rod(metal, {0, 0.24f, -0.03f}, {0, 0.24f, -0.01f}, 0.02f, -1, 12);
    k.add(front_ring(0.152f, 0.018f, 30), body, {0, 0.24f, -0.055f});
    k.board(metal, {0.14f, 0.12f, 0.06f}, {0.2f, 0.012f, 0.2f}, 0.004f),
        k.board(metal, {0.23f, 0.13f, 0.06f}, {0.012f, 0.12f, 0.2f}, 0.004f);
    k.rod(ham, {0.15f, 0.19f, -0.01f}, {0.15f, 0.19f, 0.15f}, 0.055f, -1, 16);
    k.rod(dark, {0.23f, 0.25f, 0.14f}, {0.23f, 0.31f, 0.14f}, 0.014f, 0.018f, 10),
        cooker_knob(k, dark, {-0.18f, 0.065f, 0.165f}, 0.026f);
    on_surface(k);
}

// A pan over a dial.
void build_kitchen_scale(Kit& k) {
    const int body = k.main(plain("enamel", k.rng.chance(0.5f) ? Vec3f{0.6f, 0.56f, 0.46f} : k.accent(), 0.3f)),
              face = color(k, "dial", {0.75f, 0.74f, 0.7f}, 0.4f), red = color(k, "needle", {0.5f, 0.03f, 0.02f}, 0.4f),
              metal = k.material(steel()), dark = color(k, "marks", {0.03f, 0.03f, 0.03f}, 0.6f);
    const std::array<Vec2f, 4> side{Vec2f{-0.09f, 0}, {0.09f, 0}, {0.06f, 0.2f}, {-0.06f, 0.2f}};
    k.add(side_prism(side, -0.1f, 0.1f, 0.015f), body);
    Mesh dial = shapes::prism(shapes::circle(0.078f, 28), 0, 0.008f, 0.002f), rim = shapes::ring(0.08f, 0.01f, 28);
    for (Mesh* m : {&dial, &rim}) shapes::turn(*m, {1, 0, 0}, 90.f - 8.5f);
    k.add(std::move(dial), face, {0, 0.1f, 0.074f}), k.add(std::move(rim), metal, {0, 0.1f, 0.079f});
    for (int i = 0; i < 12; ++i) {
        const float a = kTau * static_cast<float>(i) / 12.f;
        block(k, dark, {0.062f * std::sin(a), 0.1f + 0.062f * std::cos(a) - 0.004f, 0.081f - 0.0093f * std::cos(a)},
              {0.006f, 0.008f, 0.004f});
    }
    slat(k, red, {0, 0.09f, 0.086f}, {0.032f, 0.145f, 0.08f}, 0.006f, 0.003f);
    k.rod(metal, {0, 0.19f, 0}, {0, 0.235f, 0}, 0.022f, -1, 10);
    const std::array<Vec2f, 4> pan{Vec2f{0.06f, 0.235f}, {0.1f, 0.245f}, {0.13f, 0.27f}, {0.135f, 0.278f}};
    k.add(shapes::vessel(pan, 0.003f, 26), metal);
    on_surface(k);
}

// For espresso: two groups over a tray, cups that warm on top.
void build_coffee_machine(Kit& k) {
    const int body = k.main(k.rng.chance(0.6f) ? steel() : plain("enamel", k.accent(), 0.25f)),
              metal = k.material(steel()), dark = color(k, "black plastic", {0.025f, 0.025f, 0.027f}, 0.4f),
              cup = k.material(porcelain()), face = color(k, "gauge", {0.7f, 0.7f, 0.66f}, 0.3f);
    const float w = 0.5f;
    k.board(metal, {0, 0.02f, 0}, {w, 0.06f, 0.4f}, 0.01f),
        k.board(dark, {0, 0.078f, 0.06f}, {w - 0.06f, 0.006f, 0.24f}, 0.002f),
        k.board(body, {0, 0.07f, -0.12f}, {w, 0.3f, 0.16f}, 0.014f),
        k.board(body, {0, 0.27f, 0.02f}, {w, 0.14f, 0.34f}, 0.03f);
    for (const float sx : {-1.f, 1.f})
        for (const float z : {-0.15f, 0.15f}) k.rod(dark, {sx * 0.21f, 0, z}, {sx * 0.21f, 0.025f, z}, 0.018f, -1, 8);
    for (const float x : {-0.11f, 0.11f}) {
        k.rod(metal, {x, 0.22f, 0.11f}, {x, 0.275f, 0.11f}, 0.04f, -1, 16),
            k.rod(metal, {x, 0.19f, 0.11f}, {x, 0.222f, 0.11f}, 0.03f, 0.036f, 16),
            k.rod(dark, {x, 0.208f, 0.14f}, {x, 0.19f, 0.27f}, 0.011f, 0.016f, 10);
        const std::array<Vec2f, 3> p{Vec2f{0.02f, 0}, {0.032f, 0.02f}, {0.035f, 0.05f}};
        k.add(shapes::vessel(p, 0.004f, 14), cup, {x, 0.084f, 0.11f});
    }
    for (const float x : {-0.225f, 0.225f})
        k.rod(metal, {x, 0.28f, 0.16f}, {x * 1.04f, 0.12f, 0.2f}, 0.006f, -1, 6),
            k.rod(dark, {x, 0.34f, 0.18f}, {x, 0.34f, 0.22f}, 0.022f, -1, 12);
    k.rod(metal, {0, 0.34f, 0.185f}, {0, 0.34f, 0.2f}, 0.034f, -1, 18),
        k.rod(face, {0, 0.34f, 0.19f}, {0, 0.34f, 0.203f}, 0.029f, -1, 18),
        k.board(dark, {0, 0.338f, 0.203f}, {0.004f, 0.024f, 0.002f}, 0.0005f);
    for (int i = 0; i < 8; ++i) {
        const std::array<Vec2f, 3> p{Vec2f{0.02f, 0}, {0.032f, 0.02f}, {0.035f, 0.05f}};
        k.add(shapes::vessel(p, 0.004f, 10), cup,
              {-0.17f + 0.11f * static_cast<float>(i % 4), 0.412f, -0.04f + 0.1f * static_cast<float>(i / 4)});
    }
    for (const float z : {-0.13f, 0.17f}) k.rod(metal, {-0.24f, 0.45f, z}, {0.24f, 0.45f, z}, 0.005f, -1, 6);
    on_surface(k);
}

// A dish of steel with a rolled lid over a burner.
void build_chafing_dish(Kit& k) {
    const int metal = k.main(steel()), brass = k.material(*material_named("brass")),
              fire = k.material(flame("flame", {6, 4, 8}));
    const float w = 0.56f, d = 0.36f, y = 0.2f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(metal, {sx * 0.25f, 0, sz * 0.15f}, {sx * 0.25f, y + 0.03f, sz * 0.15f}, 0.009f, -1, 8);
    for (const float sz : {-1.f, 1.f})
        k.rod(metal, {-0.25f, 0.05f, sz * 0.15f}, {0.25f, 0.05f, sz * 0.15f}, 0.006f, -1, 6);
    k.board(metal, {0, 0.045f, 0}, {0.5f, 0.008f, 0.1f}, 0.002f);
    for (const float x : {-0.12f, 0.12f})
        k.rod(brass, {x, 0.05f, 0}, {x, 0.105f, 0}, 0.04f, -1, 14),
            k.add(shapes::ball({x, 0.125f, 0}, {0.014f, 0.024f, 0.014f}, 8), fire);
    k.board(metal, {0, y, 0}, {w - 0.04f, 0.07f, d - 0.04f}, 0.012f),
        k.board(metal, {0, y + 0.062f, 0}, {w, 0.016f, d}, 0.006f);
    std::vector<Vec2f> lid;
    for (int i = 0; i <= 12; ++i) {
        const float a = kPi * static_cast<float>(i) / 12.f;
        lid.push_back({0.165f * std::cos(a), y + 0.078f + 0.15f * std::sin(a)});
    }
    k.add(side_prism(lid, -0.26f, 0.26f, 0.012f), metal);
    const std::array<Vec3f, 4> handle{Vec3f{-0.09f, y + 0.19f, 0.12f},
                                      {-0.08f, y + 0.2f, 0.19f},
                                      {0.08f, y + 0.2f, 0.19f},
                                      {0.09f, y + 0.19f, 0.12f}};
    k.add(shapes::tube(handle, 0.009f, 8), brass);
    on_surface(k);
}

// Bells of copper on cords that keep dishes warm.
void build_heat_lamp(Kit& k) {
    const int shade = k.main(*material_named("copper")), cord = color(k, "cord", {0.02f, 0.02f, 0.02f}, 0.6f),
              bulb = k.material(glow("heat bulb", {9, 4.2f, 1.4f})), metal = k.material(steel());
    k.board(metal, {0, -0.04f, 0}, {1.3f, 0.04f, 0.1f}, 0.006f);
    for (int i = 0; i < 4; ++i) {
        const Vec3f at{-0.48f + 0.32f * static_cast<float>(i), -0.98f, 0};
        const std::array<Vec2f, 5> p{
            Vec2f{0.12f, 0}, {0.118f, 0.03f}, {0.085f, 0.11f}, {0.035f, 0.16f}, {0.03f, 0.22f}};
        k.add(shapes::shade(p, 20), shade, at),
            k.add(shapes::ball(at + Vec3f{0, 0.05f, 0}, {0.05f, 0.06f, 0.05f}, 12), bulb);
        std::vector<Vec3f> coil;
        for (int c = 0; c <= 36; ++c)
            coil.push_back(at + around(1.05f * static_cast<float>(c)) * 0.018f +
                           Vec3f{0, 0.24f + 0.0036f * static_cast<float>(c), 0});
        k.add(shapes::tube(coil, 0.004f, 4), cord);
        k.rod(cord, at + Vec3f{0, 0.2f, 0}, at + Vec3f{0, 0.95f, 0}, 0.006f, -1, 6);
    }
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
