// Of wards and first aid: wheelchairs, crutches, gurneys, scales, cabinets, extinguishers, a skeleton.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

void build_wheelchair(Kit& k) {
    const int cloth = k.main(plain("wheelchair cloth", {0.03f, 0.05f, 0.1f}, 0.7f)), metal = k.material(steel()),
              dark = color(k, "tire", {0.03f, 0.03f, 0.03f}, 0.7f);
    k.board(cloth, {0, 0.47f, 0.02f}, {0.44f, 0.06f, 0.44f}, 0.02f),
        k.board(cloth, {0, 0.5f, -0.21f}, {0.43f, 0.42f, 0.03f}, 0.012f);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.24f;
        Mesh tire = shapes::ring(0.29f, 0.017f, 36), rim = shapes::ring(0.25f, 0.008f, 32);
        shapes::turn(tire, {0, 0, 1}, 90), shapes::turn(rim, {0, 0, 1}, 90);
        k.add(std::move(tire), dark, {sx * 0.29f, 0.307f, -0.13f}),
            k.add(std::move(rim), metal, {sx * 0.33f, 0.307f, -0.13f});
        for (int i = 0; i < 6; ++i) {
            const float a = kTau * static_cast<float>(i) / 12;
            const Vec3f d{0, 0.285f * std::sin(a), 0.285f * std::cos(a)}, c{sx * 0.29f, 0.307f, -0.13f};
            k.rod(metal, c - d, c + d, 0.003f, -1, 4);
        }
        k.rod(metal, {x, 0.307f, -0.13f}, {sx * 0.33f, 0.307f, -0.13f}, 0.025f, -1, 10);
        k.rod(metal, {x, 0.3f, -0.21f}, {x, 0.95f, -0.22f}, 0.013f, -1, 8),
            k.rod(metal, {x, 0.95f, -0.22f}, {x, 0.95f, -0.34f}, 0.013f, -1, 8),
            k.rod(dark, {x, 0.95f, -0.25f}, {x, 0.95f, -0.35f}, 0.018f, -1, 8);
        k.rod(metal, {x, 0.46f, -0.21f}, {x, 0.46f, 0.24f}, 0.013f, -1, 8),
            k.rod(metal, {x, 0.7f, -0.21f}, {x, 0.7f, 0.15f}, 0.013f, -1, 8),
            k.rod(metal, {x, 0.7f, 0.15f}, {x, 0.2f, 0.24f}, 0.013f, -1, 8);
        k.board(dark, {x, 0.7f, -0.02f}, {0.05f, 0.035f, 0.28f}, 0.012f);
        k.rod(metal, {x, 0.46f, 0.24f}, {sx * 0.14f, 0.13f, 0.42f}, 0.012f, -1, 8),
            k.board(dark, {sx * 0.12f, 0.11f, 0.46f}, {0.17f, 0.018f, 0.14f}, 0.006f);
        k.rod(dark, {x - 0.012f, 0.075f, 0.24f}, {x + 0.012f, 0.075f, 0.24f}, 0.075f, -1, 14);
    }
    for (const float s : {-1.f, 1.f})
        k.rod(metal, {s * 0.24f, 0.22f, -0.05f}, {-s * 0.24f, 0.46f, -0.05f}, 0.011f, -1, 8);
    k.piece.clearance_front_m = 0.5f;
}

// A pair that leans against the wall.
void build_crutches(Kit& k) {
    const int metal = k.main(plain("aluminum", {0.5f, 0.51f, 0.52f}, 0.35f)),
              dark = color(k, "rubber", {0.05f, 0.05f, 0.055f}, 0.7f);
    for (const float s : {-1.f, 1.f}) {
        const std::size_t from = k.piece.meshes.size();
        for (const float sx : {-1.f, 1.f})
            k.rod(metal, {sx * 0.022f, 0.36f, 0}, {sx * 0.055f, 1.26f, 0}, 0.011f, -1, 8);
        k.rod(metal, {0, 0.04f, 0}, {0, 0.46f, 0}, 0.012f, -1, 8),
            k.rod(dark, {0, 0, 0}, {0, 0.06f, 0}, 0.022f, 0.017f, 10),
            k.rod(dark, {-0.05f, 0.82f, 0}, {0.05f, 0.82f, 0}, 0.018f, -1, 10);
        k.board(dark, {0, 1.25f, 0}, {0.17f, 0.05f, 0.05f}, 0.022f);
        for (std::size_t i = from; i < k.piece.meshes.size(); ++i)
            shapes::move(shapes::turn(shapes::turn(k.piece.meshes[i], {1, 0, 0}, -9), {0, 0, 1}, s * 2.5f),
                         {s * 0.14f, 0.005f, 0.12f});
    }
    k.piece.against_wall = true;
}

// A stretcher on wheels with rails, a pad and a folded blanket.
void build_stretcher(Kit& k) {
    const int metal = k.material(steel()), pad = k.main(plain("gurney pad", {0.12f, 0.25f, 0.42f}, 0.5f)),
              sheet = color(k, "sheet", {0.75f, 0.76f, 0.76f}, 0.9f),
              dark = color(k, "wheel", {0.03f, 0.03f, 0.03f}, 0.6f);
    for (const float z : {-0.75f, 0.75f})
        for (const float sx : {-1.f, 1.f})
            k.rod(dark, {sx * 0.27f - 0.015f, 0.08f, z}, {sx * 0.27f + 0.015f, 0.08f, z}, 0.08f, -1, 14),
                k.rod(metal, {sx * 0.27f, 0.14f, z}, {sx * 0.24f, 0.24f, z}, 0.015f, -1, 8);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(metal, {sx * 0.24f, 0.24f, -0.8f}, {sx * 0.24f, 0.24f, 0.8f}, 0.018f, -1, 8),
            k.rod(metal, {sx * 0.26f, 0.74f, -0.95f}, {sx * 0.26f, 0.74f, 0.95f}, 0.018f, -1, 8);
        for (const float s : {-1.f, 1.f})
            k.rod(metal, {sx * 0.24f, 0.25f, s * 0.7f}, {sx * 0.25f, 0.73f, -s * 0.55f}, 0.015f, -1, 8);
        k.rod(metal, {sx * 0.32f, 1.0f, -0.45f}, {sx * 0.32f, 1.0f, 0.45f}, 0.012f, -1, 8);
        for (int i = 0; i < 4; ++i)
            k.rod(metal, {sx * 0.32f, 0.74f, -0.42f + 0.28f * static_cast<float>(i)},
                  {sx * 0.32f, 1.0f, -0.42f + 0.28f * static_cast<float>(i)}, 0.009f, -1, 6);
    }
    for (const float z : {-0.95f, 0.95f})
        k.rod(metal, {-0.26f, 0.74f, z}, {0.26f, 0.74f, z}, 0.018f, -1, 8),
            k.rod(metal, {-0.24f, 0.24f, z * 0.84f}, {0.24f, 0.24f, z * 0.84f}, 0.018f, -1, 8);
    k.board(metal, {0, 0.72f, 0}, {0.54f, 0.03f, 1.86f}, 0.006f),
        k.soft(pad, {0, 0.75f, 0.3f}, {0.56f, 0.1f, 1.26f}, {0.03f, 0.006f, 0, 8});
    Mesh head = shapes::soft_box({0.56f, 0.1f, 0.68f}, {0.03f, 0.006f, 0, 8, k.seed()}),
         pillow = shapes::soft_box({0.44f, 0.1f, 0.3f}, {0.05f, 0.02f, 0.001f, 8, k.seed()});
    shapes::turn(head, {1, 0, 0}, 20), shapes::turn(pillow, {1, 0, 0}, 20),
        k.add(std::move(head), pad, {0, 0.9f, -0.61f}), k.add(std::move(pillow), sheet, {0, 1.05f, -0.75f});
    k.soft(sheet, {0, 0.845f, 0.62f}, {0.5f, 0.08f, 0.4f}, {0.03f, 0.008f, 0.002f, 8});
    k.piece.clearance_side_m = 0.4f;
}

// A white case with two doors of glass, its bottles and boxes behind them.
void build_medicine_cabinet(Kit& k) {
    const Vec3f s = k.wanted({0.8f, 1.75f, 0.4f});
    const int body = k.main(plain("lacquered steel", {0.72f, 0.74f, 0.74f}, 0.35f)), metal = k.material(steel()),
              pane = k.material(glass()), red = color(k, "cross", {0.6f, 0.02f, 0.02f}, 0.5f);
    const float low = 0.1f, t = 0.025f, half = 0.5f * s.x;
    for (const float sx : {-1.f, 1.f}) {
        k.board(body, {sx * (half - 0.5f * t), low, 0}, {t, s.y - low, s.z}, 0.005f);
        for (const float sz : {-1.f, 1.f})
            k.rod(metal, {sx * (half - 0.04f), 0, sz * (0.5f * s.z - 0.05f)},
                  {sx * (half - 0.04f), low, sz * (0.5f * s.z - 0.05f)}, 0.016f, -1, 8);
    }
    k.board(body, {0, low, -0.5f * s.z + 0.01f}, {s.x - 0.01f, s.y - low, 0.02f}, 0.003f);
    const int rows = 5;
    const float step = (s.y - low - t) / rows;
    for (int i = 0; i <= rows; ++i) {
        const float y = low + step * static_cast<float>(i);
        k.board(body, {0, y, 0}, {s.x - 2 * t + 0.01f, t, s.z - (i == 0 || i == rows ? 0.f : 0.05f)}, 0.004f);
        if (i < rows)
            stock(k, Goods::medicines, -half + 0.05f, half - 0.05f, y + t, 0.75f * step, 0.5f * s.z - 0.06f,
                  s.z - 0.12f);
    }
    for (const float sx : {-1.f, 1.f}) {
        block(k, pane, {sx * 0.5f * half, low + 0.05f, 0.5f * s.z}, {half - 0.08f, s.y - low - 0.1f, 0.004f});
        for (const float e : {0.02f, half - 0.02f})
            block(k, body, {sx * e, low + 0.01f, 0.5f * s.z}, {0.036f, s.y - low - 0.02f, 0.02f});
        for (const float y : {low + 0.01f, s.y - 0.05f})
            block(k, body, {sx * 0.5f * half, y, 0.5f * s.z}, {half - 0.04f, 0.04f, 0.02f});
        k.board(metal, {sx * 0.022f, 0.55f * s.y, 0.5f * s.z + 0.02f}, {0.01f, 0.12f, 0.02f}, 0.004f);
    }
    block(k, red, {0.5f * half, 0.78f * s.y, 0.5f * s.z + 0.004f}, {0.03f, 0.1f, 0.002f}),
        block(k, red, {0.5f * half, 0.78f * s.y + 0.035f, 0.5f * s.z + 0.004f}, {0.1f, 0.03f, 0.002f});
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.5f;
}

// A doctor's scale: platform, column, beam with its weights.
void build_scale(Kit& k) {
    const int body = k.main(plain("scale", {0.7f, 0.71f, 0.7f}, 0.35f)),
              dark = color(k, "rubber", {0.04f, 0.04f, 0.043f}, 0.7f), metal = k.material(steel());
    k.board(body, {0, 0, 0.05f}, {0.32f, 0.07f, 0.5f}, 0.02f), block(k, dark, {0, 0.07f, 0.1f}, {0.28f, 0.006f, 0.36f}),
        k.board(body, {0, 0.05f, -0.16f}, {0.07f, 1.35f, 0.05f}, 0.01f);
    k.board(body, {0, 1.38f, -0.15f}, {0.4f, 0.03f, 0.05f}, 0.008f),
        k.board(metal, {0, 1.44f, -0.14f}, {0.44f, 0.022f, 0.012f}, 0.003f),
        k.board(metal, {0, 1.4f, -0.115f}, {0.42f, 0.016f, 0.01f}, 0.003f);
    for (int i = 0; i < 17; ++i)
        block(k, dark, {-0.19f + 0.024f * static_cast<float>(i), 1.446f, -0.1335f},
              {0.0025f, i % 4 ? 0.006f : 0.012f, 0.002f});
    k.board(dark, {-0.06f, 1.43f, -0.135f}, {0.035f, 0.05f, 0.03f}, 0.006f),
        k.board(dark, {0.09f, 1.39f, -0.11f}, {0.025f, 0.035f, 0.025f}, 0.005f);
    for (const float sx : {-1.f, 1.f}) block(k, metal, {sx * 0.2f, 1.38f, -0.14f}, {0.012f, 0.09f, 0.02f});
    k.board(metal, {0, 1.4f, -0.18f}, {0.022f, 0.45f, 0.012f}, 0.003f),
        k.board(metal, {0, 1.82f, -0.08f}, {0.022f, 0.012f, 0.2f}, 0.003f);
    k.piece.clearance_front_m = 0.4f, k.piece.against_wall = true;
}

void build_first_aid_box(Kit& k) {
    const bool green = k.rng.chance(0.5f);
    const int body = k.main(
                  plain("first aid box", green ? Vec3f{0.02f, 0.32f, 0.12f} : Vec3f{0.76f, 0.77f, 0.76f}, 0.4f)),
              cross = color(k, "cross", green ? Vec3f{0.8f, 0.8f, 0.8f} : Vec3f{0.6f, 0.02f, 0.02f}, 0.5f),
              metal = k.material(steel());
    k.board(body, {0, 0, 0.06f}, {0.36f, 0.28f, 0.115f}, 0.018f),
        block(k, metal, {0, 0.001f, 0.07f}, {0.35f, 0.277f, 0.006f});
    block(k, cross, {0, 0.065f, 0.1185f}, {0.05f, 0.15f, 0.003f}),
        block(k, cross, {0, 0.115f, 0.1185f}, {0.15f, 0.05f, 0.003f});
    for (const float sx : {-1.f, 1.f}) block(k, metal, {sx * 0.1f, 0.255f, 0.075f}, {0.03f, 0.035f, 0.09f});
    k.board(cross, {0, 0.285f, 0.06f}, {0.11f, 0.014f, 0.02f}, 0.005f);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.35f;
}

// On its hook, with a hose, a gauge and a label.
void build_fire_extinguisher(Kit& k) {
    const int red = k.main(plain("signal red", {0.55f, 0.015f, 0.015f}, 0.25f)),
              dark = color(k, "hose", {0.025f, 0.025f, 0.028f}, 0.5f), metal = k.material(steel()),
              label = color(k, "label", {0.8f, 0.78f, 0.7f}, 0.6f);
    const std::array<Vec2f, 8> form{Vec2f{0.072f, 0}, {0.078f, 0.008f}, {0.08f, 0.03f},  {0.08f, 0.38f},
                                    {0.07f, 0.425f},  {0.042f, 0.452f}, {0.024f, 0.46f}, {0.022f, 0.49f}};
    k.add(shapes::lathe(form, 24, true), red, {0, 0, 0.1f}),
        k.rod(dark, {0, 0.001f, 0.1f}, {0, 0.03f, 0.1f}, 0.0815f, -1, 24);
    k.rod(metal, {0, 0.485f, 0.1f}, {0, 0.525f, 0.1f}, 0.022f, -1, 12);
    for (const float y : {0.525f, 0.56f})
        strut(k, y > 0.53f ? red : dark, {0, y, 0.08f}, {0, y + (y > 0.53f ? 0.03f : 0.f), 0.2f}, 0.024f, 0.008f);
    k.rod(label, {0, 0.508f, 0.115f}, {0, 0.508f, 0.135f}, 0.018f, -1, 12);
    k.add(shapes::sheet(10, 1,
                        [](float u, float v) {
                            const float a = -0.9f + 1.8f * u;
                            return Vec3f{0.0812f * std::sin(a), 0.16f + 0.16f * (1 - v), 0.1f + 0.0812f * std::cos(a)};
                        }),
          label);
    std::vector<Vec3f> path;
    for (int i = 0; i <= 12; ++i) {
        const float t = static_cast<float>(i) / 12;
        path.push_back({0.02f + 0.085f * std::sin(std::min(1.f, 2 * t) * 0.5f * kPi),
                        0.515f + 0.06f * std::sin(kPi * std::min(1.f, 2.2f * t)) - 0.42f * t * t, 0.11f});
    }
    k.add(shapes::tube(path, 0.009f, 8), dark),
        k.rod(dark, {0.105f, 0.14f, 0.11f}, {0.105f, 0.06f, 0.11f}, 0.012f, 0.018f, 10);
    block(k, metal, {0, 0.3f, 0.011f}, {0.05f, 0.24f, 0.02f}),
        k.add(shapes::ring(0.082f, 0.005f, 24), metal, {0, 0.3f, 0.1f});
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.75f;
}

// Bones on a stand with wheels: skull, ribs, spine, pelvis, limbs.
void build_skeleton(Kit& k) {
    const int bone = k.main(plain("bone", {0.72f, 0.66f, 0.52f}, 0.5f)),
              dark = color(k, "socket", {0.03f, 0.025f, 0.02f}, 0.8f), metal = k.material(steel());
    for (int i = 0; i < 5; ++i) {
        const Vec3f d = around(kTau * static_cast<float>(i) / 5 + 0.3f) * 0.28f;
        k.rod(metal, {0, 0.07f, -0.1f}, d + Vec3f{0, 0.05f, -0.1f}, 0.012f, -1, 6),
            k.add(shapes::ball(d + Vec3f{0, 0.025f, -0.1f}, {0.025f, 0.025f, 0.025f}, 8), dark);
    }
    k.rod(metal, {0, 0.06f, -0.1f}, {0, 1.78f, -0.1f}, 0.013f, -1, 8),
        k.rod(metal, {0, 1.78f, -0.1f}, {0, 1.76f, 0}, 0.009f, -1, 6);
    const std::array<Limb, 4> skull{Limb{{0, 1.68f, -0.025f}, {0, 1.67f, 0.02f}, 0.078f, 0.072f},
                                    {{0, 1.63f, 0.04f}, {0, 1.595f, 0.052f}, 0.045f, 0.032f},
                                    {{-0.04f, 1.62f, 0.0f}, {-0.015f, 1.565f, 0.06f}, 0.018f, 0.016f},
                                    {{0.04f, 1.62f, 0.0f}, {0.015f, 1.565f, 0.06f}, 0.018f, 0.016f}};
    k.add(shapes::skin(skull, 0.02f, 0.014f), bone);
    for (const float sx : {-1.f, 1.f})
        k.add(shapes::ball({sx * 0.03f, 1.652f, 0.076f}, {0.019f, 0.018f, 0.014f}, 10), dark);
    k.add(shapes::ball({0, 1.618f, 0.084f}, {0.009f, 0.015f, 0.008f}, 8), dark),
        block(k, dark, {0, 1.578f, 0.08f}, {0.045f, 0.005f, 0.01f});
    for (int i = 0; i < 17; ++i)
        block(k, bone,
              {0, 0.99f + 0.034f * static_cast<float>(i), -0.045f + 0.022f * std::sin(0.5f * static_cast<float>(i))},
              {0.038f, 0.026f, 0.038f});
    for (int i = 0; i < 9; ++i) {
        const float y = 1.18f + 0.034f * static_cast<float>(i), u = static_cast<float>(i) / 8,
                    w = 0.145f - 0.07f * u * u;
        for (const float sx : {-1.f, 1.f}) {
            std::vector<Vec3f> rib;
            for (int j = 0; j <= 6; ++j) {
                const float a = kPi * static_cast<float>(j) / 6 * (i < 2 ? 0.75f : 0.95f);
                rib.push_back({sx * (0.012f + w * std::sin(a)), y + 0.015f - 0.05f * static_cast<float>(j) / 6,
                               0.025f - 0.085f * std::cos(a)});
            }
            k.add(shapes::tube(rib, 0.006f, 5), bone);
        }
    }
    block(k, bone, {0, 1.2f, 0.106f}, {0.035f, 0.2f, 0.014f});
    for (const float sx : {-1.f, 1.f}) {
        k.rod(bone, {sx * 0.015f, 1.44f, 0.075f}, {sx * 0.175f, 1.46f, -0.01f}, 0.009f, -1, 6),
            slat(k, bone, {sx * 0.1f, 1.43f, -0.075f}, {sx * 0.07f, 1.3f, -0.08f}, 0.075f, 0.008f);
        const Vec3f shoulder{sx * 0.185f, 1.44f, -0.01f}, elbow{sx * 0.215f, 1.15f, -0.02f},
            wrist{sx * 0.235f, 0.9f, 0.03f}, hip{sx * 0.1f, 0.93f, 0}, knee{sx * 0.09f, 0.52f, 0.02f},
            ankle{sx * 0.085f, 0.13f, -0.005f};
        const auto long_bone = [&](Vec3f a, Vec3f b, float r) {
            k.rod(bone, a, b, r, -1, 6), k.add(shapes::ball(a, Vec3f{1, 1, 1} * (1.7f * r), 8), bone),
                k.add(shapes::ball(b, Vec3f{1, 1, 1} * (1.7f * r), 8), bone);
        };
        long_bone(shoulder, elbow, 0.012f), long_bone(hip, knee, 0.015f);
        for (const float e : {-0.012f, 0.012f})
            k.rod(bone, elbow + Vec3f{e, 0, 0}, wrist + Vec3f{e, 0, 0}, 0.007f, -1, 6),
                k.rod(bone, knee + Vec3f{e * 1.2f, -0.02f, 0}, ankle + Vec3f{e * 1.2f, 0, 0}, e > 0 ? 0.011f : 0.007f,
                      -1, 6);
        k.add(shapes::ball(wrist, {0.022f, 0.018f, 0.014f}, 8), bone);
        for (int f = 0; f < 5; ++f)
            k.rod(bone, wrist + Vec3f{0.009f * static_cast<float>(f - 2), -0.015f, 0},
                  wrist + Vec3f{0.016f * static_cast<float>(f - 2), f == 0 || f == 4 ? -0.13f : -0.17f, 0.02f}, 0.0045f,
                  -1, 5),
                k.rod(bone, ankle + Vec3f{0.006f * static_cast<float>(f - 2), -0.03f, 0.02f},
                      ankle + Vec3f{0.015f * static_cast<float>(f - 2), -0.065f, 0.17f}, 0.006f, -1, 5);
        k.add(shapes::ball(ankle + Vec3f{0, -0.03f, -0.02f}, {0.025f, 0.03f, 0.04f}, 8), bone);
        Mesh wing = shapes::ball({}, {0.075f, 0.075f, 0.022f}, 12);
        shapes::turn(wing, {0, 1, 0}, sx * 35), k.add(std::move(wing), bone, {sx * 0.072f, 1.0f, -0.015f});
    }
    k.add(shapes::ring(0.05f, 0.014f, 16), bone, {0, 0.925f, 0});
    k.piece.clearance_front_m = 0.3f;
}

}  // namespace fastscene::furniture
