// What stands in huts, caves and tents: fires and stoves, beds of snow and furs, trunks of trees.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

Material bark(Vec3f a) {
    Material m = plain("bark", a, 0.95f);
    m.pattern = Pattern::bark, m.color_b = a * 0.45f, m.scale_m = 0.09f, m.bump_m = 0.004f;
    return m;
}

// Tongues of flame over a bed of embers of this radius, hotter below.
void fire(Kit& k, Vec3f at, float radius, float high) {
    const int tip = k.material(flame("flame", {5.2f, 2.0f, 0.36f})),
              root = k.material(flame("flame's root", {8.4f, 4.4f, 1.0f}));
    for (int i = 0; i < 9; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / 9) *
                          (i == 0 ? 0.f : k.rng.uniform(0.2f, 0.7f) * radius);
        const float h = high * (i == 0 ? 1.f : k.rng.uniform(0.45f, 0.85f)), w = 0.3f * radius;
        const std::array<Vec2f, 3> below{Vec2f{0.001f, 0}, {0.7f * w, 0.1f * h}, {w, 0.28f * h}};
        const std::array<Vec2f, 4> above{
            Vec2f{w, 0.28f * h}, {0.6f * w, 0.58f * h}, {0.22f * w, 0.82f * h}, {0.001f, h}};
        // Closed where they meet, since sheets would shine inwards, too.
        std::vector<Vec2f> lower = shapes::curve(below, 2), upper = shapes::curve(above, 2);
        lower.push_back({0.001f, 0.28f * h});
        upper.insert(upper.begin(), {0.001f, 0.28f * h});
        k.add(shapes::lathe(lower, 10, true), root, at + out);
        k.add(shapes::lathe(upper, 10, true), tip, at + out);
    }
}

// Loose hair on a flat form: a skin with its outline.
void fur(Kit& k, int material, Vec3f at, float w, float d, float thick) {
    Mesh m = shapes::soft_box({w, thick, d}, {0.02f, 0.012f, 0.01f, 18, k.seed()});
    for (Vec3f& p : m.positions) {
        const float edge = 0.06f * shapes::wobble(Vec3f{p.x * 7, 0, p.z * 7}, 5);
        p.x += p.x > 0 ? edge : -edge, p.z += p.z > 0 ? edge : -edge;
    }
    shapes::smooth_normals(m);
    k.add_soft(std::move(m), material, kHideCrease, at + Vec3f{0, thick / 2, 0});
}
Material pelt(Vec3f color) {
    Material m = plain("fur", color, 0.95f);
    m.pattern = Pattern::carpet, m.color_b = color * 0.6f, m.color_c = color * 1.2f, m.scale_m = 0.02f, m.sheen = 0.4f;
    return m;
}

}  // namespace

// Logs that burn in a ring of stones.
void build_campfire(Kit& k) {
    Material granite = *material_named("stone");
    const int stone = k.main(granite), wood = k.material(bark({0.2f, 0.12f, 0.07f})),
              ash = color(k, "ash", {0.06f, 0.055f, 0.05f}, 0.95f),
              ember = k.material(flame("embers", {2.6f, 0.7f, 0.1f}));
    constexpr int kStones = 13;
    for (int i = 0; i < kStones; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / kStones) * 0.5f;
        const float r = k.rng.uniform(0.09f, 0.14f);
        Mesh m = shapes::ball({0, 0, 0}, {r, 0.75f * r, 0.9f * r}, 12);
        for (Vec3f& p : m.positions) p = p * (1.f + 0.22f * shapes::wobble(p * 9.f + out * 3.f, 3));
        for (Vec3f& p : m.positions) p.y = std::max(p.y, -0.6f * r);
        shapes::smooth_normals(m);
        k.add(std::move(m), stone, out + Vec3f{0, 0.6f * r, 0});
    }
    k.add(shapes::prism(shapes::circle(0.42f, 24), 0, 0.02f, 0.004f), ash);
    k.add(shapes::ball({0, 0.03f, 0}, {0.22f, 0.05f, 0.22f}, 14), ember);
    for (int i = 0; i < 6; ++i) {
        const Vec3f out = around(kTau * (static_cast<float>(i) + 0.4f) / 6);
        k.rod(wood, out * 0.34f + Vec3f{0, 0.05f, 0}, out * 0.04f + Vec3f{0, 0.3f, 0}, 0.04f, 0.034f, 9);
    }
    fire(k, {0, 0.06f, 0}, 0.24f, 0.62f);
    k.piece.clearance_front_m = 0.5f;
}

// An iron stove with a pipe that goes up to the roof.
void build_yurt_stove(Kit& k) {
    const Vec3f s = k.wanted({0.62f, 2.2f, 0.5f});
    const int iron = k.main(*material_named("iron")), dark = color(k, "stove pipe", {0.05f, 0.05f, 0.052f}, 0.5f),
              brass = k.material(*material_named("brass")), ember = k.material(flame("stove fire", {9, 2.8f, 0.3f})),
              kettle = k.material(*material_named("copper"));
    for (const float x : {-0.22f, 0.22f})
        for (const float z : {-0.16f, 0.16f}) k.rod(iron, {x, 0, z}, {x, 0.2f, z}, 0.02f, 0.03f, 8);
    k.board(iron, {0, 0.18f, 0}, {s.x, 0.46f, s.z}, 0.05f);
    k.board(iron, {0, 0.64f, 0}, {s.x + 0.06f, 0.03f, s.z + 0.06f}, 0.012f);
    k.board(dark, {0, 0.27f, s.z / 2}, {0.32f, 0.26f, 0.02f}, 0.02f);
    k.board(ember, {0, 0.31f, s.z / 2 + 0.012f}, {0.22f, 0.12f, 0.004f}, 0.001f);
    for (const float y : {0.34f, 0.38f}) k.board(iron, {0, y, s.z / 2 + 0.014f}, {0.24f, 0.012f, 0.008f}, 0.002f);
    k.rod(brass, {0.12f, 0.46f, s.z / 2 + 0.01f}, {0.12f, 0.5f, s.z / 2 + 0.05f}, 0.012f, -1, 8);
    k.rod(dark, {0, 0.66f, -0.1f}, {0, s.y, -0.1f}, 0.06f, -1, 18);
    for (const float y : {0.7f, 1.3f, 1.9f}) k.rod(iron, {0, y, -0.1f}, {0, y + 0.03f, -0.1f}, 0.068f, -1, 18);
    const std::array<Vec2f, 6> pot{Vec2f{0.1f, 0}, {0.12f, 0.05f}, {0.09f, 0.13f},
                                   {0.03f, 0.15f}, {0.02f, 0.17f}, {0.001f, 0.18f}};
    k.add(shapes::lathe(pot, 18, true), kettle, {0.14f, 0.67f, 0.1f});
    k.piece.clearance_front_m = 0.6f;
}

// A bench of snow with skins on it, to sleep on.
void build_snow_bed(Kit& k) {
    const Vec3f s = k.wanted({2.0f, 0.62f, 1.25f});
    Material snow = plain("snow", {0.78f, 0.81f, 0.85f}, 0.9f);
    snow.bump_m = 0.004f, snow.pattern = Pattern::plaster, snow.scale_m = 0.15f;
    const int white = k.main(snow), brown = k.material(pelt({0.16f, 0.085f, 0.04f})),
              pale = k.material(pelt({0.5f, 0.42f, 0.32f})), grey = k.material(pelt({0.24f, 0.22f, 0.2f}));
    k.soft(white, {0, 0, 0}, {s.x, s.y - 0.2f, s.z}, {0.09f, 0.02f, 0.008f, 20});
    fur(k, pale, {0, s.y - 0.22f, 0.02f}, s.x - 0.14f, s.z - 0.12f, 0.05f);
    fur(k, brown, {-0.15f, s.y - 0.18f, 0.1f}, 1.2f, s.z - 0.3f, 0.06f);
    Mesh pillow = shapes::soft_box({0.5f, 0.14f, 0.7f}, {0.06f, 0.03f, 0.006f, 14, k.seed()});
    k.add_soft(std::move(pillow), grey, kPillowCrease, {0.5f * s.x - 0.4f, s.y - 0.08f, 0});
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

// Furs on a low bed of boughs.
void build_fur_bed(Kit& k) {
    const Vec3f s = k.wanted({2.0f, 0.4f, 1.3f});
    const int wood = k.main(bark({0.22f, 0.13f, 0.07f})), brown = k.material(pelt({0.16f, 0.085f, 0.04f})),
              pale = k.material(pelt({0.44f, 0.34f, 0.22f})), red = k.material(pelt({0.3f, 0.12f, 0.04f}));
    for (const float z : {-1.f, 1.f})
        k.rod(wood, {-s.x / 2, 0.09f, z * (s.z / 2 - 0.07f)}, {s.x / 2, 0.09f, z * (s.z / 2 - 0.07f)}, 0.08f, -1, 12);
    for (int i = 0; i < 9; ++i) {
        const float x = s.x * ((static_cast<float>(i) + 0.5f) / 9 - 0.5f);
        k.rod(wood, {x, 0.17f, -s.z / 2}, {x, 0.17f, s.z / 2}, 0.04f, -1, 8);
    }
    fur(k, pale, {0, 0.2f, 0}, s.x - 0.16f, s.z - 0.1f, 0.08f);
    fur(k, brown, {-0.2f, 0.27f, 0.08f}, 1.25f, s.z - 0.14f, 0.07f);
    Mesh roll = shapes::soft_box({0.3f, 0.2f, 0.8f}, {0.09f, 0.02f, 0.006f, 14, k.seed()});
    k.add_soft(std::move(roll), red, kPillowCrease, {s.x / 2 - 0.28f, 0.36f, 0});
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

// A living tree that grows through floor and roof, with its lowest boughs in the room.
void build_tree_trunk(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 2.66f, 1.5f});
    const int wood = k.main(bark({0.19f, 0.12f, 0.075f})), leaf = color(k, "leaf", {0.08f, 0.2f, 0.03f}, 0.6f);
    Mesh m = shapes::sheet(40, 30, [&](float u, float v) {
        const float a = kTau * (1 - u), y = s.y * v;
        const float r = 0.34f + 0.16f * std::exp(-y / 0.25f) + 0.08f * v * v + 0.03f * std::sin(5 * a + 1.5f * y) +
                        0.02f * std::sin(11 * a - 2 * y);
        return Vec3f{r * std::cos(a), y, r * std::sin(a)};
    });
    k.add(std::move(m), wood);
    for (int i = 0; i < 4; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / 4 + 0.6f);
        const float y = s.y - 0.75f - 0.12f * static_cast<float>(i % 2);
        const std::array<Vec3f, 4> bough{out * 0.3f + Vec3f{0, y, 0}, out * 0.5f + Vec3f{0, y + 0.22f, 0},
                                         out * 0.64f + Vec3f{0, y + 0.5f, 0}, out * 0.66f + Vec3f{0, s.y - 0.02f, 0}};
        k.add(shapes::tube(bough, 0.075f, 10), wood);
        for (int j = 0; j < 12; ++j) {
            const Vec3f at = out * k.rng.uniform(0.42f, 0.62f) + Vec3f{k.rng.uniform(-0.1f, 0.1f),
                                                                       y + k.rng.uniform(0.1f, 0.55f),
                                                                       k.rng.uniform(-0.1f, 0.1f)};
            k.add(shapes::ball(at, {0.05f, 0.012f, 0.03f}, 8), leaf);
        }
    }
    k.piece.clearance_front_m = 0.4f;
}

// A cut log to sit on.
void build_log_stool(Kit& k) {
    const Vec3f s = k.wanted({0.4f, 0.42f, 0.4f});
    const int side = k.main(bark({0.2f, 0.13f, 0.08f}));
    Material cut = plain("cut wood", {0.5f, 0.32f, 0.16f}, 0.8f);
    const int wood = k.material(cut), ring = color(k, "year ring", {0.36f, 0.21f, 0.1f}, 0.8f);
    const std::array<Vec2f, 4> p{
        Vec2f{0.5f * s.x, 0}, {0.47f * s.x, 0.12f}, {0.46f * s.x, s.y - 0.02f}, {0.45f * s.x, s.y - 0.01f}};
    k.add(shapes::lathe(p, 22), side);
    k.add(shapes::prism(shapes::circle(0.43f * s.x, 22), s.y - 0.015f, s.y, 0.003f), wood);
    for (const float r : {0.32f, 0.2f, 0.09f}) k.add(shapes::ring(r * s.x, 0.004f, 20), ring, {0, s.y - 0.001f, 0});
    k.top(s.y, 0, 0, 0.3f * s.x, 0.3f * s.z);
}

// Spikes of stone that grew from the floor.
void build_stalagmites(Kit& k) {
    const Vec3f s = k.wanted({0.9f, 1.3f, 0.8f});
    const int rock = k.main(k.style.wall);
    for (int i = 0; i < 7; ++i) {
        const float h = i == 0 ? s.y : s.y * k.rng.uniform(0.2f, 0.7f), r = 0.06f + 0.1f * h / s.y;
        const Vec3f at = i == 0 ? Vec3f{0, 0, 0}
                                : Vec3f{k.rng.uniform(-0.5f, 0.5f) * (s.x - 0.3f), 0,
                                        k.rng.uniform(-0.5f, 0.5f) * (s.z - 0.3f)};
        std::vector<Vec2f> p;
        for (int j = 0; j <= 10; ++j) {
            const float t = static_cast<float>(j) / 10;
            p.push_back({std::max(0.004f, r * (1 - t) * (1 - 0.3f * t) + 0.012f * std::sin(17 * t) * (1 - t)), h * t});
        }
        k.add(shapes::lathe(p, 14, true), rock, at);
    }
}

// Animals and hands in ochre and soot, painted on rock.
void build_cave_painting(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 1.0f, 0.012f});
    const int ochre = k.main(plain("ochre", {0.36f, 0.11f, 0.03f}, 0.95f)),
              soot = color(k, "soot", {0.03f, 0.022f, 0.018f}, 0.95f);
    const auto spot = [&](int material, Vec2f at, Vec2f half, float turn) {
        Mesh m = shapes::ball({0, 0, 0}, {half.x, half.y, 0.005f}, 14);
        shapes::turn(m, {0, 0, 1}, turn);
        k.add(std::move(m), material, {at.x, at.y, 0.006f});
    };
    const auto line = [&](int material, Vec2f a, Vec2f b, float wide) {
        k.rod(material, {a.x, a.y, 0.006f}, {b.x, b.y, 0.006f}, wide, 0.6f * wide, 6);
    };
    // Bison, with hump, horns and legs; a deer; people with bows.
    const auto bison = [&](Vec2f at, float size, int material) {
        spot(material, at, {0.3f * size, 0.15f * size}, 4);
        spot(material, at + Vec2f{0.14f, 0.07f} * size, {0.17f * size, 0.14f * size}, 0);
        spot(material, at + Vec2f{0.34f, -0.02f} * size, {0.09f * size, 0.07f * size}, -30);
        for (const float x : {-0.24f, -0.17f, 0.12f, 0.2f})
            line(material, at + Vec2f{x, -0.08f} * size, at + Vec2f{x + 0.02f, -0.3f} * size, 0.02f * size);
        line(soot, at + Vec2f{0.36f, 0.04f} * size, at + Vec2f{0.44f, 0.14f} * size, 0.012f * size);
        line(soot, at + Vec2f{0.33f, 0.04f} * size, at + Vec2f{0.34f, 0.15f} * size, 0.012f * size);
        line(material, at + Vec2f{-0.3f, 0.03f} * size, at + Vec2f{-0.38f, -0.1f} * size, 0.01f * size);
    };
    bison({-0.42f, 0.6f}, 0.95f, ochre), bison({0.36f, 0.34f}, 0.75f, soot), bison({0.3f, 0.8f}, 0.55f, ochre);
    for (int i = 0; i < 3; ++i) {
        const Vec2f at{-0.6f + 0.22f * static_cast<float>(i), 0.14f};
        line(soot, at, at + Vec2f{0, 0.12f}, 0.014f), spot(soot, at + Vec2f{0, 0.155f}, {0.025f, 0.028f}, 0);
        line(soot, at, at + Vec2f{-0.04f, -0.12f}, 0.01f), line(soot, at, at + Vec2f{0.05f, -0.12f}, 0.01f);
        line(soot, at + Vec2f{0, 0.09f}, at + Vec2f{0.09f, 0.06f}, 0.008f);
    }
    for (const Vec2f at : {Vec2f{0.72f, 0.62f}, {0.74f, 0.18f}}) {
        spot(ochre, at, {0.05f, 0.06f}, 0);
        for (int f = 0; f < 5; ++f) {
            const float a = 0.5f + 0.55f * static_cast<float>(f);
            line(ochre, at, at + Vec2f{0.11f * std::cos(a), 0.11f * std::sin(a)}, 0.012f);
        }
    }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.95f;
    (void)s;
}

// A torch in an iron holder.
void build_torch(Kit& k) {
    const int iron = k.main(*material_named("iron")), wood = color(k, "torch", {0.16f, 0.09f, 0.045f}, 0.9f),
              cloth = color(k, "tarred cloth", {0.05f, 0.04f, 0.03f}, 0.9f);
    k.board(iron, {0, 0.05f, 0.012f}, {0.09f, 0.26f, 0.024f}, 0.01f);
    Mesh ring = shapes::ring(0.045f, 0.016f, 18);
    k.add(std::move(ring), iron, {0, 0.22f, 0.11f});
    k.rod(iron, {0, 0.22f, 0.02f}, {0, 0.22f, 0.07f}, 0.012f, -1, 8),
        k.rod(iron, {0, 0.08f, 0.02f}, {0, 0.08f, 0.09f}, 0.012f, -1, 8);
    k.rod(wood, {0, 0, 0.085f}, {0, 0.44f, 0.125f}, 0.018f, 0.026f, 10);
    k.rod(cloth, {0, 0.42f, 0.124f}, {0, 0.52f, 0.13f}, 0.04f, 0.045f, 12);
    fire(k, {0, 0.5f, 0.13f}, 0.06f, 0.22f);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.5f;
}

}  // namespace fastscene::furniture
