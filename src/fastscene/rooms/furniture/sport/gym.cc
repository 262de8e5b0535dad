// Of gyms, changing rooms and saunas.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/shop/goods.h"
#include "fastscene/rooms/furniture/screen.h"

namespace fastscene::furniture {

void build_treadmill(Kit& k) {
    const int frame = k.main(plain("treadmill lacquer", {0.06f, 0.06f, 0.065f}, 0.35f)),
              belt = color(k, "belt", {0.025f, 0.025f, 0.025f}, 0.9f), metal = k.material(steel());
    k.board(frame, {0, 0.05f, 0}, {0.82f, 0.11f, 1.75f}, 0.02f);
    k.board(belt, {0, 0.155f, 0.06f}, {0.52f, 0.012f, 1.5f}, 0.003f);
    k.board(frame, {0, 0.14f, -0.72f}, {0.8f, 0.12f, 0.32f}, 0.03f);
    for (const float sx : {-1.f, 1.f}) {
        for (const float z : {-0.7f, 0.75f}) k.board(frame, {sx * 0.3f, 0, z}, {0.08f, 0.06f, 0.1f}, 0.01f);
        k.rod(metal, {sx * 0.38f, 0.15f, -0.62f}, {sx * 0.36f, 1.2f, -0.74f}, 0.03f, -1, 12);
        k.rod(frame, {sx * 0.36f, 0.98f, -0.7f}, {sx * 0.36f, 0.95f, -0.2f}, 0.022f, -1, 12);
    }
    Mesh panel = shapes::box({0.84f, 0.3f, 0.06f}, 0.02f), face = screen_box({0.42f, 0.2f, 0.004f});
    shapes::move(face, {0, -0.1f, 0.032f});
    for (Mesh* m : {&panel, &face}) shapes::turn(*m, {1, 0, 0}, -25);
    k.add(std::move(panel), frame, {0, 1.3f, -0.76f}),
        k.add(std::move(face), lit_screen(k, Shown::workout, kMonitorWhite, 0.42f), {0, 1.3f, -0.76f});
    k.piece.clearance_front_m = 0.6f;
}

void build_exercise_bike(Kit& k) {
    const int frame = k.main(plain("bike lacquer", {0.07f, 0.07f, 0.075f}, 0.3f)), metal = k.material(steel()),
              dark = color(k, "rubber", {0.025f, 0.025f, 0.025f}, 0.8f);
    for (const float z : {-0.45f, 0.45f}) k.rod(frame, {-0.25f, 0.04f, z}, {0.25f, 0.04f, z}, 0.035f, -1, 12);
    k.rod(frame, {0, 0.06f, -0.45f}, {0, 0.06f, 0.45f}, 0.035f, -1, 12);
    const std::array<Vec2f, 4> wheel{Vec2f{0.05f, 0}, {0.24f, 0.004f}, {0.24f, 0.05f}, {0.05f, 0.054f}};
    Mesh fly = shapes::lathe(wheel, 32);
    shapes::turn(fly, {0, 0, 1}, 90);
    k.add(std::move(fly), metal, {0.027f, 0.34f, 0.25f});
    k.rod(frame, {0, 0.06f, 0.1f}, {0, 0.75f, -0.2f}, 0.035f), k.rod(frame, {0, 0.3f, 0.0f}, {0, 1.0f, 0.38f}, 0.035f);
    k.add(shapes::ball({0, 0.9f, -0.25f}, {0.1f, 0.05f, 0.14f}, 16), dark);
    k.rod(frame, {0, 0.74f, -0.2f}, {0, 0.88f, -0.25f}, 0.022f);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(dark, {sx * 0.04f, 1.0f, 0.38f}, {sx * 0.22f, 1.08f, 0.3f}, 0.018f),
            k.rod(dark, {sx * 0.22f, 1.08f, 0.3f}, {sx * 0.22f, 1.12f, 0.16f}, 0.018f);
        k.rod(metal, {sx * 0.06f, 0.34f, 0.04f}, {sx * 0.12f, 0.34f + sx * 0.16f, 0.06f}, 0.014f),
            k.board(dark, {sx * 0.17f, 0.33f + sx * 0.16f, 0.06f}, {0.1f, 0.03f, 0.09f}, 0.006f);
    }
    k.board(dark, {0, 1.03f, 0.42f}, {0.26f, 0.16f, 0.04f}, 0.01f);
    k.piece.clearance_front_m = 0.4f;
}

namespace {

void dumbbell(Kit& k, int iron, int metal, Vec3f at, float r) {
    k.rod(metal, at + Vec3f{0, 0, -0.08f}, at + Vec3f{0, 0, 0.08f}, 0.014f, -1, 8);
    for (const float sz : {-1.f, 1.f})
        k.rod(iron, at + Vec3f{0, 0, sz * 0.06f}, at + Vec3f{0, 0, sz * (0.08f + 0.7f * r)}, r, -1, 8);
}
void plate(Kit& k, int iron, Vec3f at, float r, float thick) { k.rod(iron, at, at + Vec3f{thick, 0, 0}, r, -1, 22); }

}  // namespace

void build_dumbbell_rack(Kit& k) {
    const Vec3f s = k.wanted({1.8f, 0.95f, 0.55f});
    const int frame = k.main(plain("rack lacquer", {0.05f, 0.05f, 0.055f}, 0.4f)),
              iron = color(k, "rubber", {0.03f, 0.03f, 0.033f}, 0.7f), metal = k.material(steel());
    for (const float sx : {-1.f, 1.f}) {
        k.board(frame, {sx * (0.5f * s.x - 0.04f), 0, 0}, {0.07f, 0.06f, s.z}, 0.006f);
        strut(k, frame, {sx * (0.5f * s.x - 0.04f), 0.04f, 0.12f}, {sx * (0.5f * s.x - 0.04f), s.y, -0.22f}, 0.07f,
              0.06f);
    }
    for (int row = 0; row < 3; ++row) {
        const float y = 0.2f + 0.3f * static_cast<float>(row), z = 0.12f - 0.13f * static_cast<float>(row);
        for (const float dz : {-0.09f, 0.09f})
            k.board(frame, {0, y + (dz < 0 ? 0.04f : 0), z + dz}, {s.x - 0.1f, 0.03f, 0.06f}, 0.004f);
        const int count = 8 - row;
        for (int i = 0; i < count; ++i)
            dumbbell(k, iron, metal,
                     {-0.5f * s.x + 0.1f + (s.x - 0.2f) * (static_cast<float>(i) + 0.5f) / static_cast<float>(count),
                      y + 0.12f, z},
                     0.075f - 0.008f * static_cast<float>(row));
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.9f;
}

// A bench below a bar with plates on its uprights.
void build_weight_bench(Kit& k) {
    const int pad = k.main(plain("bench vinyl", {0.03f, 0.03f, 0.033f}, 0.45f)),
              frame = color(k, "frame", {0.45f, 0.46f, 0.47f}, 0.35f),
              iron = color(k, "iron plate", {0.035f, 0.035f, 0.038f}, 0.5f), metal = k.material(steel());
    k.board(frame, {0, 0.05f, 0}, {0.08f, 0.06f, 1.2f}, 0.006f);
    for (const float z : {-0.5f, 0.5f})
        k.board(frame, {0, 0, z}, {0.5f, 0.06f, 0.08f}, 0.006f),
            k.board(frame, {0, 0.06f, z}, {0.07f, 0.33f, 0.07f}, 0.006f);
    k.soft(pad, {0, 0.38f, 0.02f}, {0.3f, 0.09f, 1.2f}, {0.03f, 0.006f, 0, 8});
    for (const float sx : {-1.f, 1.f}) {
        k.board(frame, {sx * 0.5f, 0, -0.5f}, {0.07f, 1.05f, 0.07f}, 0.006f),
            k.board(frame, {sx * 0.5f, 0, -0.5f}, {0.07f, 0.05f, 0.5f}, 0.006f);
        k.board(frame, {sx * 0.5f, 0.97f, -0.44f}, {0.07f, 0.05f, 0.16f}, 0.006f);
    }
    k.board(frame, {0, 0.1f, -0.5f}, {1.0f, 0.06f, 0.06f}, 0.006f);
    k.rod(metal, {-0.95f, 1.05f, -0.42f}, {0.95f, 1.05f, -0.42f}, 0.014f, -1, 12);
    for (const float sx : {-1.f, 1.f})
        plate(k, iron, {sx > 0 ? 0.62f : -0.67f, 1.05f, -0.42f}, 0.22f, 0.05f),
            plate(k, iron, {sx > 0 ? 0.68f : -0.72f, 1.05f, -0.42f}, 0.17f, 0.04f);
    k.piece.clearance_front_m = 0.5f;
    k.piece.clearance_side_m = 0.3f;
}

void build_gym_mat(Kit& k) {
    const Vec3f s = k.wanted({0.65f, 0.014f, 1.8f});
    const int mat = k.main(plain("mat", k.accent(), 0.9f));
    k.add(shapes::prism(shapes::rounded_rectangle(s.x, s.z, 0.03f), 0, s.y, 0.004f), mat);
    for (int i = -8; i <= 8; ++i) block(k, mat, {0, s.y, 0.1f * static_cast<float>(i)}, {s.x - 0.06f, 0.001f, 0.02f});
}

void build_punching_bag(Kit& k) {
    const int leather = k.main(plain("bag leather", {0.25f, 0.025f, 0.02f}, 0.4f)), metal = k.material(steel()),
              dark = color(k, "base", {0.03f, 0.03f, 0.03f}, 0.5f);
    const std::array<Vec2f, 5> body{Vec2f{0.15f, 0}, {0.18f, 0.04f}, {0.18f, 1.05f}, {0.15f, 1.1f}, {0.02f, 1.11f}};
    k.add(shapes::lathe(body, 24, true), leather, {0, 0.55f, 0.15f});
    for (const float y : {0.75f, 1.45f}) k.add(shapes::ring(0.181f, 0.02f, 24), dark, {0, y, 0.15f});
    k.board(dark, {0, 0, 0}, {1.0f, 0.06f, 1.0f}, 0.02f);
    k.board(metal, {0, 0.06f, -0.4f}, {0.09f, 2.0f, 0.09f}, 0.008f);
    k.board(metal, {0, 1.99f, -0.13f}, {0.09f, 0.08f, 0.64f}, 0.008f);
    for (const float a : {0.f, 2.1f, 4.2f})
        k.rod(metal, {0.12f * std::cos(a), 1.65f, 0.15f + 0.12f * std::sin(a)}, {0, 2.0f, 0.15f}, 0.006f, -1, 5);
    k.piece.clearance_front_m = 0.6f;
}

// Four narrow doors with vents, on a plinth.
void build_lockers(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 1.85f, 0.5f});
    const int body = k.main(plain("locker lacquer", k.accent(), 0.4f)),
              dark = color(k, "slot", {0.02f, 0.02f, 0.02f}, 0.8f), metal = k.material(steel());
    k.board(dark, {0, 0, -0.01f}, {s.x - 0.04f, 0.1f, s.z - 0.06f});
    k.board(body, {0, 0.1f, 0}, {s.x, s.y - 0.1f, s.z - 0.03f}, 0.006f);
    const int doors = std::max(2, static_cast<int>(s.x / 0.3f));
    const float w = s.x / static_cast<float>(doors);
    for (int i = 0; i < doors; ++i) {
        const float x = -0.5f * s.x + w * (static_cast<float>(i) + 0.5f), z = 0.5f * s.z - 0.015f;
        k.board(body, {x, 0.13f, z}, {w - 0.014f, s.y - 0.16f, 0.022f}, 0.005f);
        for (int v = 0; v < 4; ++v)
            for (const float y : {0.3f, s.y - 0.28f})
                block(k, dark, {x, y + 0.035f * static_cast<float>(v), z + 0.0112f}, {0.5f * w, 0.008f, 0.001f});
        k.board(metal, {x + 0.3f * w, 0.52f * s.y, z + 0.012f}, {0.02f, 0.08f, 0.016f}, 0.004f);
        block(k, metal, {x, 0.8f * s.y - 0.1f, z + 0.0112f}, {0.08f, 0.03f, 0.002f});
    }
    k.top(s.y, 0, 0, 0.45f * s.x, 0.4f * s.z);
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.8f;
}

// Two steps of slats to sit and lie on.
void build_sauna_bench(Kit& k) {
    const Vec3f s = k.wanted({2.2f, 0.9f, 1.1f});
    const int wood = k.main(materials::timber("natural", 0.6f));
    for (int step = 0; step < 2; ++step) {
        const float y = step == 0 ? 0.45f : s.y, z = step == 0 ? 0.25f * s.z : -0.25f * s.z;
        for (int i = 0; i < 5; ++i)
            k.board(wood, {0, y - 0.03f, z + 0.5f * s.z * ((static_cast<float>(i) + 0.5f) / 5 - 0.5f)},
                    {s.x, 0.03f, 0.085f}, 0.006f);
        for (const float x : {-0.5f * s.x + 0.05f, 0.f, 0.5f * s.x - 0.05f})
            for (const float dz : {-0.2f, 0.2f}) k.board(wood, {x, 0, z + dz * s.z}, {0.05f, y - 0.03f, 0.05f}, 0.004f);
        for (float y2 = 0.12f; y2 < y - 0.1f; y2 += 0.11f)
            k.board(wood, {0, y2, z + 0.23f * s.z}, {s.x, 0.07f, 0.018f}, 0.004f);
    }
    k.top(s.y, 0, -0.25f * s.z, 0.45f * s.x, 0.2f * s.z);
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.6f;
}

void build_sauna_stove(Kit& k) {
    const int steel_case = k.main(plain("stove steel", {0.06f, 0.06f, 0.062f}, 0.35f)),
              rock = color(k, "stones", {0.12f, 0.115f, 0.11f}, 0.95f),
              wood = k.material(materials::timber("natural", 0.6f)),
              ember = k.material(flame("embers", {6.f, 1.6f, 0.2f}));
    k.board(steel_case, {0, 0.06f, 0}, {0.5f, 0.66f, 0.45f}, 0.02f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.board(steel_case, {sx * 0.2f, 0, sz * 0.17f}, {0.05f, 0.07f, 0.05f}, 0.006f);
    k.board(ember, {0, 0.16f, 0.222f}, {0.26f, 0.16f, 0.008f}, 0.003f);
    for (int i = 0; i < 26; ++i)
        k.add(shapes::ball({0, 0, 0}, Vec3f{1, 0.8f, 0.9f} * k.rng.uniform(0.045f, 0.07f), 8), rock,
              {k.rng.uniform(-0.18f, 0.18f), 0.74f + k.rng.uniform(0.f, 0.08f), k.rng.uniform(-0.15f, 0.15f)});
    for (const float sx : {-1.f, 1.f}) k.board(wood, {sx * 0.3f, 0.5f, 0}, {0.025f, 0.1f, 0.52f}, 0.006f);
    k.board(wood, {0, 0.5f, 0.27f}, {0.62f, 0.1f, 0.025f}, 0.006f);
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.6f;
}

}  // namespace fastscene::furniture
