// Of halls, gardens and museums: a fountain, a statue, the skeleton of a dinosaur.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// A round basin with two bowls on a stem, water falling from each into the next.
void build_fountain(Kit& k) {
    const int stone = k.main(*material_named("stone")), water = color(k, "water", {0.12f, 0.22f, 0.25f}, 0.04f),
              spray = color(k, "falling water", {0.62f, 0.7f, 0.73f}, 0.08f);
    k.add(shapes::prism(shapes::circle(1.15f, 8), 0, 0.08f, 0.01f), stone);
    const std::array<Vec2f, 6> basin{Vec2f{1.0f, 0.06f}, {0.96f, 0.12f}, {0.94f, 0.38f},
                                     {1.0f, 0.42f},      {1.05f, 0.44f}, {1.05f, 0.5f}};
    k.add(shapes::vessel(basin, 0.13f, 32), stone);
    const std::array<Vec2f, 9> stem{Vec2f{0.26f, 0.1f}, {0.26f, 0.42f}, {0.14f, 0.5f},  {0.11f, 0.7f}, {0.16f, 0.85f},
                                    {0.08f, 1.0f},      {0.07f, 1.35f}, {0.09f, 1.42f}, {0.03f, 1.6f}};
    k.add(shapes::lathe(stem, 20, true), stone);
    k.add(shapes::prism(shapes::circle(0.91f, 32), 0.38f, 0.42f, 0.002f), water);
    const auto tier = [&](float y, float r, float down) {
        const std::array<Vec2f, 5> bowl{
            Vec2f{0.08f, y - 0.2f * r}, {0.5f * r, y - 0.14f * r}, {0.9f * r, y}, {r, y + 0.03f}, {r, y + 0.06f}};
        k.add(shapes::vessel(bowl, 0.035f, 28), stone);
        k.add(shapes::prism(shapes::circle(r - 0.04f, 28), y + 0.02f, y + 0.045f, 0.002f), water);
        for (int i = 0; i < 14; ++i) {
            const Vec3f out = around(kTau * (static_cast<float>(i) + k.rng.uniform(-0.2f, 0.2f)) / 14);
            std::vector<Vec3f> path;
            for (int j = 0; j <= 5; ++j) {
                const float t = static_cast<float>(j) / 5;
                path.push_back(out * (r - 0.02f + 0.09f * t) + Vec3f{0, y + 0.07f - (y + 0.07f - down) * t * t, 0});
            }
            k.add(shapes::tube(path, 0.007f, 5), spray);
        }
    };
    tier(0.95f, 0.58f, 0.42f), tier(1.4f, 0.32f, 0.97f);
    for (int i = 0; i < 6; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / 6);
        std::vector<Vec3f> path;
        for (int j = 0; j <= 6; ++j) {
            const float t = static_cast<float>(j) / 6;
            path.push_back(out * (0.17f * t) + Vec3f{0, 1.58f + 0.8f * t - 0.98f * t * t, 0});
        }
        k.add(shapes::tube(path, 0.006f, 5), spray);
    }
    k.piece.clearance_front_m = 0.8f, k.piece.clearance_side_m = 0.5f;
}

namespace {

// Cloth that falls in folds about a body: radii by height, an inner one for depth.
Mesh statue_drapery(float y0, float y1, Vec2f low, Vec2f high, float fold, float phase) {
    return shapes::sheet(45, 8, [=](float u, float v) {
        const float a = -kTau * u, w = 1 + fold * (1 - 0.5f * v) * std::sin(9 * a + phase + 1.2f * std::sin(2.f * v)),
                    rx = low.x + (high.x - low.x) * v - 0.03f * std::sin(kPi * v),
                    rz = low.y + (high.y - low.y) * v - 0.02f * std::sin(kPi * v);
        return Vec3f{rx * w * std::cos(a), y0 + (y1 - y0) * v, rz * w * std::sin(a)};
    });
}
void statue_head(Kit& k, int stone, Vec3f at, float s, bool hair_up) {
    const auto p = [&](float x, float y, float z) { return at + Vec3f{x, y, z} * s; };
    const std::vector<Limb> head{{p(0, -0.16f, -0.02f), p(0, -0.05f, 0), 0.058f * s, 0.055f * s},
                                 {p(0, 0.03f, -0.015f), p(0, -0.055f, 0.035f), 0.088f * s, 0.055f * s},
                                 {p(0, 0.035f, 0.075f), p(0, -0.012f, 0.1f), 0.008f * s, 0.015f * s},
                                 {p(-0.035f, 0.04f, 0.064f), p(0.035f, 0.04f, 0.064f), 0.014f * s, 0.014f * s},
                                 {p(0, -0.045f, 0.085f), p(0, -0.045f, 0.083f), 0.014f * s, 0.014f * s}};
    k.add(shapes::skin(head, 0.012f * s, 0.019f * s), stone);
    for (int i = 0; i < 16; ++i) {
        const float a = k.rng.uniform(0.f, kTau), up = k.rng.uniform(0.1f, 0.95f);
        const Vec3f d{std::cos(a) * (1 - 0.5f * up), up, std::sin(a) * (1 - 0.5f * up) - 0.35f};
        k.add(shapes::ball(p(0, 0.03f, -0.015f) + normalize(d) * (0.08f * s), Vec3f{1, 1, 1} * (0.032f * s), 8), stone);
    }
    if (hair_up) k.add(shapes::ball(p(0, 0.05f, -0.11f), Vec3f{0.04f, 0.04f, 0.035f} * s, 10), stone);
}
void statue_bust(Kit& k, int stone, float y) {
    const std::array<Vec2f, 5> foot{
        Vec2f{0.12f, y}, {0.11f, y + 0.03f}, {0.05f, y + 0.07f}, {0.05f, y + 0.1f}, {0.08f, y + 0.13f}};
    k.add(shapes::lathe(foot, 18, true), stone);
    const std::vector<Limb> chest{{{0, y + 0.16f, 0.0f}, {0, y + 0.3f, 0}, 0.09f, 0.12f},
                                  {{-0.16f, y + 0.34f, -0.01f}, {0.16f, y + 0.34f, -0.01f}, 0.075f, 0.075f},
                                  {{-0.08f, y + 0.29f, 0.06f}, {0.08f, y + 0.29f, 0.06f}, 0.07f, 0.07f},
                                  {{0, y + 0.36f, 0}, {0, y + 0.46f, 0}, 0.075f, 0.06f}};
    k.add(shapes::skin(chest, 0.05f, 0.035f), stone);
    statue_head(k, stone, {0, y + 0.58f, 0.01f}, 1.05f, false);
}
void statue_pedestal(Kit& k, int stone, float wide, float high) {
    k.board(stone, {0, 0, 0}, {wide, 0.1f, wide}, 0.012f);
    k.board(stone, {0, 0.1f, 0}, {wide - 0.1f, high - 0.17f, wide - 0.1f}, 0.006f);
    k.board(stone, {0, high - 0.07f, 0}, {wide - 0.02f, 0.07f, wide - 0.02f}, 0.014f);
}

}  // namespace

// A standing figure in a long robe on a pedestal; with the pattern "bust" head and shoulders, with "buddha" one that
// sits.
void build_statue(Kit& k) {
    const int stone = k.main(*material_named("marble"), false);
    k.piece.clearance_front_m = 0.6f;
    if (k.request.pattern == "bust") {
        statue_pedestal(k, stone, 0.44f, 1.05f);
        statue_bust(k, stone, 1.05f);
        return;
    }
    if (k.request.pattern == "buddha") {
        statue_pedestal(k, stone, 0.95f, 0.3f);
        const float y = 0.3f;
        for (int i = 0; i < 14; ++i)
            k.add(shapes::ball(around(kTau * static_cast<float>(i) / 14) * 0.38f + Vec3f{0, y + 0.05f, 0},
                               {0.085f, 0.06f, 0.085f}, 10),
                  stone);
        std::vector<Limb> body{{{0, y + 0.2f, -0.04f}, {0, y + 0.5f, -0.05f}, 0.19f, 0.15f},
                               {{-0.17f, y + 0.6f, -0.05f}, {0.17f, y + 0.6f, -0.05f}, 0.09f, 0.09f},
                               {{0, y + 0.62f, -0.04f}, {0, y + 0.76f, -0.02f}, 0.07f, 0.06f}};
        for (const float sx : {-1.f, 1.f}) {
            body.push_back({{sx * 0.14f, y + 0.17f, 0}, {sx * 0.36f, y + 0.16f, 0.1f}, 0.11f, 0.09f});
            body.push_back({{sx * 0.36f, y + 0.15f, 0.12f}, {-sx * 0.08f, y + 0.15f, 0.24f}, 0.085f, 0.065f});
            body.push_back({{sx * 0.25f, y + 0.58f, -0.05f}, {sx * 0.28f, y + 0.36f, 0.02f}, 0.07f, 0.06f});
            body.push_back({{sx * 0.28f, y + 0.36f, 0.02f}, {sx * 0.05f, y + 0.27f, 0.2f}, 0.058f, 0.045f});
        }
        k.add(shapes::skin(body, 0.04f, 0.048f), stone);
        statue_head(k, stone, {0, y + 0.87f, -0.01f}, 1.15f, false);
        k.add(shapes::ball({0, y + 1.0f, -0.03f}, {0.045f, 0.05f, 0.045f}, 10), stone);
        return;
    }
    const float y = 0.55f;
    statue_pedestal(k, stone, 0.7f, y);
    const float side = k.rng.chance(0.5f) ? 1.f : -1.f;
    k.add(shapes::prism(shapes::circle(0.28f, 20), y, y + 0.05f, 0.01f), stone);
    k.add(statue_drapery(y + 0.04f, y + 1.02f, {0.25f, 0.21f}, {0.175f, 0.135f}, 0.13f, 0.4f), stone);
    k.add(statue_drapery(y + 0.78f, y + 1.1f, {0.22f, 0.18f}, {0.17f, 0.13f}, 0.09f, 2.f), stone);
    const std::vector<Limb> body{{{0, y + 0.95f, 0}, {0, y + 1.2f, -0.01f}, 0.13f, 0.125f},
                                 {{0, y + 1.2f, 0}, {0, y + 1.36f, 0}, 0.125f, 0.12f},
                                 {{-0.15f, y + 1.42f, -0.01f}, {0.15f, y + 1.42f, -0.01f}, 0.07f, 0.07f},
                                 {{-0.07f, y + 1.3f, 0.07f}, {0.07f, y + 1.3f, 0.07f}, 0.07f, 0.07f},
                                 {{0, y + 1.42f, 0}, {0, y + 1.55f, 0.01f}, 0.065f, 0.055f},
                                 {{side * 0.19f, y + 1.42f, 0}, {side * 0.27f, y + 1.15f, 0.02f}, 0.06f, 0.048f},
                                 {{side * 0.27f, y + 1.15f, 0.02f}, {side * 0.22f, y + 0.98f, 0.2f}, 0.046f, 0.032f},
                                 {{-side * 0.19f, y + 1.42f, 0}, {-side * 0.3f, y + 1.17f, -0.03f}, 0.06f, 0.048f},
                                 {{-side * 0.3f, y + 1.17f, -0.03f}, {-side * 0.27f, y + 0.93f, 0.06f}, 0.046f, 0.034f},
                                 {{side * 0.13f, y + 1.45f, 0.05f}, {-side * 0.15f, y + 1.06f, 0.09f}, 0.05f, 0.06f},
                                 {{side * 0.13f, y + 1.45f, -0.06f}, {-side * 0.15f, y + 1.06f, -0.09f}, 0.05f, 0.06f}};
    k.add(shapes::skin(body, 0.025f, 0.042f), stone);
    for (const float sx : {-1.f, 1.f})
        k.add(shapes::ball({sx * 0.09f, y + 0.07f, 0.2f}, {0.045f, 0.03f, 0.09f}, 10), stone);
    statue_head(k, stone, {0, y + 1.68f, 0.02f}, 1.f, true);
}

// One that walked on two legs, five metres long, on a low base with steel posts.
void build_dinosaur_skeleton(Kit& k) {
    const int bone = k.main(plain("fossil bone", {0.36f, 0.27f, 0.17f}, 0.7f)),
              dark = color(k, "eye socket", {0.03f, 0.025f, 0.02f}, 0.9f),
              base = color(k, "base", {0.05f, 0.05f, 0.055f}, 0.5f), metal = k.material(steel()),
              sign = color(k, "label", {0.72f, 0.7f, 0.64f}, 0.5f);
    k.board(base, {0, 0, 0}, {4.7f, 0.16f, 1.35f}, 0.015f);
    Mesh label = shapes::box({0.5f, 0.02f, 0.22f}, 0.003f);
    shapes::turn(label, {1, 0, 0}, 35);
    k.add(std::move(label), sign, {1.1f, 0.24f, 0.56f});
    const std::vector<Vec3f> spine{{-2.5f, 1.35f, 0}, {-2.0f, 1.3f, 0}, {-1.4f, 1.4f, 0}, {-0.8f, 1.62f, 0},
                                   {-0.3f, 1.78f, 0}, {0.2f, 1.84f, 0}, {0.7f, 1.86f, 0}, {1.05f, 1.98f, 0},
                                   {1.25f, 2.2f, 0},  {1.45f, 2.42f, 0}};
    const auto at = [&](float t) {
        const float x = t * static_cast<float>(spine.size() - 1);
        const std::size_t i = std::min(static_cast<std::size_t>(x), spine.size() - 2);
        return lerp(spine[i], spine[i + 1], x - static_cast<float>(i));
    };
    constexpr int kBones = 44;
    for (int i = 0; i < kBones; ++i) {
        const float t = (static_cast<float>(i) + 0.5f) / kBones, thick = 0.018f + 0.055f * std::min(1.f, t * 1.7f);
        const Vec3f a = at(t - 0.4f / kBones), b = at(t + 0.4f / kBones), mid = (a + b) * 0.5f,
                    along = normalize(b - a), up{-along.y, along.x, 0};
        k.rod(bone, a, b, thick, thick * 0.9f, 7);
        k.rod(bone, mid, mid + up * (0.06f + 2.2f * thick), 0.5f * thick, 0.25f * thick, 4);
        if (t < 0.42f) k.rod(bone, mid, mid - up * (0.03f + 2.f * thick), 0.3f * thick, 0.2f * thick, 4);
    }
    for (int i = 0; i < 9; ++i) {
        const float t = 0.53f + 0.028f * static_cast<float>(i),
                    r = 0.34f - 0.012f * std::abs(static_cast<float>(i) - 5),
                    deep = 0.52f + 0.03f * static_cast<float>(i);
        const Vec3f top = at(t);
        for (const float sz : {-1.f, 1.f}) {
            std::vector<Vec3f> rib;
            for (int j = 0; j <= 6; ++j) {
                const float a = kPi * 0.88f * static_cast<float>(j) / 6;
                rib.push_back(top + Vec3f{0.22f * static_cast<float>(j) / 6 - 0.12f, -0.5f * deep * (1 - std::cos(a)),
                                          sz * r * std::sin(a)});
            }
            k.add(shapes::tube(rib, 0.017f, 5), bone);
        }
    }
    for (const float sz : {-1.f, 1.f}) {
        const float step = sz > 0 ? 0.28f : -0.22f, z = sz * 0.2f;
        const Vec3f hip{-0.25f, 1.6f, z}, knee{-0.02f + 0.6f * step, 1.05f, sz * 0.27f},
            heel{-0.3f + step, 0.52f, sz * 0.27f}, foot{-0.12f + step, 0.2f, sz * 0.27f};
        const auto limb_bone = [&](Vec3f a, Vec3f b, float r) {
            k.rod(bone, a, b, r, 0.8f * r, 8);
            for (const Vec3f& p : {a, b}) k.add(shapes::ball(p, Vec3f{1.5f, 1.5f, 1.5f} * r, 8), bone);
        };
        limb_bone(hip, knee, 0.062f), limb_bone(knee, heel, 0.05f), limb_bone(heel, foot, 0.042f);
        for (int t = -1; t <= 1; ++t)
            k.rod(bone, foot,
                  foot + Vec3f{0.3f - 0.04f * std::abs(static_cast<float>(t)), -0.02f, 0.11f * static_cast<float>(t)},
                  0.032f, 0.012f, 6);
        k.rod(bone, hip, {0.1f, 1.72f, z * 0.6f}, 0.05f, 0.03f, 6),
            k.rod(bone, hip, {-0.6f, 1.66f, z * 0.6f}, 0.05f, 0.03f, 6);
        k.rod(bone, hip, {0.08f, 1.2f, 0.02f}, 0.035f, 0.05f, 6),
            k.rod(bone, hip, {-0.55f, 1.2f, 0.02f}, 0.035f, 0.03f, 6);
        const Vec3f shoulder{0.95f, 1.5f, sz * 0.28f}, elbow{0.92f, 1.25f, sz * 0.34f}, hand{1.12f, 1.16f, sz * 0.3f};
        k.rod(bone, at(0.76f), shoulder, 0.02f, 0.03f, 6);
        k.rod(bone, shoulder, elbow, 0.027f, 0.022f, 6), k.rod(bone, elbow, hand, 0.02f, 0.016f, 6);
        for (const float d : {-0.03f, 0.03f}) k.rod(bone, hand, hand + Vec3f{0.08f, -0.06f, d}, 0.014f, 0.004f, 5);
    }
    // The skull, its jaws open.
    const std::vector<Limb> upper{{{1.5f, 2.5f, 0}, {1.72f, 2.52f, 0}, 0.16f, 0.15f},
                                  {{1.6f, 2.5f, -0.1f}, {2.35f, 2.38f, -0.05f}, 0.1f, 0.07f},
                                  {{1.6f, 2.5f, 0.1f}, {2.35f, 2.38f, 0.05f}, 0.1f, 0.07f}};
    k.add(shapes::skin(upper, 0.05f, 0.065f), bone);
    const std::vector<Limb> jaw{{{1.55f, 2.36f, -0.13f}, {2.2f, 2.08f, -0.05f}, 0.06f, 0.045f},
                                {{1.55f, 2.36f, 0.13f}, {2.2f, 2.08f, 0.05f}, 0.06f, 0.045f}};
    k.add(shapes::skin(jaw, 0.03f, 0.06f), bone);
    for (const float sz : {-1.f, 1.f}) {
        k.add(shapes::ball({1.68f, 2.55f, sz * 0.155f}, {0.06f, 0.055f, 0.045f}, 10), dark);
        k.add(shapes::ball({1.95f, 2.48f, sz * 0.13f}, {0.085f, 0.045f, 0.03f}, 10), dark);
        for (int i = 0; i < 9; ++i) {
            const float x = 1.78f + 0.066f * static_cast<float>(i), f = static_cast<float>(i) / 8;
            const Vec3f top{x, 2.36f - 0.04f * f, sz * (0.13f - 0.05f * f)},
                low{x - 0.06f, 2.3f - 0.2f * f - 0.02f, sz * (0.12f - 0.06f * f)};
            k.rod(sign, top, top + Vec3f{0, -0.1f, 0}, 0.017f, 0.002f, 5),
                k.rod(sign, low, low + Vec3f{0.01f, 0.08f, 0}, 0.014f, 0.002f, 5);
        }
    }
    for (const float x : {-1.3f, 0.75f}) k.rod(metal, {x, 0.15f, 0}, {x, x < 0 ? 1.4f : 1.82f, 0}, 0.02f, -1, 8);
    k.piece.clearance_front_m = 1.f;
}

}  // namespace fastscene::furniture
