// Of churches: pews, an altar, a cross, a font, a stand of candles.
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// A bench with carved ends, a slanted back, and a ledge for books behind.
void build_pew(Kit& k) {
    const Vec3f s = k.wanted({2.2f, 0.95f, 0.6f});
    const int wood = k.main(k.style.wood);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * s.x - 0.025f);
        k.board(wood, {x, 0, 0.02f}, {0.05f, 0.6f, s.z - 0.06f}, 0.008f);
        k.board(wood, {x, 0.6f, -0.14f}, {0.05f, s.y - 0.62f, 0.26f}, 0.012f);
        k.add(shapes::ball({x, s.y - 0.02f, -0.14f}, {0.026f, 0.05f, 0.13f}, 10), wood);
    }
    k.board(wood, {0, 0.42f, 0.04f}, {s.x - 0.1f, 0.035f, 0.4f}, 0.008f);
    k.board(wood, {0, 0.1f, -0.1f}, {s.x - 0.1f, 0.32f, 0.025f}, 0.004f);
    Mesh back = shapes::box({s.x - 0.1f, 0.46f, 0.03f}, 0.006f);
    shapes::turn(back, {1, 0, 0}, -8);
    k.add(std::move(back), wood, {0, 0.68f, -0.2f});
    k.board(wood, {0, 0.76f, -0.26f}, {s.x - 0.1f, 0.02f, 0.1f}, 0.004f);
    k.top(0.455f, 0, 0.05f, 0.4f * s.x, 0.16f);
    k.piece.clearance_front_m = 0.35f;
}

// A stone table with a white cloth, two candles, a book and a gilt cross.
void build_altar(Kit& k) {
    const Vec3f s = k.wanted({2.0f, 1.0f, 0.8f});
    const int body = k.main(*material_named("marble")), linen = color(k, "altar cloth", {0.74f, 0.72f, 0.67f}, 0.9f),
              gold = k.material(*material_named("gold")), wax = color(k, "wax", {0.72f, 0.67f, 0.54f}, 0.6f),
              fire = k.material(flame("flame", {16, 8.5f, 1.4f})),
              trim = color(k, "antependium", {0.25f, 0.03f, 0.05f}, 0.9f);
    k.board(body, {0, 0, 0}, {s.x - 0.1f, 0.08f, s.z - 0.04f}, 0.01f);
    k.board(body, {0, 0.08f, 0}, {s.x - 0.25f, s.y - 0.16f, s.z - 0.18f}, 0.01f);
    k.board(body, {0, s.y - 0.08f, 0}, {s.x, 0.08f, s.z}, 0.012f);
    k.board(linen, {0, s.y, 0}, {s.x + 0.02f, 0.006f, 0.6f * s.z}, 0.002f);
    for (const float sx : {-1.f, 1.f})
        k.board(linen, {sx * (0.5f * s.x + 0.006f), s.y - 0.4f, 0}, {0.006f, 0.4f, 0.6f * s.z}, 0.002f);
    k.board(trim, {0, s.y - 0.62f, 0.5f * s.z + 0.003f}, {0.7f, 0.62f, 0.008f}, 0.002f);
    k.board(gold, {0, s.y - 0.46f, 0.5f * s.z + 0.01f}, {0.05f, 0.32f, 0.004f}, 0.001f);
    k.board(gold, {0, s.y - 0.26f, 0.5f * s.z + 0.01f}, {0.2f, 0.05f, 0.004f}, 0.001f);
    k.board(gold, {0, s.y + 0.006f, -0.2f}, {0.2f, 0.05f, 0.12f}, 0.01f);
    k.board(gold, {0, s.y + 0.05f, -0.2f}, {0.035f, 0.6f, 0.03f}, 0.005f);
    k.board(gold, {0, s.y + 0.42f, -0.2f}, {0.3f, 0.035f, 0.03f}, 0.005f);
    for (const float sx : {-1.f, 1.f}) {
        const Vec3f at{sx * 0.36f * s.x, s.y + 0.006f, -0.1f};
        const std::array<Vec2f, 7> stick{Vec2f{0.07f, 0}, {0.06f, 0.02f}, {0.018f, 0.05f}, {0.028f, 0.12f},
                                         {0.016f, 0.2f},  {0.04f, 0.25f}, {0.045f, 0.26f}};
        k.add(shapes::lathe(stick, 16, true), gold, at);
        k.rod(wax, at + Vec3f{0, 0.26f, 0}, at + Vec3f{0, 0.5f, 0}, 0.02f);
        k.add(shapes::ball({0, 0, 0}, {0.011f, 0.03f, 0.011f}, 10), fire, at + Vec3f{0, 0.535f, 0});
    }
    Mesh book = shapes::box({0.36f, 0.03f, 0.26f}, 0.006f);
    shapes::turn(book, {1, 0, 0}, -15);
    k.add(std::move(book), color(k, "missal", {0.66f, 0.62f, 0.52f}, 0.8f), {0.3f, s.y + 0.06f, 0.1f});
    k.top(s.y + 0.006f, -0.3f, 0.15f, 0.2f, 0.1f);
    k.piece.clearance_front_m = 1.0f;
}

void build_wall_cross(Kit& k) {
    const Vec3f s = k.wanted({1.1f, 1.8f, 0.08f});
    const int wood = k.main(k.style.wood);
    k.board(wood, {0, 0, 0.04f}, {0.14f * s.x, s.y, s.z}, 0.01f);
    k.board(wood, {0, 0.62f * s.y, 0.04f}, {s.x, 0.14f * s.x, s.z * 0.98f}, 0.01f);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 2.1f;
}

// Rows of small lights on an iron frame.
void build_votive_stand(Kit& k) {
    const int iron = k.main(*material_named("iron")), fire = k.material(flame("flame", {16, 8.5f, 1.4f}));
    const int red = color(k, "red glass", {0.5f, 0.03f, 0.02f}, 0.1f),
              wax = color(k, "wax", {0.72f, 0.67f, 0.54f}, 0.6f);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(iron, {sx * 0.4f, 0, 0.18f}, {sx * 0.4f, 0.85f, 0.18f}, 0.014f);
        k.rod(iron, {sx * 0.4f, 0, -0.18f}, {sx * 0.4f, 1.15f, -0.18f}, 0.014f);
    }
    for (int row = 0; row < 4; ++row) {
        const float y = 0.8f + 0.1f * static_cast<float>(row), z = 0.18f - 0.12f * static_cast<float>(row);
        k.board(iron, {0, y, z}, {0.9f, 0.012f, 0.11f}, 0.003f);
        for (int i = 0; i < 7; ++i) {
            const Vec3f at{-0.36f + 0.12f * static_cast<float>(i), y + 0.012f, z};
            const std::array<Vec2f, 2> cup{Vec2f{0.026f, 0}, {0.032f, 0.05f}};
            k.add(shapes::vessel(cup, 0.004f, 10), row % 2 ? wax : red, at);
            if (k.rng.chance(0.7f))
                k.add(shapes::ball({0, 0, 0}, {0.008f, 0.02f, 0.008f}, 8), fire, at + Vec3f{0, 0.07f, 0});
        }
    }
    k.piece.clearance_front_m = 0.6f;
    k.piece.against_wall = true;
}

// Five arms on a tall stand.
void build_candelabra(Kit& k) {
    const int brass = k.main(*material_named("brass")), wax = color(k, "wax", {0.72f, 0.67f, 0.54f}, 0.6f),
              fire = k.material(flame("flame", {16, 8.5f, 1.4f}));
    const std::array<Vec2f, 10> stem{Vec2f{0.18f, 0}, {0.17f, 0.02f}, {0.06f, 0.07f},  {0.03f, 0.15f}, {0.045f, 0.3f},
                                     {0.022f, 0.45f}, {0.022f, 0.9f}, {0.042f, 0.98f}, {0.02f, 1.05f}, {0.02f, 1.4f}};
    k.add(shapes::lathe(stem, 18, true), brass);
    for (int i = -2; i <= 2; ++i) {
        const float x = 0.14f * static_cast<float>(i), y = i == 0 ? 1.4f : 1.34f;
        if (i != 0) {
            const std::array<Vec3f, 4> arm{Vec3f{0, 1.05f, 0}, {0.6f * x, 1.04f, 0}, {x, 1.14f, 0}, {x, y, 0}};
            k.add(shapes::tube(arm, 0.012f), brass);
        }
        const std::array<Vec2f, 2> pan{Vec2f{0.02f, 0}, {0.045f, 0.02f}};
        k.add(shapes::vessel(pan, 0.004f, 14), brass, {x, y, 0});
        k.rod(wax, {x, y + 0.01f, 0}, {x, y + 0.2f, 0}, 0.014f);
        k.add(shapes::ball({x, y + 0.23f, 0}, {0.01f, 0.028f, 0.01f}, 10), fire);
    }
    k.piece.clearance_front_m = 0.3f;
}

void build_font(Kit& k) {
    const int stone = k.main(*material_named("stone")), water = color(k, "water", {0.1f, 0.14f, 0.16f}, 0.05f);
    const std::array<Vec2f, 8> body{Vec2f{0.34f, 0}, {0.34f, 0.08f}, {0.2f, 0.16f},  {0.17f, 0.45f},
                                    {0.24f, 0.58f},  {0.42f, 0.7f},  {0.44f, 0.95f}, {0.36f, 0.96f}};
    k.add(shapes::lathe(body, 8), stone);
    k.add(shapes::prism(shapes::circle(0.33f, 24), 0.93f, 0.965f, 0.002f), water);
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture
