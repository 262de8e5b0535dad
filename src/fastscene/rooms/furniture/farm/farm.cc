// Of barns: bales, stalls, a cart wheel, churns.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

int straw_of(Kit& k, bool main) {
    Material m = plain("hay", {0.52f, 0.37f, 0.12f}, 0.95f);
    m.pattern = Pattern::carpet, m.color_b = {0.3f, 0.19f, 0.05f}, m.color_c = {0.64f, 0.5f, 0.2f}, m.scale_m = 0.03f,
    m.bump_m = 0.006f;
    return main ? k.main(m, false) : k.material(m);
}

void bale(Kit& k, int hay, int stalk, int twine, Vec3f base, Vec3f size, int steps = 12, int stalks = 26) {
    Mesh m = shapes::soft_box(size, {0.03f, 0.015f, 0.012f, steps, k.seed()});
    k.add(std::move(m), hay, base + Vec3f{0, size.y / 2, 0});
    for (const float x : {-0.25f, 0.25f}) {
        block(k, twine, base + Vec3f{x * size.x, -0.002f + size.y, 0}, {0.012f, 0.008f, size.z});
        block(k, twine, base + Vec3f{x * size.x, 0, size.z / 2}, {0.012f, size.y, 0.008f});
    }
    for (int i = 0; i < stalks; ++i) {
        const Vec3f at = base + Vec3f{k.rng.uniform(-0.48f, 0.48f) * size.x, k.rng.uniform(0.05f, 0.98f) * size.y,
                                      0.5f * size.z};
        k.rod(stalk, at, at + Vec3f{k.rng.uniform(-0.07f, 0.07f), k.rng.uniform(-0.05f, 0.06f), 0.025f}, 0.0025f, -1,
              4);
    }
}

}  // namespace

void build_hay_bale(Kit& k) {
    const Vec3f s = k.wanted({1.0f, 0.45f, 0.5f});
    const int hay = straw_of(k, true), stalk = color(k, "straw", {0.66f, 0.5f, 0.2f}, 0.8f),
              twine = color(k, "twine", {0.3f, 0.2f, 0.1f}, 0.9f);
    bale(k, hay, stalk, twine, {0, 0, 0}, s - Vec3f{0, 0, 0.03f});
    k.top(s.y, 0, 0, 0.35f * s.x, 0.3f * s.z);
}

// Bales piled up at a wall, loose hay at their foot.
void build_hay_stack(Kit& k) {
    const int hay = straw_of(k, true), stalk = color(k, "straw", {0.66f, 0.5f, 0.2f}, 0.8f),
              twine = color(k, "twine", {0.3f, 0.2f, 0.1f}, 0.9f);
    const Vec3f one{0.98f, 0.44f, 0.52f};
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < 3 - row / 2; ++i)
            for (int deep = 0; deep < (row < 2 ? 2 : 1); ++deep) {
                const float x = 1.0f * (static_cast<float>(i) - 0.5f * static_cast<float>(2 - row / 2)) +
                                0.12f * static_cast<float>(row % 2);
                bale(k, hay, stalk, twine,
                     {x, 0.44f * static_cast<float>(row), -0.28f + 0.55f * static_cast<float>(deep)}, one, 6, 8);
            }
    for (int i = 0; i < 60; ++i) {
        const Vec3f at{k.rng.uniform(-1.4f, 1.4f), 0.01f, k.rng.uniform(0.5f, 0.78f)};
        k.rod(stalk, at,
              at + Vec3f{k.rng.uniform(-0.15f, 0.15f), k.rng.uniform(0, 0.06f), k.rng.uniform(-0.08f, 0.08f)}, 0.003f,
              -1, 4);
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.5f;
}

