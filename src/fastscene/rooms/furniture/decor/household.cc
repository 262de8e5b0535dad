// About the house: a folding screen, beds and houses of pets, a cage with a bird, a hot tub, logs and irons for fires.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// Leaves at angles: of slats, of cloth in frames.
void build_folding_screen(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 1.75f, 0.35f});
    const bool cloth = k.rng.chance(0.5f) && k.request.material.empty();
    const int leaf = k.main(cloth ? plain("screen paper", {0.7f, 0.66f, 0.55f}, 0.9f) : k.style.wood),
              frame = cloth ? k.material(k.style.wood2) : leaf, metal = k.material(*material_named("brass"));
    constexpr int kLeaves = 4;
    const float pitch = s.x / kLeaves, deep = s.z - 0.03f, w = std::hypot(pitch, deep),
                angle = std::atan2(deep, pitch) * 57.29578f;
    for (int i = 0; i < kLeaves; ++i) {
        const Vec3f at{-0.5f * s.x + pitch * (static_cast<float>(i) + 0.5f), 0, 0};
        const auto put = [&](Vec3f size, Vec3f base, int mat) {
            Mesh m = shapes::box(size, size.y > 0.06f ? 0.003f : 0.001f);
            shapes::lay_grain(m), shapes::move(m, base + Vec3f{0, 0.5f * size.y, 0}),
                shapes::turn(m, {0, 1, 0}, i % 2 ? angle : -angle), k.add(std::move(m), mat, at);
        };
        for (const float e : {-1.f, 1.f}) put({0.035f, s.y, 0.025f}, {e * (0.5f * w - 0.02f), 0, 0}, frame);
        for (const float y : {0.12f, 0.5f * s.y, s.y - 0.05f}) put({w - 0.07f, 0.04f, 0.022f}, {0, y, 0}, frame);
        if (cloth) {
            put({w - 0.07f, s.y - 0.17f, 0.008f}, {0, 0.14f, 0}, leaf);
        } else
            for (int j = 0; j < 14; ++j)
                put({w - 0.07f, 0.07f, 0.01f}, {0, 0.17f + (s.y - 0.26f) * static_cast<float>(j) / 14, 0}, leaf);
        if (i > 0)
            for (const float y : {0.3f, s.y - 0.3f})
                k.rod(metal, {at.x - 0.5f * pitch, y, (i % 2 ? 0.5f : -0.5f) * deep},
                      {at.x - 0.5f * pitch, y + 0.07f, (i % 2 ? 0.5f : -0.5f) * deep}, 0.009f, -1, 6);
    }
}

// A bolster around a cushion; with the pattern "house" a small hut with a round door.
void build_kennel(Kit& k) {
    if (k.request.pattern == "house") {
        const int wall = k.main(k.style.wood), roof = color(k, "roof felt", {0.3f, 0.06f, 0.04f}, 0.8f),
                  dark = color(k, "inside", {0.02f, 0.016f, 0.012f}, 0.9f);
        const float w = 0.7f, d = 0.85f, h = 0.5f;
        for (int i = 0; i < 5; ++i) k.board(wall, {0, 0.05f + 0.1f * static_cast<float>(i), 0}, {w, 0.096f, d}, 0.004f);
        Mesh gable = shapes::prism(std::vector<Vec2f>{{0.5f * w, 0}, {0, -0.3f}, {-0.5f * w, 0}}, -0.5f * d, 0.5f * d,
                                   0.004f);
        shapes::turn(gable, {1, 0, 0}, 90), k.add(std::move(gable), wall, {0, h + 0.05f, 0});
        for (const float sx : {-1.f, 1.f})
            slat(k, roof, {sx * (0.5f * w + 0.08f), h - 0.02f, 0}, {0, h + 0.37f, 0}, 0.03f, d + 0.14f),
                k.board(wall, {sx * 0.28f, 0, 0}, {0.06f, 0.05f, d - 0.1f}, 0.004f);
        k.board(dark, {0, 0.06f, 0.5f * d}, {0.34f, 0.28f, 0.012f}, 0.003f);
        Mesh arch = shapes::rod({0, 0, -0.006f}, {0, 0, 0.006f}, 0.17f, 0.17f, 24);
        k.add(std::move(arch), dark, {0, 0.34f, 0.5f * d});
        k.piece.clearance_front_m = 0.4f;
        return;
    }
    const Vec3f s = k.wanted({0.85f, 0.24f, 0.65f});
    const int cloth = k.main(tinted(k.style.fabric, lerp(k.accent(), {0.3f, 0.26f, 0.22f}, 0.5f))),
              pad = k.material(tinted(k.style.fabric, {0.62f, 0.58f, 0.5f}));
    k.soft(pad, {0, 0.01f, 0}, {s.x - 0.16f, 0.13f, s.z - 0.14f}, {0.05f, 0.03f, 0.002f, 10});
    std::vector<Vec3f> path;
    for (int i = 0; i <= 26; ++i) {
        const float a = kTau * (0.32f + 0.86f * static_cast<float>(i) / 26), c = std::cos(a), n = std::sin(a);
        const auto squared = [](float v) { return std::copysign(std::pow(std::abs(v), 0.65f), v); };
        path.push_back({(0.5f * s.x - 0.09f) * squared(c), 0.11f, (0.5f * s.z - 0.09f) * squared(n)});
    }
    k.add_soft(shapes::tube(path, 0.09f, 12), cloth, kPillowCrease);
    for (const Vec3f& e : {path.front(), path.back()}) k.add(shapes::ball(e, {0.09f, 0.09f, 0.09f}, 12), cloth);
    k.add(shapes::prism(shapes::rounded_rectangle(s.x - 0.1f, s.z - 0.1f, 0.15f), 0, 0.03f, 0.008f), cloth);
}

// A round cage of wires on a stand with a bird on its perch.
void build_bird_cage(Kit& k) {
    const int wire = k.main(*material_named("brass"), false),
              bird = color(k, "feathers", k.rng.chance(0.5f) ? Vec3f{0.7f, 0.55f, 0.05f} : Vec3f{0.1f, 0.4f, 0.15f},
                           0.9f),
              beak = color(k, "beak", {0.5f, 0.15f, 0.03f}, 0.4f), dark = color(k, "eye", {0.02f, 0.02f, 0.02f}, 0.2f),
              wood = k.material(materials::timber("natural", 0.6f));
    const float low = 0.95f, r = 0.22f, straight = 0.34f;
    k.add(shapes::lathe(
              std::array<Vec2f, 5>{Vec2f{0.19f, 0}, {0.18f, 0.02f}, {0.04f, 0.05f}, {0.018f, 0.1f}, {0.015f, low}}, 18,
              true),
          wire);
    k.add(shapes::vessel(std::array<Vec2f, 3>{Vec2f{0.2f, low}, {r + 0.01f, low + 0.02f}, {r + 0.015f, low + 0.06f}},
                         0.006f, 24),
          wire);
    for (int i = 0; i < 22; ++i) {
        const Vec3f d = around(kTau * static_cast<float>(i) / 22);
        std::vector<Vec3f> bar{d * r + Vec3f{0, low + 0.03f, 0}, d * r + Vec3f{0, low + straight, 0}};
        for (int j = 1; j <= 5; ++j) {
            const float a = 0.5f * kPi * static_cast<float>(j) / 5;
            bar.push_back(d * (r * std::cos(a) + 0.004f) + Vec3f{0, low + straight + 0.18f * std::sin(a), 0});
        }
        k.add(shapes::tube(bar, 0.003f, 4), wire);
    }
    for (const float y : {low + 0.18f, low + straight}) {
        std::vector<Vec3f> hoop;
        for (int i = 0; i <= 24; ++i) hoop.push_back(around(kTau * static_cast<float>(i) / 24) * r + Vec3f{0, y, 0});
        k.add(shapes::tube(hoop, 0.004f, 5), wire);
    }
    Mesh loop = shapes::ring(0.03f, 0.005f, 14);
    shapes::turn(loop, {1, 0, 0}, 90), k.add(std::move(loop), wire, {0, low + straight + 0.21f, 0});
    k.rod(wood, {-r, low + 0.17f, 0}, {r, low + 0.17f, 0}, 0.007f, -1, 8);
    const float y = low + 0.22f;
    const std::vector<Limb> body{{{0.02f, y, -0.015f}, {0.02f, y + 0.035f, 0.012f}, 0.027f, 0.024f},
                                 {{0.02f, y + 0.06f, 0.02f}, {0.02f, y + 0.062f, 0.024f}, 0.021f, 0.02f},
                                 {{0.02f, y - 0.02f, -0.03f}, {0.02f, y - 0.065f, -0.075f}, 0.014f, 0.006f}};
    k.add(shapes::skin(body, 0.015f, 0.011f), bird),
        k.rod(beak, {0.02f, y + 0.062f, 0.04f}, {0.02f, y + 0.055f, 0.058f}, 0.007f, 0.001f, 6);
    for (const float s : {-1.f, 1.f})
        k.add(shapes::ball({0.02f + s * 0.016f, y + 0.068f, 0.034f}, {0.004f, 0.004f, 0.004f}, 6), dark),
            k.rod(beak, {0.02f + s * 0.01f, y - 0.02f, 0}, {0.02f + s * 0.01f, y - 0.045f, 0}, 0.003f, -1, 5);
}

// A round tub of staves with hoops, steps and bubbling water.
void build_hot_tub(Kit& k) {
    const int wood = k.main(materials::timber("natural", 0.6f)), iron = k.material(*material_named("iron")),
              water = color(k, "water", {0.14f, 0.38f, 0.42f}, 0.04f),
              foam = color(k, "foam", {0.75f, 0.78f, 0.78f}, 0.6f);
    const float r = 0.8f, h = 0.9f;
    constexpr int kStaves = 30;
    for (int i = 0; i < kStaves; ++i) {
        const float a = kTau * static_cast<float>(i) / kStaves;
        Mesh m = shapes::box({kTau * r / kStaves - 0.004f, h, 0.045f}, 0.005f);
        shapes::lay_grain(m, {0, 0.37f * static_cast<float>(i), 0}), shapes::turn(m, {0, 1, 0}, 90 - a * 57.29578f),
            k.add(std::move(m), wood, around(a) * r + Vec3f{0, 0.5f * h, 0});
    }
    for (const float y : {0.14f, 0.72f})
        k.add(shapes::lathe(
                  std::array<Vec2f, 4>{
                      Vec2f{r + 0.02f, y}, {r + 0.03f, y}, {r + 0.03f, y + 0.05f}, {r + 0.02f, y + 0.05f}},
                  36),
              iron);
    for (int i = 0; i < 24; ++i) {
        const float a = kTau * static_cast<float>(i) / 24;
        Mesh m = shapes::box({kTau * (r + 0.04f) / 24, 0.035f, 0.15f}, 0.006f);
        shapes::lay_grain(m, {0, 0.37f * static_cast<float>(i), 0}), shapes::turn(m, {0, 1, 0}, 90 - a * 57.29578f);
        k.add(std::move(m), wood, around(a) * r + Vec3f{0, h + 0.015f, 0});
    }
    k.add(shapes::prism(shapes::circle(r - 0.02f, 36), h - 0.14f, h - 0.09f, 0.002f), water);
    for (int i = 0; i < 40; ++i) {
        const float d = 0.6f * std::sqrt(k.rng.uniform(0.f, 1.f)), q = k.rng.uniform(0.012f, 0.04f);
        k.add(shapes::ball(around(k.rng.uniform(0.f, kTau)) * d + Vec3f{0, h - 0.088f, 0}, {q, 0.4f * q, q}, 6), foam);
    }
    for (int i = 0; i < 2; ++i) {
        const float y = 0.27f * static_cast<float>(i + 1), z = r + 0.34f - 0.22f * static_cast<float>(i);
        k.board(wood, {0, y, z}, {0.7f, 0.035f, 0.26f}, 0.008f);
        for (const float sx : {-1.f, 1.f}) k.board(wood, {sx * 0.31f, 0, z}, {0.04f, y, 0.2f}, 0.005f);
    }
    k.piece.clearance_front_m = 0.5f;
}

namespace {

void split_log(Kit& k, int bark, int cut, Vec3f c, float r, float len, float turn) {
    Mesh m = shapes::rod({0, 0, -0.5f * len}, {0, 0, 0.5f * len}, r, r, 9),
         face = shapes::rod({0, 0, -0.5f * len - 0.003f}, {0, 0, 0.5f * len + 0.003f}, 0.9f * r, 0.9f * r, 9);
    for (Mesh* p : {&m, &face}) shapes::turn(*p, {0, 0, 1}, turn), shapes::lay_grain(*p, {turn, 0, 0});
    k.add(std::move(m), bark, c), k.add(std::move(face), cut, c);
}

}  // namespace

// Logs stacked in an iron frame.
void build_firewood(Kit& k) {
    const Vec3f s = k.wanted({0.85f, 0.75f, 0.36f});
    const int bark = k.main(plain("bark", {0.12f, 0.075f, 0.045f}, 0.95f)),
              cut = color(k, "cut wood", {0.52f, 0.36f, 0.19f}, 0.85f), iron = k.material(*material_named("iron"));
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.board(iron, {sx * (0.5f * s.x - 0.012f), 0, sz * (0.5f * s.z - 0.06f)}, {0.024f, s.y, 0.024f}, 0.003f);
    for (const float sz : {-1.f, 1.f})
        k.board(iron, {0, 0.08f, sz * (0.5f * s.z - 0.06f)}, {s.x, 0.024f, 0.024f}, 0.003f);
    const float r = 0.055f;
    int row = 0;
    for (float y = 0.105f + r; y < s.y - r; y += 1.75f * r, ++row)
        for (float x = -0.5f * s.x + 0.03f + r * (row % 2 ? 1.9f : 1.f); x < 0.5f * s.x - 0.02f - r; x += 2.02f * r)
            split_log(k, bark, cut, {x, y, k.rng.uniform(-0.015f, 0.015f)}, r * k.rng.uniform(0.84f, 1.f), s.z - 0.04f,
                      k.rng.uniform(0.f, 90.f));
    k.piece.clearance_front_m = 0.2f;
}

// Poker, brush, shovel and tongs on their stand.
void build_fire_irons(Kit& k) {
    const int iron = k.main(*material_named("iron"), false), brass = k.material(*material_named("brass")),
              hair = color(k, "bristles", {0.08f, 0.05f, 0.03f}, 0.95f);
    k.add(shapes::prism(shapes::circle(0.13f, 24), 0, 0.02f, 0.005f), iron),
        k.rod(iron, {0, 0.02f, 0}, {0, 0.7f, 0}, 0.011f, -1, 10),
        k.add(shapes::ball({0, 0.72f, 0}, {0.025f, 0.03f, 0.025f}, 12), brass);
    for (int i = 0; i < 4; ++i) {
        const Vec3f d = around(kTau * (static_cast<float>(i) + 0.5f) / 4), c = d * 0.085f;
        k.rod(iron, Vec3f{0, 0.56f, 0}, c + Vec3f{0, 0.56f, 0}, 0.006f, -1, 6),
            k.rod(iron, c + Vec3f{0, 0.1f, 0}, c + Vec3f{0, 0.58f, 0}, 0.006f, -1, 6),
            k.rod(brass, c + Vec3f{0, 0.56f, 0}, c + Vec3f{0, 0.66f, 0}, 0.011f, 0.009f, 8);
        if (i == 0) k.rod(iron, c + Vec3f{0, 0.14f, 0}, c + Vec3f{0.035f, 0.11f, 0}, 0.006f, 0.002f, 6);
        if (i == 1) k.rod(hair, c + Vec3f{0, 0.05f, 0}, c + Vec3f{0, 0.16f, 0}, 0.034f, 0.018f, 10);
        if (i == 2) k.board(iron, c + Vec3f{0, 0.04f, 0}, {0.09f, 0.13f, 0.012f}, 0.004f);
        if (i == 3)
            k.rod(iron, c + Vec3f{0.02f, 0.06f, 0}, c + Vec3f{0, 0.4f, 0}, 0.005f, -1, 6),
                k.rod(iron, c + Vec3f{-0.02f, 0.06f, 0}, c + Vec3f{0, 0.4f, 0}, 0.005f, -1, 6);
    }
}

// Three leaves of mesh in iron frames.
void build_fire_screen(Kit& k) {
    const int iron = k.main(*material_named("iron"), false), mesh = color(k, "mesh", {0.06f, 0.06f, 0.06f}, 0.6f);
    for (int leaf = -1; leaf <= 1; ++leaf) {
        const float w = leaf == 0 ? 0.62f : 0.3f, h = leaf == 0 ? 0.72f : 0.66f;
        const auto put = [&](Vec3f a, Vec3f b, float r, int mat) {
            Mesh m = shapes::rod(a, b, r, r, 5);
            shapes::turn(m, {0, 1, 0}, static_cast<float>(leaf) * 40.f),
                k.add(std::move(m), mat, {static_cast<float>(leaf) * 0.43f, 0, leaf == 0 ? 0.f : -0.1f});
        };
        for (const float e : {-1.f, 1.f}) put({e * 0.5f * w, 0, 0}, {e * 0.5f * w, h, 0}, 0.01f, iron);
        for (const float y : {0.05f, h}) put({-0.5f * w, y, 0}, {0.5f * w, y, 0}, 0.01f, iron);
        for (int i = 1; i < 14; ++i)
            put({-0.5f * w, 0.05f + (h - 0.05f) * static_cast<float>(i) / 14, 0},
                {0.5f * w, 0.05f + (h - 0.05f) * static_cast<float>(i) / 14, 0}, 0.002f, mesh);
        const int n = leaf == 0 ? 14 : 7;
        for (int i = 1; i < n; ++i)
            put({w * (static_cast<float>(i) / static_cast<float>(n) - 0.5f), 0.05f, 0},
                {w * (static_cast<float>(i) / static_cast<float>(n) - 0.5f), h, 0}, 0.002f, mesh);
    }
}

}  // namespace fastscene::furniture
