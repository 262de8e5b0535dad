// What stands beside swimming pools.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// A block with a sloping, rough top, its number in front and a grip for starts on the back.
void build_starting_block(Kit& k) {
    const int white = k.main(plain("starting block", {0.7f, 0.7f, 0.68f}, 0.35f)),
              grip = color(k, "grip", {0.03f, 0.09f, 0.28f}, 0.9f), metal = k.material(steel());
    k.board(white, {0, 0, -0.06f}, {0.36f, 0.6f, 0.4f}, 0.03f);
    Mesh top = shapes::box({0.52f, 0.06f, 0.66f}, 0.015f), mat = shapes::box({0.46f, 0.008f, 0.6f}, 0.002f);
    shapes::move(mat, {0, 0.033f, 0});
    for (Mesh* m : {&top, &mat}) shapes::turn(*m, {1, 0, 0}, 9);
    k.add(std::move(top), white, {0, 0.65f, 0}), k.add(std::move(mat), grip, {0, 0.65f, 0});
    for (const float sx : {-1.f, 1.f}) k.rod(metal, {sx * 0.2f, 0.56f, 0.3f}, {sx * 0.2f, 0.42f, 0.3f}, 0.014f, -1, 8);
    k.rod(metal, {-0.2f, 0.43f, 0.3f}, {0.2f, 0.43f, 0.3f}, 0.014f, -1, 8);
    k.board(grip, {0, 0.18f, 0.145f}, {0.2f, 0.26f, 0.006f}, 0.002f);
    block(k, white, {0, 0.23f, 0.149f}, {0.035f, 0.16f, 0.002f});
    k.board(metal, {0, 0, -0.36f}, {0.3f, 0.16f, 0.16f}, 0.01f);
    k.piece.clearance_front_m = 0.5f;
}

// Ropes of floats, rolled out side by side.
void build_lane_ropes(Kit& k) {
    const Vec3f s = k.wanted({1.3f, 0.12f, 4.5f});
    const int red = k.main(plain("red float", {0.6f, 0.04f, 0.03f}, 0.4f)),
              white = color(k, "white float", {0.72f, 0.72f, 0.7f}, 0.4f),
              blue = color(k, "blue float", {0.03f, 0.12f, 0.45f}, 0.4f),
              cord = color(k, "rope", {0.7f, 0.66f, 0.5f}, 0.8f);
    for (int rope = 0; rope < 3; ++rope) {
        const float x = (s.x - 0.12f) * (static_cast<float>(rope) / 2 - 0.5f);
        k.rod(cord, {x, 0.06f, -0.5f * s.z}, {x, 0.06f, 0.5f * s.z}, 0.008f, -1, 5);
        const int floats = static_cast<int>(s.z / 0.14f) - 1;
        for (int j = 0; j < floats; ++j) {
            Mesh m = shapes::rod({0, 0, -0.055f}, {0, 0, 0.055f}, 0.055f, 0.055f, 9);
            k.add(std::move(m),
                  j < 6 || j >= floats - 6 ? red
                  : (j / 3) % 2            ? white
                                           : blue,
                  {x, 0.06f, 0.14f * (static_cast<float>(j) + 0.5f - 0.5f * static_cast<float>(floats))});
        }
    }
}

// A springboard one metre high with rails and steps behind; the water is in front.
void build_diving_board(Kit& k) {
    const int board = k.main(plain("springboard", {0.25f, 0.5f, 0.62f}, 0.7f)), metal = k.material(steel()),
              stone = color(k, "base", {0.6f, 0.58f, 0.54f}, 0.7f),
              dark = color(k, "roller", {0.03f, 0.03f, 0.033f}, 0.6f);
    const float y = 1.0f;
    k.board(stone, {0, 0, -0.9f}, {0.7f, 0.12f, 1.9f}, 0.02f),
        k.board(stone, {0, 0.12f, -0.15f}, {0.42f, y - 0.22f, 0.34f}, 0.03f);
    k.rod(dark, {-0.26f, y - 0.06f, -0.15f}, {0.26f, y - 0.06f, -0.15f}, 0.045f, -1, 14);
    k.board(board, {0, y, 0.2f}, {0.5f, 0.05f, 3.6f}, 0.015f),
        k.board(metal, {0, y - 0.06f, -1.5f}, {0.56f, 0.06f, 0.12f}, 0.01f);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(metal, {sx * 0.25f, 0.1f, -1.5f}, {sx * 0.25f, y, -1.5f}, 0.03f, -1, 10);
        const std::vector<Vec3f> rail{{sx * 0.3f, 0, -2.05f},    {sx * 0.3f, 1.1f, -1.72f},  {sx * 0.3f, 1.85f, -1.55f},
                                      {sx * 0.3f, 1.95f, -1.4f}, {sx * 0.3f, 1.95f, -0.35f}, {sx * 0.3f, 1.85f, -0.25f},
                                      {sx * 0.3f, 0.1f, -0.2f}};
        k.add(shapes::tube(rail, 0.02f, 8), metal);
        k.rod(metal, {sx * 0.3f, 1.5f, -1.63f}, {sx * 0.3f, 1.5f, -0.24f}, 0.014f, -1, 8);
    }
    for (int i = 1; i <= 4; ++i)
        k.board(metal, {0, 0.2f * static_cast<float>(i), -2.02f + 0.06f * static_cast<float>(i)},
                {0.58f, 0.025f, 0.12f}, 0.006f);
    k.piece.clearance_front_m = 0.8f;
}

// Two bent rails with steps, as they stand on the rim.
void build_pool_ladder(Kit& k) {
    const int metal = k.main(steel(), false), dark = color(k, "step", {0.6f, 0.6f, 0.58f}, 0.6f);
    for (const float sx : {-1.f, 1.f}) {
        std::vector<Vec3f> rail{{sx * 0.26f, 0, -0.32f}, {sx * 0.26f, 0.85f, -0.32f}};
        for (int i = 1; i <= 6; ++i) {
            const float a = kPi * static_cast<float>(i) / 6;
            rail.push_back({sx * 0.26f, 0.95f + 0.22f * std::sin(a), -0.1f - 0.22f * std::cos(a)});
        }
        rail.push_back({sx * 0.26f, 0, 0.14f});
        k.add(shapes::tube(rail, 0.021f, 10), metal);
        k.add(shapes::prism(shapes::circle(0.05f, 16), 0, 0.015f, 0.004f), metal, {sx * 0.26f, 0, -0.32f});
    }
    for (int i = 0; i < 3; ++i)
        k.board(dark, {0, 0.05f + 0.24f * static_cast<float>(i), 0.13f}, {0.5f, 0.03f, 0.09f}, 0.008f);
    k.piece.clearance_front_m = 0.5f;
}

// A high seat of painted timber with a ladder in front.
void build_lifeguard_chair(Kit& k) {
    const int wood = k.main(plain("white paint", {0.74f, 0.73f, 0.7f}, 0.5f)),
              red = color(k, "rescue float", {0.62f, 0.05f, 0.03f}, 0.5f);
    const float seat = 1.55f;
    for (const float sx : {-1.f, 1.f}) {
        strut(k, wood, {sx * 0.36f, 0, 0.52f}, {sx * 0.36f, seat + 0.28f, 0.24f}, 0.06f, 0.09f);
        strut(k, wood, {sx * 0.36f, 0, -0.55f}, {sx * 0.36f, seat + 0.85f, -0.3f}, 0.06f, 0.09f);
        for (const float y : {0.5f, 1.1f}) k.board(wood, {sx * 0.36f, y, 0}, {0.04f, 0.08f, 0.84f - 0.2f * y}, 0.006f);
        k.board(wood, {sx * 0.36f, seat + 0.24f, -0.02f}, {0.1f, 0.03f, 0.62f}, 0.008f);
    }
    for (int i = 0; i < 5; ++i)
        k.board(wood, {0, seat, 0.2f - 0.11f * static_cast<float>(i)}, {0.74f, 0.03f, 0.095f}, 0.006f);
    for (int i = 0; i < 4; ++i)
        k.board(wood, {0, seat + 0.2f + 0.15f * static_cast<float>(i), -0.345f + 0.022f * static_cast<float>(i)},
                {0.74f, 0.11f, 0.025f}, 0.006f);
    for (int i = 0; i < 5; ++i)
        k.board(wood, {0, 0.24f + 0.26f * static_cast<float>(i), 0.49f - 0.042f * static_cast<float>(i)},
                {0.74f, 0.04f, 0.1f}, 0.008f);
    for (const float y : {0.6f, 1.3f}) k.board(wood, {0, y, -0.5f + 0.1f * y}, {0.7f, 0.08f, 0.03f}, 0.006f);
    Mesh can = shapes::rod({0, -0.34f, 0}, {0, 0.34f, 0}, 0.08f, 0.05f, 14);
    k.add(std::move(can), red, {0.46f, 1.2f, 0.1f});
    k.piece.clearance_front_m = 0.7f;
}

// A folding seat of slats or canvas.
void build_deck_chair(Kit& k) {
    const int cloth = k.main(tinted(k.style.fabric, k.accent())), wood = k.material(materials::timber("natural", 0.6f)),
              white = color(k, "stripe", {0.74f, 0.72f, 0.67f}, 0.9f);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.27f;
        strut(k, wood, {x, 0, 0.52f}, {x, 0.98f, -0.5f}, 0.03f, 0.055f);
        strut(k, wood, {sx * 0.235f, 0.0f, -0.48f}, {sx * 0.235f, 0.42f, 0.5f}, 0.03f, 0.055f);
        strut(k, wood, {sx * 0.3f, 0.06f, -0.6f}, {sx * 0.3f, 0.72f, -0.22f}, 0.025f, 0.045f);
    }
    k.rod(wood, {-0.29f, 0.98f, -0.5f}, {0.29f, 0.98f, -0.5f}, 0.02f, -1, 10),
        k.rod(wood, {-0.27f, 0.42f, 0.5f}, {0.27f, 0.42f, 0.5f}, 0.02f, -1, 10);
    k.rod(wood, {-0.27f, 0.03f, 0.5f}, {0.27f, 0.03f, 0.5f}, 0.015f, -1, 8),
        k.rod(wood, {-0.3f, 0.07f, -0.58f}, {0.3f, 0.07f, -0.58f}, 0.015f, -1, 8);
    const std::array<Vec3f, 5> sag{
        Vec3f{0, 0.44f, 0.51f}, {0, 0.27f, 0.27f}, {0, 0.27f, 0.02f}, {0, 0.55f, -0.24f}, {0, 1.0f, -0.5f}};
    constexpr int kStripes = 7;
    for (int s = 0; s < kStripes; ++s)
        k.add(shapes::slab(1, 16, 0.004f,
                           [&](float u, float v) {
                               const float t = v * 4;
                               const std::size_t i = std::min<std::size_t>(3, static_cast<std::size_t>(t));
                               const Vec3f p0 = sag[i > 0 ? i - 1 : 0], p1 = sag[i], p2 = sag[i + 1],
                                           p3 = sag[std::min<std::size_t>(4, i + 2)];
                               const float f = t - static_cast<float>(i);
                               Vec3f p = (p1 * 2.f + (p2 - p0) * f + (p0 * 2.f - p1 * 5.f + p2 * 4.f - p3) * (f * f) +
                                          (p1 * 3.f - p0 - p2 * 3.f + p3) * (f * f * f)) *
                                         0.5f;
                               p.x = 0.44f * ((static_cast<float>(s) + u) / kStripes - 0.5f);
                               return p;
                           }),
              s % 2 ? white : cloth);
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture
