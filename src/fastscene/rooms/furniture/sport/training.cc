// Of weight rooms: a power rack, bars, kettlebells, a rower, a ball to sit on.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// A long bar along x with discs at both ends, the outer one in the color that is asked for.
void loaded_bar(Kit& k, Vec3f at, float half, int disc, int iron, int metal) {
    k.rod(metal, at - Vec3f{half, 0, 0}, at + Vec3f{half, 0, 0}, 0.014f, -1, 10);
    for (const float sx : {-1.f, 1.f}) {
        const auto plate = [&](float x, float thick, float r, int mat) {
            const std::array<Vec2f, 6> rim{Vec2f{0.05f, 0},     {r - 0.04f, 0},     {r, 0.006f},
                                           {r, thick - 0.006f}, {r - 0.04f, thick}, {0.05f, thick}};
            Mesh m = shapes::lathe(rim, 28);
            shapes::turn(m, {0, 0, 1}, -90);
            k.add(std::move(m), mat, at + Vec3f{sx > 0 ? sx * x : sx * x - thick, 0, 0});
        };
        plate(half - 0.36f, 0.055f, 0.225f, disc), plate(half - 0.3f, 0.05f, 0.225f, iron);
        plate(half - 0.245f, 0.03f, 0.14f, iron);
        k.rod(metal, at + Vec3f{sx * (half - 0.41f), 0, 0}, at + Vec3f{sx * half, 0, 0}, 0.025f, -1, 12);
        k.rod(metal, at + Vec3f{sx * (half - 0.21f), 0, 0}, at + Vec3f{sx * (half - 0.18f), 0, 0}, 0.04f, -1, 12);
    }
}
void kettlebell(Kit& k, int iron, int band, Vec3f at, float r) {
    const std::array<Vec2f, 6> body{Vec2f{0.62f * r, 0},    {0.86f * r, 0.3f * r}, {r, 0.85f * r},
                                    {0.86f * r, 1.42f * r}, {0.5f * r, 1.75f * r}, {0, 1.82f * r}};
    k.add(shapes::lathe(body, 16, true), iron, at);
    k.add(shapes::lathe(std::array<Vec2f, 2>{Vec2f{1.005f * r, 0.78f * r}, {1.005f * r, 0.95f * r}}, 16), band, at);
    std::vector<Vec3f> handle;
    for (int i = 0; i <= 8; ++i) {
        const float a = kPi * static_cast<float>(i) / 8;
        handle.push_back(
            at + Vec3f{0.62f * r * std::cos(a) * (1 + 0.12f * std::sin(a)), (1.55f + 0.95f * std::sin(a)) * r, 0});
    }
    k.add(shapes::tube(handle, 0.17f * r, 8), iron);
}

}  // namespace

// Two shelves with pairs of rising weight.
void build_kettlebells(Kit& k) {
    const Vec3f s = k.wanted({1.0f, 0.72f, 0.42f});
    const int iron = k.main(plain("kettlebell", {0.04f, 0.04f, 0.043f}, 0.55f)),
              frame = color(k, "rack", {0.05f, 0.05f, 0.055f}, 0.4f);
    const std::array<int, 5> bands{
        color(k, "pink band", {0.6f, 0.1f, 0.25f}), color(k, "blue band", {0.05f, 0.15f, 0.5f}),
        color(k, "yellow band", {0.65f, 0.45f, 0.03f}), color(k, "green band", {0.05f, 0.35f, 0.1f}),
        color(k, "red band", {0.55f, 0.04f, 0.03f})};
    for (const float sx : {-1.f, 1.f}) {
        k.board(frame, {sx * (0.5f * s.x - 0.03f), 0, 0}, {0.05f, 0.04f, s.z}, 0.006f);
        strut(k, frame, {sx * (0.5f * s.x - 0.03f), 0.03f, 0.1f}, {sx * (0.5f * s.x - 0.03f), s.y - 0.22f, -0.13f},
              0.05f, 0.05f);
    }
    for (int row = 0; row < 2; ++row) {
        const float y = 0.12f + 0.36f * static_cast<float>(row), z = 0.06f - 0.16f * static_cast<float>(row);
        k.board(frame, {0, y, z}, {s.x - 0.04f, 0.025f, 0.24f}, 0.004f),
            k.board(frame, {0, y, z + 0.12f}, {s.x - 0.04f, 0.05f, 0.012f}, 0.003f);
        const int count = row == 0 ? 4 : 5;
        for (int i = 0; i < count; ++i)
            kettlebell(k, iron, bands[static_cast<std::size_t>(i + row) % bands.size()],
                       {-0.5f * s.x + 0.05f + (s.x - 0.1f) * (static_cast<float>(i) + 0.5f) / static_cast<float>(count),
                        y + 0.025f, z},
                       (row == 0 ? 0.095f : 0.072f) + 0.004f * static_cast<float>(i));
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.7f;
}

// One on the floor.
void build_kettlebell(Kit& k) {
    const int iron = k.main(plain("kettlebell", {0.04f, 0.04f, 0.043f}, 0.55f));
    kettlebell(k, iron, color(k, "band", k.accent()), {0, 0, 0}, k.rng.uniform(0.085f, 0.11f));
}

// A cage of four posts with the bar on its hooks.
void build_squat_rack(Kit& k) {
    const int frame = k.main(plain("rack lacquer", {0.05f, 0.05f, 0.055f}, 0.35f)),
              iron = color(k, "rubber disc", {0.03f, 0.03f, 0.033f}, 0.7f), metal = k.material(steel()),
              red = color(k, "colored disc",
                          k.rng.chance(0.5f) ? Vec3f{0.5f, 0.04f, 0.03f} : Vec3f{0.04f, 0.12f, 0.45f}, 0.6f),
              hole = color(k, "holes", {0.4f, 0.4f, 0.4f}, 0.6f);
    for (const float sx : {-1.f, 1.f}) {
        for (const float z : {-0.5f, 0.5f}) {
            k.board(frame, {sx * 0.56f, 0, z}, {0.075f, 2.25f, 0.075f}, 0.008f);
            for (int i = 0; i < 12; ++i)
                block(k, hole, {sx * 0.56f, 0.4f + 0.14f * static_cast<float>(i), z + 0.038f}, {0.02f, 0.02f, 0.001f});
        }
        k.board(frame, {sx * 0.56f, 0.0f, 0}, {0.075f, 0.06f, 1.3f}, 0.008f),
            k.board(frame, {sx * 0.56f, 2.17f, 0}, {0.07f, 0.07f, 1.0f}, 0.006f);
        k.rod(metal, {sx * 0.56f, 0.75f, -0.46f}, {sx * 0.56f, 0.75f, 0.46f}, 0.022f, -1, 10);
        k.board(frame, {sx * 0.56f, 1.36f, 0.57f}, {0.06f, 0.05f, 0.12f}, 0.006f),
            k.board(frame, {sx * 0.56f, 1.36f, 0.63f}, {0.06f, 0.12f, 0.02f}, 0.004f);
        for (const float y : {0.35f, 0.85f}) k.rod(iron, {sx * 0.61f, y, -0.5f}, {sx * 0.72f, y, -0.5f}, 0.2f, -1, 24);
    }
    for (const float z : {-0.5f, 0.5f}) k.board(frame, {0, 2.17f, z}, {1.06f, 0.07f, 0.06f}, 0.006f);
    k.board(frame, {0, 0, -0.5f}, {1.06f, 0.06f, 0.07f}, 0.006f),
        k.rod(metal, {-0.54f, 2.14f, 0.35f}, {0.54f, 2.14f, 0.35f}, 0.016f, -1, 10);
    loaded_bar(k, {0, 1.43f, 0.585f}, 1.08f, red, iron, metal);
    k.piece.clearance_front_m = 1.0f;
}

void build_barbell(Kit& k) {
    const int disc = k.main(plain("disc", {0.03f, 0.03f, 0.033f}, 0.6f)),
              iron = color(k, "rubber disc", {0.045f, 0.045f, 0.05f}, 0.7f), metal = k.material(steel());
    loaded_bar(k, {0, 0.225f, 0}, 1.05f, disc, iron, metal);
}

void build_exercise_ball(Kit& k) {
    const int skin = k.main(plain("ball vinyl", k.accent(), 0.35f));
    k.add(shapes::ball({0, 0.32f, 0}, {0.325f, 0.32f, 0.325f}, 32), skin);
    for (int i = -2; i <= 2; ++i) {
        const float y = 0.1f * static_cast<float>(i), r = 0.325f * std::sqrt(1 - (y / 0.32f) * (y / 0.32f));
        std::vector<Vec3f> line;
        for (int j = 0; j <= 28; ++j)
            line.push_back(around(kTau * static_cast<float>(j) / 28) * r + Vec3f{0, 0.32f + y, 0});
        k.add(shapes::tube(line, 0.004f, 4), skin);
    }
}

// A seat that slides on a rail before a wheel with vanes.
void build_rowing_machine(Kit& k) {
    const int frame = k.main(plain("rower lacquer", {0.06f, 0.06f, 0.065f}, 0.35f)), metal = k.material(steel()),
              dark = color(k, "rubber", {0.025f, 0.025f, 0.025f}, 0.8f), show = lit(k, "monitor", {0.25f, 0.4f, 0.35f});
    strut(k, metal, {0, 0.22f, -0.5f}, {0, 0.34f, 1.15f}, 0.07f, 0.06f);
    k.board(frame, {0, 0, 1.1f}, {0.5f, 0.05f, 0.07f}, 0.015f),
        k.board(frame, {0, 0.04f, 1.1f}, {0.06f, 0.28f, 0.06f}, 0.01f);
    k.board(frame, {0, 0, -0.95f}, {0.56f, 0.06f, 0.08f}, 0.015f),
        k.board(frame, {0, 0, -0.35f}, {0.5f, 0.05f, 0.07f}, 0.015f);
    k.board(frame, {0, 0.04f, -0.66f}, {0.1f, 0.14f, 0.66f}, 0.02f);
    Mesh wheel = shapes::rod({-0.09f, 0, 0}, {0.09f, 0, 0}, 0.26f, 0.26f, 28),
         hub = shapes::rod({-0.1f, 0, 0}, {0.1f, 0, 0}, 0.1f, 0.1f, 20);
    k.add(std::move(wheel), frame, {0, 0.42f, -0.82f}), k.add(std::move(hub), metal, {0, 0.42f, -0.82f});
    k.board(dark, {0, 0.37f, 0.45f}, {0.3f, 0.05f, 0.24f}, 0.02f),
        k.board(frame, {0, 0.31f, 0.45f}, {0.12f, 0.06f, 0.18f}, 0.006f);
    for (const float sx : {-1.f, 1.f}) {
        Mesh foot = shapes::box({0.12f, 0.32f, 0.03f}, 0.01f);
        shapes::turn(foot, {1, 0, 0}, -42);
        k.add(std::move(foot), dark, {sx * 0.13f, 0.3f, -0.36f});
    }
    strut(k, frame, {0, 0.5f, -0.82f}, {0, 1.0f, -0.6f}, 0.05f, 0.03f);
    Mesh panel = shapes::box({0.22f, 0.2f, 0.03f}, 0.01f), face = shapes::box({0.16f, 0.12f, 0.002f}, 0.0004f);
    shapes::move(face, {0, 0.01f, 0.016f});
    for (Mesh* m : {&panel, &face}) shapes::turn(*m, {1, 0, 0}, -12);
    k.add(std::move(panel), dark, {0, 1.06f, -0.57f}), k.add(std::move(face), show, {0, 1.06f, -0.57f});
    k.rod(dark, {-0.24f, 0.55f, -0.44f}, {0.24f, 0.55f, -0.44f}, 0.016f, -1, 10),
        k.rod(metal, {0, 0.55f, -0.44f}, {0, 0.52f, -0.6f}, 0.005f, -1, 5);
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture
