// Old things: armor, swords, a coffin, a treasure chest, a skull, a censer, a hookah, a lantern of stone, a spinning
// wheel, a confessional.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// Plates of steel standing on a wooden base, the hands on a sword.
void build_suit_of_armor(Kit& k) {
    const int plate = k.main(steel(), false), dark = color(k, "mail", {0.06f, 0.06f, 0.065f}, 0.5f),
              wood = k.material(k.style.wood2), brass = k.material(*material_named("brass")),
              red = color(k, "plume", {0.5f, 0.03f, 0.03f}, 0.9f);
    k.add(shapes::prism(shapes::circle(0.36f, 8), 0, 0.09f, 0.01f), wood);
    const float y = 0.09f;
    const auto turned = [&](std::initializer_list<Vec2f> p, Vec3f at, Vec3f squash, int mat) {
        const std::vector<Vec2f> profile(p);
        Mesh m = shapes::lathe(profile, 16, true);
        for (Vec3f& v : m.positions) v = v * squash;
        k.add(std::move(m), mat, at);
    };
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.12f;
        k.add(shapes::ball({x, y + 0.04f, 0.06f}, {0.05f, 0.045f, 0.13f}, 12), plate);
        turned({{0.05f, 0.03f}, {0.06f, 0.1f}, {0.07f, 0.3f}, {0.055f, 0.44f}}, {x, y, 0}, {1, 1, 1}, plate);
        k.add(shapes::ball({x, y + 0.47f, 0.01f}, {0.068f, 0.06f, 0.07f}, 12), plate),
            turned({{0.065f, 0.5f}, {0.085f, 0.65f}, {0.095f, 0.85f}, {0.07f, 0.9f}}, {x, y, 0}, {1, 1, 1}, plate);
        k.add(shapes::ring(0.075f, 0.008f, 14), brass, {x, y + 0.53f, 0});
        k.add(shapes::ball({sx * 0.25f, y + 1.38f, 0}, {0.1f, 0.085f, 0.1f}, 14), plate);
        k.rod(plate, {sx * 0.27f, y + 1.33f, 0}, {sx * 0.31f, y + 1.08f, 0.04f}, 0.055f, 0.05f, 12),
            k.add(shapes::ball({sx * 0.31f, y + 1.06f, 0.04f}, {0.058f, 0.055f, 0.058f}, 12), plate);
        k.rod(plate, {sx * 0.31f, y + 1.05f, 0.05f}, {sx * 0.07f, y + 0.98f, 0.26f}, 0.048f, 0.04f, 12),
            k.rod(plate, {sx * 0.14f, y + 1.0f, 0.2f}, {sx * 0.07f, y + 0.98f, 0.26f}, 0.058f, 0.045f, 12);
        k.add(shapes::ball({sx * 0.035f, y + 0.97f, 0.28f}, {0.045f, 0.05f, 0.045f}, 10), dark);
    }
    turned({{0.15f, 0.82f}, {0.17f, 0.86f}, {0.2f, 0.82f}, {0.19f, 0.9f}, {0.15f, 1.02f}}, {0, y, 0}, {1.05f, 1, 0.8f},
           dark);
    turned(
        {{0.2f, 0.84f}, {0.18f, 0.94f}, {0.15f, 1.03f}, {0.2f, 1.2f}, {0.22f, 1.33f}, {0.16f, 1.44f}, {0.08f, 1.48f}},
        {0, y, 0}, {1.05f, 1, 0.8f}, plate);
    k.add(shapes::ring(0.155f, 0.012f, 20), brass, {0, y + 1.03f, 0}),
        k.board(plate, {0, y + 1.1f, 0.17f}, {0.01f, 0.26f, 0.03f}, 0.004f);
    turned({{0.07f, 1.44f}, {0.1f, 1.5f}, {0.105f, 1.6f}, {0.1f, 1.68f}, {0.06f, 1.76f}, {0, 1.78f}}, {0, y, 0},
           {0.95f, 1, 1.12f}, plate);
    k.board(dark, {0, y + 1.605f, 0.1f}, {0.14f, 0.014f, 0.03f}, 0.003f),
        k.board(plate, {0, y + 1.47f, 0.112f}, {0.014f, 0.29f, 0.016f}, 0.005f);
    for (int i = 0; i < 8; ++i)
        k.rod(dark, {-0.045f + 0.013f * static_cast<float>(i), y + 1.54f, 0.1f},
              {-0.045f + 0.013f * static_cast<float>(i), y + 1.54f, 0.118f}, 0.004f, -1, 5);
    for (int i = 0; i < 7; ++i)
        k.add(shapes::ball({0, y + 1.8f + 0.035f * std::sin(0.5f * static_cast<float>(i)),
                            0.03f - 0.04f * static_cast<float>(i)},
                           {0.022f, 0.045f, 0.03f}, 8),
              red);
    k.board(plate, {0, y, 0.3f}, {0.045f, 0.9f, 0.01f}, 0.004f),
        k.board(brass, {0, y + 0.9f, 0.3f}, {0.24f, 0.025f, 0.025f}, 0.006f),
        k.rod(dark, {0, y + 0.92f, 0.3f}, {0, y + 1.08f, 0.3f}, 0.016f, -1, 8),
        k.add(shapes::ball({0, y + 1.1f, 0.3f}, {0.028f, 0.028f, 0.028f}, 10), brass);
    k.piece.clearance_front_m = 0.4f;
}

// Two, crossed behind a small shield.
void build_sword(Kit& k) {
    const int blade = k.material(steel()), shield = k.main(plain("shield", {0.35f, 0.03f, 0.04f}, 0.4f)),
              brass = k.material(*material_named("brass")), grip = color(k, "grip", {0.08f, 0.04f, 0.025f}, 0.7f);
    for (const float s : {-1.f, 1.f}) {
        const float z = s > 0 ? 0.022f : 0.034f;
        const auto part = [&](Mesh m, int mat, float along) {
            shapes::move(m, {0, along, 0}), shapes::turn(m, {0, 0, 1}, s * 40), k.add(std::move(m), mat, {0, 0.42f, z});
        };
        part(shapes::prism(
                 std::vector<Vec2f>{{-0.022f, 0.005f}, {0.022f, 0.005f}, {0.022f, -0.005f}, {-0.022f, -0.005f}}, -0.3f,
                 0.42f, 0.002f),
             blade, 0.1f);
        part(shapes::rod({0, 0, 0}, {0, 0.08f, 0}, 0.02f, 0.001f, 6), blade, 0.52f),
            part(shapes::box({0.2f, 0.025f, 0.022f}, 0.006f), brass, -0.21f);
        part(shapes::rod({0, 0, 0}, {0, 0.13f, 0}, 0.013f, 0.015f, 8), grip, -0.35f),
            part(shapes::ball({0, 0, 0}, {0.024f, 0.024f, 0.02f}, 10), brass, -0.37f);
    }
    std::vector<Vec2f> o{{-0.16f, -0.17f}, {0.16f, -0.17f}, {0.16f, 0.0f},  {0.13f, 0.1f}, {0.07f, 0.17f},
                         {0, 0.21f},       {-0.07f, 0.17f}, {-0.13f, 0.1f}, {-0.16f, 0.0f}};
    std::vector<Vec2f> ccw(o.rbegin(), o.rend()), small;
    for (const Vec2f& p : ccw) small.push_back(p * 0.86f);
    for (const auto& [outline, t, mat] : {std::tuple{&ccw, 0.0f, brass}, std::tuple{&small, 0.008f, shield}}) {
        Mesh m = shapes::prism(*outline, 0, 0.02f, 0.004f);
        shapes::turn(m, {1, 0, 0}, 90);
        if (shapes::signed_volume(m) < 0)
            for (std::size_t i = 0; i + 2 < m.triangles.size(); i += 3) std::swap(m.triangles[i], m.triangles[i + 1]);
        const shapes::Box b = shapes::bounds(m);
        k.add(std::move(m), mat, {0, 0.42f, 0.045f + t - b.low.z});
    }
    k.board(brass, {0, 0.28f, 0.073f}, {0.03f, 0.28f, 0.006f}, 0.002f),
        k.board(brass, {0, 0.44f, 0.073f}, {0.24f, 0.03f, 0.006f}, 0.002f);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.4f;
}

namespace {

// A body with straight sides, widest at the shoulders.
std::vector<Vec2f> coffin_outline(float grow) {
    std::vector<Vec2f> o{{-0.24f, 1.0f}, {0.24f, 1.0f},   {0.36f, -0.45f},
                         {0.22f, -1.0f}, {-0.22f, -1.0f}, {-0.36f, -0.45f}};
    std::vector<Vec2f> ccw(o.begin(), o.end());
    for (Vec2f& p : ccw) p = {p.x + (p.x > 0 ? grow : -grow), p.y + (p.y > 0 ? grow : -grow)};
    return ccw;
}

}  // namespace

void build_coffin(Kit& k) {
    const int wood = k.main(k.style.wood2), brass = k.material(*material_named("brass"));
    const auto put = [&](float grow, float y0, float y1, float bevel, int mat) {
        auto o = coffin_outline(grow);
        Mesh m = shapes::prism(o, y0, y1, bevel);
        if (shapes::signed_volume(m) < 0) m = shapes::prism(std::vector<Vec2f>(o.rbegin(), o.rend()), y0, y1, bevel);
        k.add(std::move(m), mat);
    };
    put(-0.02f, 0.06f, 0.38f, 0.006f, wood), put(0.01f, 0.04f, 0.09f, 0.012f, wood),
        put(0.015f, 0.38f, 0.43f, 0.015f, wood), put(-0.07f, 0.43f, 0.48f, 0.03f, wood);
    for (const float z : {-0.7f, 0.7f}) k.board(wood, {0, 0, z}, {0.44f, 0.05f, 0.08f}, 0.006f);
    for (const float sx : {-1.f, 1.f})
        for (const float z : {-0.15f, 0.3f, 0.7f}) {
            const float x = sx * (0.36f - 0.12f * (z + 0.45f) / 1.45f + 0.005f);
            k.rod(brass, {x, 0.24f, z - 0.08f}, {x, 0.24f, z + 0.08f}, 0.011f, -1, 8);
            for (const float dz : {-0.07f, 0.07f})
                k.add(shapes::ball({x - sx * 0.01f, 0.25f, z + dz}, {0.02f, 0.02f, 0.015f}, 8), brass);
        }
    k.board(brass, {0, 0.48f, -0.35f}, {0.035f, 0.008f, 0.5f}, 0.003f),
        k.board(brass, {0, 0.48f, -0.45f}, {0.24f, 0.008f, 0.035f}, 0.003f);
}

// Its vaulted lid open above coins, cups and gems.
void build_treasure_chest(Kit& k) {
    const int wood = k.main(k.style.wood2), iron = k.material(*material_named("iron")),
              gold = k.material(*material_named("gold")), ruby = color(k, "ruby", {0.55f, 0.02f, 0.04f}, 0.08f),
              jade = color(k, "emerald", {0.02f, 0.4f, 0.12f}, 0.08f);
    const float w = 0.85f, d = 0.5f, h = 0.38f;
    for (const float sz : {-1.f, 1.f})
        k.board(wood, {0, 0.02f, sz * (0.5f * d - 0.015f)}, {w, h - 0.02f, 0.03f}, 0.004f);
    for (const float sx : {-1.f, 1.f})
        k.board(wood, {sx * (0.5f * w - 0.015f), 0.02f, 0}, {0.03f, h - 0.02f, d - 0.06f}, 0.004f),
            k.rod(iron, {sx * (0.5f * w + 0.02f), 0.22f, -0.07f}, {sx * (0.5f * w + 0.02f), 0.22f, 0.07f}, 0.012f, -1,
                  8);
    k.board(wood, {0, 0.02f, 0}, {w - 0.04f, 0.22f, d - 0.04f}, 0.002f);
    const auto lid = [&](float grow, float x0, float x1, int mat) {
        k.add(shapes::slab(1, 10, 0.025f,
                           [&](float u, float v) {
                               const float a = kPi * v, r = 0.5f * d + grow;
                               Vec3f p{x0 + (x1 - x0) * u, 0.55f * r * std::sin(a), r * std::cos(a)};
                               const float c = std::cos(1.35f), s = std::sin(1.35f), z = p.z + 0.5f * d;
                               return Vec3f{p.x, h + p.y * c + z * s, -0.5f * d - p.y * s + z * c};
                           }),
              mat);
    };
    lid(0, -0.5f * w, 0.5f * w, wood);
    for (const float x : {-0.3f, 0.f, 0.3f}) {
        k.board(iron, {x, 0.02f, 0}, {0.05f, h - 0.015f, d + 0.008f}, 0.002f),
            lid(0.006f, x - 0.025f, x + 0.025f, iron);
    }
    k.board(iron, {0, 0.22f, 0.5f * d + 0.006f}, {0.12f, 0.13f, 0.02f}, 0.006f);
    for (int i = 0; i < 70; ++i) {
        const float x = k.rng.uniform(-0.37f, 0.37f), z = k.rng.uniform(-0.19f, 0.19f),
                    up = 0.14f * (1 - (x * x) / 0.16f) * (1 - (z * z) / 0.07f);
        Mesh coin = shapes::lathe(std::array<Vec2f, 2>{Vec2f{0.022f, 0}, {0.022f, 0.005f}}, 9);
        shapes::turn(coin, around(k.rng.uniform(0.f, kTau)), k.rng.uniform(-40.f, 40.f)),
            k.add(std::move(coin), gold, {x, 0.28f + up + k.rng.uniform(0.f, 0.02f), z});
    }
    k.add(shapes::ball({0, 0.24f, 0}, {0.4f, 0.17f, 0.21f}, 18), gold);
    for (int i = 0; i < 8; ++i)
        k.add(shapes::ball({k.rng.uniform(-0.3f, 0.3f), 0.38f, k.rng.uniform(-0.12f, 0.14f)}, {0.02f, 0.02f, 0.02f}, 6),
              i % 2 ? ruby : jade);
    k.add(shapes::vessel(
              std::array<Vec2f, 6>{
                  Vec2f{0.05f, 0}, {0.015f, 0.02f}, {0.015f, 0.07f}, {0.05f, 0.1f}, {0.06f, 0.15f}, {0.062f, 0.17f}},
              0.005f, 14),
          gold, {-0.2f, 0.36f, 0.02f});
    k.piece.clearance_front_m = 0.4f;
}

void build_skull(Kit& k) {
    const int bone = k.main(plain("bone", {0.6f, 0.54f, 0.42f}, 0.6f)),
              dark = color(k, "socket", {0.02f, 0.016f, 0.014f}, 0.95f),
              teeth = color(k, "teeth", {0.66f, 0.61f, 0.48f}, 0.4f);
    const std::vector<Limb> head{{{0, 0.118f, -0.025f}, {0, 0.112f, 0.015f}, 0.066f, 0.062f},
                                 {{-0.036f, 0.072f, 0.045f}, {0.036f, 0.072f, 0.045f}, 0.02f, 0.02f},
                                 {{0, 0.075f, 0.05f}, {0, 0.045f, 0.06f}, 0.03f, 0.024f},
                                 {{-0.032f, 0.05f, 0.0f}, {-0.014f, 0.012f, 0.062f}, 0.012f, 0.012f},
                                 {{0.032f, 0.05f, 0.0f}, {0.014f, 0.012f, 0.062f}, 0.012f, 0.012f},
                                 {{-0.014f, 0.012f, 0.062f}, {0.014f, 0.012f, 0.062f}, 0.013f, 0.013f}};
    k.add(shapes::skin(head, 0.012f, 0.019f), bone);
    for (const float s : {-1.f, 1.f})
        k.add(shapes::ball({s * 0.028f, 0.1f, 0.057f}, {0.018f, 0.016f, 0.015f}, 10), dark);
    k.add(shapes::ball({0, 0.074f, 0.08f}, {0.009f, 0.014f, 0.008f}, 8), dark),
        k.board(dark, {0, 0.031f, 0.064f}, {0.044f, 0.008f, 0.022f}, 0.001f);
    for (int i = 0; i < 6; ++i)
        for (const float y : {0.036f, 0.022f})
            block(
                k, teeth,
                {0.0078f * (static_cast<float>(i) - 2.5f), y, 0.072f - 0.001f * std::abs(static_cast<float>(i) - 2.5f)},
                {0.0068f, 0.012f, 0.008f});
    on_surface(k);
}

// A pierced bowl on three feet.
void build_incense_burner(Kit& k) {
    const int bronze = k.main(*material_named("brass"), false), dark = color(k, "holes", {0.02f, 0.02f, 0.02f}, 0.9f),
              wood = color(k, "incense sticks", {0.25f, 0.12f, 0.06f}, 0.9f),
              ember = k.material(flame("ember", {5.f, 1.2f, 0.15f}));
    for (int i = 0; i < 3; ++i) {
        const Vec3f d = around(kTau * (static_cast<float>(i) + 0.25f) / 3);
        k.rod(bronze, d * 0.06f, d * 0.05f + Vec3f{0, 0.05f, 0}, 0.009f, 0.014f, 8);
    }
    k.add(shapes::vessel(std::array<Vec2f, 6>{Vec2f{0.035f, 0.035f},
                                              {0.07f, 0.05f},
                                              {0.085f, 0.085f},
                                              {0.075f, 0.115f},
                                              {0.065f, 0.125f},
                                              {0.075f, 0.135f}},
                         0.006f, 22),
          bronze);
    k.add(shapes::prism(shapes::circle(0.062f, 20), 0.1f, 0.12f, 0.002f),
          color(k, "ash", {0.45f, 0.44f, 0.42f}, 0.95f));
    for (const float s : {-1.f, 1.f}) {
        Mesh ring = shapes::ring(0.022f, 0.006f, 12);
        shapes::turn(ring, {1, 0, 0}, 90), k.add(std::move(ring), bronze, {s * 0.1f, 0.1f, 0});
    }
    for (int i = 0; i < 8; ++i) {
        const Vec3f d = around(kTau * static_cast<float>(i) / 8);
        k.add(shapes::ball(d * 0.082f + Vec3f{0, 0.08f, 0}, {0.008f, 0.012f, 0.008f}, 6), dark);
    }
    for (int i = 0; i < 3; ++i) {
        const Vec3f foot = around(2.1f * static_cast<float>(i)) * 0.015f + Vec3f{0, 0.12f, 0},
                    tip = foot + Vec3f{0.03f * (static_cast<float>(i) - 1), 0.16f, 0.01f};
        k.rod(wood, foot, tip, 0.0022f, -1, 5), k.add(shapes::ball(tip, {0.0032f, 0.005f, 0.0032f}, 6), ember);
    }
    on_surface(k);
}

void build_hookah(Kit& k) {
    Material flask = plain("colored glass", k.accent(), 0.06f);
    const int body = k.main(flask), brass = k.material(*material_named("brass")),
              hose = color(k, "hose", {0.25f, 0.03f, 0.05f}, 0.8f), clay = color(k, "bowl", {0.4f, 0.16f, 0.08f}, 0.7f),
              ember = k.material(flame("coal", {5.f, 1.2f, 0.15f})),
              wood = color(k, "mouthpiece", {0.2f, 0.1f, 0.05f}, 0.4f);
    k.add(shapes::lathe(std::array<Vec2f, 7>{Vec2f{0.075f, 0},
                                             {0.1f, 0.03f},
                                             {0.105f, 0.09f},
                                             {0.07f, 0.17f},
                                             {0.032f, 0.22f},
                                             {0.028f, 0.27f},
                                             {0.035f, 0.29f}},
                        22, true),
          body);
    k.add(shapes::lathe(std::array<Vec2f, 11>{Vec2f{0.036f, 0.28f},
                                              {0.036f, 0.31f},
                                              {0.016f, 0.33f},
                                              {0.016f, 0.42f},
                                              {0.03f, 0.45f},
                                              {0.014f, 0.48f},
                                              {0.014f, 0.58f},
                                              {0.024f, 0.6f},
                                              {0.012f, 0.62f},
                                              {0.012f, 0.66f},
                                              {0.02f, 0.68f}},
                        14, true),
          brass);
    k.add(shapes::vessel(std::array<Vec2f, 3>{Vec2f{0.07f, 0.675f}, {0.088f, 0.68f}, {0.095f, 0.69f}}, 0.004f, 20),
          brass),
        k.add(shapes::lathe(
                  std::array<Vec2f, 4>{Vec2f{0.018f, 0.68f}, {0.02f, 0.71f}, {0.036f, 0.74f}, {0.036f, 0.76f}}, 14),
              clay),
        k.add(shapes::ball({0, 0.765f, 0}, {0.024f, 0.012f, 0.024f}, 8), ember);
    std::vector<Vec3f> path{{0.03f, 0.31f, 0}, {0.1f, 0.34f, 0.02f}, {0.19f, 0.26f, 0.06f}, {0.24f, 0.08f, 0.1f}};
    for (int i = 0; i <= 12; ++i) {
        const float a = 0.3f + kTau * static_cast<float>(i) / 16;
        path.push_back({0.02f + 0.21f * std::cos(a), 0.018f, 0.05f + 0.2f * std::sin(a)});
    }
    k.add(shapes::tube(path, 0.012f, 8), hose),
        k.rod(wood, path.back(), path.back() + Vec3f{0.12f, 0.04f, -0.1f}, 0.013f, 0.007f, 8);
}

void build_stone_lantern(Kit& k) {
    const int stone = k.main(*material_named("stone"), false),
              fire = k.material(glow("lantern light", {3.2f, 1.9f, 0.8f}));
    k.add(shapes::prism(shapes::circle(0.24f, 6), 0, 0.1f, 0.02f), stone),
        k.add(shapes::prism(shapes::circle(0.19f, 6), 0.1f, 0.17f, 0.02f), stone);
    k.add(shapes::lathe(
              std::array<Vec2f, 6>{
                  Vec2f{0.1f, 0.16f}, {0.085f, 0.3f}, {0.1f, 0.38f}, {0.085f, 0.46f}, {0.09f, 0.62f}, {0.11f, 0.64f}},
              16, true),
          stone);
    k.add(shapes::prism(shapes::circle(0.22f, 6), 0.63f, 0.72f, 0.025f), stone);
    for (int i = 0; i < 6; ++i)
        k.rod(stone, around(kTau * static_cast<float>(i) / 6) * 0.145f + Vec3f{0, 0.71f, 0},
              around(kTau * static_cast<float>(i) / 6) * 0.145f + Vec3f{0, 0.92f, 0}, 0.028f, -1, 6);
    k.add(shapes::lathe(std::array<Vec2f, 2>{Vec2f{0.085f, 0.72f}, {0.085f, 0.91f}}, 10), fire);
    k.add(shapes::lathe(
              std::array<Vec2f, 5>{Vec2f{0.3f, 0.95f}, {0.31f, 0.98f}, {0.2f, 1.02f}, {0.1f, 1.1f}, {0.06f, 1.14f}}, 6),
          stone),
        k.add(shapes::prism(shapes::circle(0.16f, 6), 0.91f, 0.96f, 0.01f), stone);
    k.add(shapes::lathe(
              std::array<Vec2f, 5>{Vec2f{0.06f, 1.13f}, {0.08f, 1.18f}, {0.06f, 1.23f}, {0.02f, 1.26f}, {0, 1.3f}}, 12,
              true),
          stone);
}

// A saxony wheel with treadle, flyer and a distaff of wool.
void build_spinning_wheel(Kit& k) {
    const int wood = k.main(k.style.wood), wool = color(k, "wool", {0.66f, 0.62f, 0.52f}, 0.95f),
              dark = k.material(k.style.wood2);
    Mesh bench = shapes::box({0.72f, 0.045f, 0.16f}, 0.01f);
    shapes::turn(bench, {0, 0, 1}, 14), k.add(std::move(bench), wood, {0, 0.42f, 0});
    k.rod(wood, {-0.28f, 0.36f, 0.04f}, {-0.36f, 0, 0.2f}, 0.022f, 0.016f, 10),
        k.rod(wood, {-0.28f, 0.36f, -0.04f}, {-0.36f, 0, -0.2f}, 0.022f, 0.016f, 10),
        k.rod(wood, {0.3f, 0.48f, 0}, {0.42f, 0, 0}, 0.022f, 0.016f, 10);
    const Vec3f hub{0.2f, 0.82f, 0};
    Mesh rim = shapes::ring(0.29f, 0.022f, 32);
    shapes::turn(rim, {1, 0, 0}, 90), k.add(std::move(rim), wood, hub),
        k.rod(dark, hub - Vec3f{0, 0, 0.06f}, hub + Vec3f{0, 0, 0.06f}, 0.032f, -1, 12);
    for (int i = 0; i < 12; ++i) {
        const float a = kTau * static_cast<float>(i) / 12;
        k.rod(dark, hub + Vec3f{0.02f * std::cos(a), 0.02f * std::sin(a), 0},
              hub + Vec3f{0.28f * std::cos(a), 0.28f * std::sin(a), 0}, 0.009f, 0.008f, 6);
    }
    for (const float z : {-0.07f, 0.07f})
        k.rod(wood, {0.2f, 0.46f, z}, {0.2f, 0.86f, z}, 0.018f, 0.014f, 10),
            k.rod(wood, {-0.22f, 0.38f, z}, {-0.24f, 0.68f, z}, 0.016f, 0.012f, 8);
    k.rod(dark, {-0.24f, 0.62f, -0.14f}, {-0.24f, 0.62f, 0.16f}, 0.01f, -1, 8),
        k.rod(wool, {-0.24f, 0.62f, -0.05f}, {-0.24f, 0.62f, 0.05f}, 0.035f, -1, 12);
    k.rod(wool, {-0.22f, 0.655f, 0}, {0.16f, 1.11f, 0}, 0.003f, -1, 4),
        k.rod(wool, {-0.23f, 0.59f, 0}, {0.12f, 0.54f, 0}, 0.003f, -1, 4);
    k.rod(dark, {-0.33f, 0.34f, 0}, {-0.36f, 1.2f, 0}, 0.013f, 0.008f, 8);
    for (int i = 0; i < 5; ++i)
        k.add(shapes::ball({-0.352f, 0.94f + 0.055f * static_cast<float>(i), 0},
                           {0.06f - 0.006f * static_cast<float>(i), 0.05f, 0.06f - 0.006f * static_cast<float>(i)}, 10),
              wool);
    k.board(wood, {0.02f, 0.05f, 0.04f}, {0.34f, 0.02f, 0.14f}, 0.006f),
        k.rod(dark, {0.12f, 0.07f, 0.08f}, {0.2f, 0.72f, 0.1f}, 0.008f, -1, 6);
}

// Three bays: the priest's behind a curtain, a place to kneel at either side.
void build_confessional(Kit& k) {
    const Vec3f s = k.wanted({2.1f, 2.15f, 0.85f});
    const int wood = k.main(k.style.wood2), cloth = k.material(tinted(k.style.curtain, {0.28f, 0.02f, 0.05f})),
              dark = color(k, "shadow", {0.02f, 0.015f, 0.012f}, 0.9f), gold = k.material(*material_named("gold"));
    k.board(wood, {0, 0, 0}, {s.x, 0.12f, s.z}, 0.01f),
        k.board(wood, {0, 0.12f, -0.5f * s.z + 0.02f}, {s.x - 0.04f, s.y - 0.3f, 0.03f}, 0.004f);
    const float bay = (s.x - 0.1f) / 3, top = s.y - 0.22f;
    for (int i = 0; i < 4; ++i)
        k.board(wood, {-0.5f * s.x + 0.05f + bay * static_cast<float>(i), 0.12f, 0}, {0.06f, top - 0.12f, s.z - 0.06f},
                0.01f);
    k.board(wood, {0, top, 0}, {s.x + 0.02f, 0.1f, s.z + 0.02f}, 0.03f),
        k.board(wood, {0, top + 0.1f, 0}, {s.x - 0.1f, 0.12f, s.z - 0.1f}, 0.02f);
    for (const float sx : {-1.f, 1.f}) {
        k.board(wood, {sx * bay, 0.12f, 0.02f}, {bay - 0.1f, 0.22f, 0.34f}, 0.008f),
            k.board(dark, {sx * (0.5f * bay + 0.032f), 1.2f, -0.1f}, {0.006f, 0.36f, 0.3f}, 0.001f);
        k.board(wood, {sx * (0.5f * bay + 0.09f), 1.05f, -0.1f}, {0.12f, 0.03f, 0.4f}, 0.006f);
        k.board(wood, {sx * bay, top - 0.2f, 0.5f * s.z - 0.05f}, {bay - 0.06f, 0.2f, 0.03f}, 0.006f);
    }
    k.board(wood, {0, 0.12f, 0.5f * s.z - 0.05f}, {bay - 0.06f, 0.85f, 0.035f}, 0.006f),
        k.board(wood, {0, 0.25f, 0.5f * s.z - 0.025f}, {bay - 0.24f, 0.58f, 0.02f}, 0.01f),
        k.board(wood, {0, top - 0.2f, 0.5f * s.z - 0.05f}, {bay - 0.06f, 0.2f, 0.03f}, 0.006f);
    k.add(shapes::slab(40, 4, 0.006f,
                       [&](float u, float v) {
                           return Vec3f{(bay - 0.08f) * (u - 0.5f), 0.96f + (top - 1.0f) * v,
                                        0.5f * s.z - 0.1f + 0.025f * std::sin(9 * kTau * u) * (1 - 0.4f * v)};
                       }),
          cloth);
    k.board(gold, {0, s.y, 0.4f * s.z}, {0.035f, 0.3f, 0.025f}, 0.005f),
        k.board(gold, {0, s.y + 0.18f, 0.4f * s.z}, {0.18f, 0.035f, 0.025f}, 0.005f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.7f;
}

}  // namespace fastscene::furniture