// A loose box for a horse: boarded sides, a front with a half door and bars, straw, a manger, a bucket.
void build_horse_stall(Kit& k) {
    const Vec3f s = k.wanted({2.9f, 2.15f, 2.3f});
    Material plank = plain("stall boards", {0.3f, 0.17f, 0.075f}, 0.8f);
    plank.pattern = Pattern::wood, plank.color_b = {0.19f, 0.1f, 0.04f}, plank.scale_m = 0.06f;
    const int wood = k.main(plank), iron = k.material(*material_named("iron")), hay = straw_of(k, false),
              stalk = color(k, "straw", {0.66f, 0.5f, 0.2f}, 0.8f), zinc = k.material(steel());
    const float hx = s.x / 2, hz = s.z / 2;
    for (const float side : {-1.f, 1.f}) {
        for (const float z : {-hz + 0.06f, hz - 0.06f})
            k.board(wood, {side * (hx - 0.06f), 0, z}, {0.12f, s.y, 0.12f}, 0.01f);
        for (int i = 0; i < 7; ++i)
            k.board(wood, {side * (hx - 0.06f), 0.04f + 0.2f * static_cast<float>(i), 0}, {0.045f, 0.19f, s.z - 0.2f},
                    0.008f);
        k.board(wood, {side * (hx - 0.06f), s.y - 0.1f, 0}, {0.09f, 0.1f, s.z - 0.2f}, 0.008f);
        for (int i = 0; i < 12; ++i) {
            const float z = (s.z - 0.4f) * (static_cast<float>(i) / 11 - 0.5f);
            k.rod(iron, {side * (hx - 0.06f), 1.4f, z}, {side * (hx - 0.06f), s.y - 0.08f, z}, 0.011f, -1, 6);
        }
    }
    // The front: boards and bars at the left, at the right a half door with a brace.
    const float split = 0.15f * s.x;
    k.board(wood, {split, 0, hz - 0.06f}, {0.12f, s.y, 0.12f}, 0.01f);
    for (int i = 0; i < 7; ++i)
        k.board(wood, {(split - hx) / 2, 0.04f + 0.2f * static_cast<float>(i), hz - 0.06f},
                {split + hx - 0.2f, 0.19f, 0.045f}, 0.008f);
    for (float x = -hx + 0.22f; x < split - 0.1f; x += 0.13f)
        k.rod(iron, {x, 1.42f, hz - 0.06f}, {x, s.y - 0.08f, hz - 0.06f}, 0.011f, -1, 6);
    const float d0 = split + 0.07f, d1 = hx - 0.13f;
    for (int i = 0; i < 6; ++i)
        k.board(wood, {std::lerp(d0, d1, (static_cast<float>(i) + 0.5f) / 6), 0.1f, hz - 0.06f},
                {(d1 - d0) / 6 - 0.008f, 1.1f, 0.035f}, 0.006f);
    for (const float y : {0.22f, 1.05f}) k.board(wood, {(d0 + d1) / 2, y, hz - 0.03f}, {d1 - d0, 0.1f, 0.03f}, 0.006f);
    slat(k, wood, {d0 + 0.05f, 0.3f, hz - 0.03f}, {d1 - 0.05f, 1.07f, hz - 0.03f}, 0.09f, 0.03f);
    k.board(iron, {d1 - 0.12f, 0.8f, hz - 0.01f}, {0.16f, 0.03f, 0.02f}, 0.005f);
    k.board(wood, {0, s.y - 0.1f, hz - 0.06f}, {s.x, 0.1f, 0.1f}, 0.01f);
    // Within.
    Mesh litter = shapes::sheet(16, 14, [&](float u, float v) {
        const float x = (s.x - 0.26f) * (u - 0.5f), z = (s.z - 0.26f) * (0.5f - v);
        return Vec3f{x, 0.05f + 0.03f * shapes::wobble({3 * x, 0, 3 * z}, 9), z};
    });
    k.add(std::move(litter), hay);
    for (int i = 0; i < 50; ++i) {
        const Vec3f at{k.rng.uniform(-0.44f, 0.44f) * s.x, 0.09f, k.rng.uniform(-0.44f, 0.44f) * s.z};
        k.rod(stalk, at, at + Vec3f{k.rng.uniform(-0.15f, 0.15f), 0.03f, k.rng.uniform(-0.15f, 0.15f)}, 0.003f, -1, 4);
    }
    k.board(wood, {-hx + 0.5f, 0.75f, -hz + 0.2f}, {0.75f, 0.3f, 0.36f}, 0.02f);
    k.soft(hay, {-hx + 0.5f, 1.0f, -hz + 0.2f}, {0.68f, 0.14f, 0.3f}, {0.05f, 0.02f, 0.02f, 10});
    const std::array<Vec2f, 2> bucket{Vec2f{0.12f, 0}, {0.16f, 0.3f}};
    k.add(shapes::vessel(bucket, 0.006f, 18), zinc, {hx - 0.4f, 0.06f, -hz + 0.4f});
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.9f;
}

// The wheel of a cart, leaned at a wall.
void build_wagon_wheel(Kit& k) {
    const int wood = k.main(k.style.wood), iron = k.material(*material_named("iron"));
    constexpr float r = 0.5f;
    Mesh tire = shapes::ring(r - 0.01f, 0.03f, 36), felloe = shapes::ring(r - 0.06f, 0.07f, 36);
    for (Mesh* m : {&tire, &felloe}) shapes::turn(*m, {1, 0, 0}, 90);
    k.add(std::move(felloe), wood, {0, r, 0.06f}), k.add(std::move(tire), iron, {0, r, 0.06f});
    for (int i = 0; i < 12; ++i) {
        const float a = kTau * static_cast<float>(i) / 12;
        k.rod(wood, {0, r, 0.06f}, {(r - 0.06f) * std::cos(a), r + (r - 0.06f) * std::sin(a), 0.06f}, 0.02f, 0.016f, 8);
    }
    k.rod(wood, {0, r, 0}, {0, r, 0.13f}, 0.075f, 0.06f, 16), k.rod(iron, {0, r, 0.12f}, {0, r, 0.16f}, 0.03f, -1, 12);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.7f;
}

// A milk churn.
void build_milk_churn(Kit& k) {
    const int zinc = k.main(steel());
    const std::array<Vec2f, 9> p{Vec2f{0.17f, 0}, {0.175f, 0.02f}, {0.17f, 0.04f}, {0.17f, 0.4f}, {0.1f, 0.52f},
                                 {0.1f, 0.58f},   {0.13f, 0.6f},   {0.13f, 0.62f}, {0.05f, 0.65f}};
    k.add(shapes::lathe(p, 24), zinc);
    for (const float side : {-1.f, 1.f}) {
        const std::array<Vec3f, 4> grip{Vec3f{side * 0.12f, 0.5f, 0},
                                        {side * 0.19f, 0.52f, 0},
                                        {side * 0.19f, 0.43f, 0},
                                        {side * 0.165f, 0.38f, 0}};
        k.add(shapes::tube(grip, 0.012f, 8), zinc);
    }
}

}  // namespace fastscene::furniture
