// Toys that stand on shelves and floors: a dollhouse, a train, a car, a doll, a castle of bricks.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// A wheel across x.
void toy_wheel(Kit& k, int tire, int hub, Vec3f c, float r, float wide) {
    k.rod(tire, c - Vec3f{0.5f * wide, 0, 0}, c + Vec3f{0.5f * wide, 0, 0}, r, -1, 14);
    k.rod(hub, c - Vec3f{0.56f * wide, 0, 0}, c + Vec3f{0.56f * wide, 0, 0}, 0.5f * r, -1, 10);
}

}  // namespace

// Three floors of rooms open in front, with a pitched roof, and furniture inside.
void build_doll_house(Kit& k) {
    const Vec3f s = k.wanted({0.8f, 1.0f, 0.4f});
    const int wall = k.main(plain("dollhouse paint",
                                  k.rng.chance(0.5f) ? Vec3f{0.62f, 0.34f, 0.38f} : Vec3f{0.42f, 0.55f, 0.6f}, 0.6f)),
              white = color(k, "white trim", {0.76f, 0.75f, 0.72f}, 0.6f),
              roof = color(k, "roof", {0.3f, 0.07f, 0.06f}, 0.7f),
              wood = k.material(materials::timber("natural", 0.5f)),
              green = color(k, "tiny sofa", {0.15f, 0.35f, 0.2f}), yellow = color(k, "tiny bed", {0.68f, 0.5f, 0.12f}),
              blue = color(k, "tiny rug", {0.1f, 0.2f, 0.5f});
    const float body = 0.66f * s.y, floor = 0.5f * body;
    k.board(wall, {0, 0.02f, -0.5f * s.z + 0.01f}, {s.x - 0.04f, body, 0.015f}, 0.002f);
    for (const float x : {-0.5f * s.x + 0.03f, 0.f, 0.5f * s.x - 0.03f})
        k.board(x == 0.f ? white : wall, {x, 0.02f, 0}, {0.015f, body, s.z - 0.02f}, 0.002f);
    for (int i = 0; i < 3; ++i)
        k.board(i == 0 ? wood : white, {0, floor * static_cast<float>(i), 0}, {s.x - 0.03f, 0.018f, s.z}, 0.003f);
    std::vector<Vec2f> gable{{-0.5f * s.x + 0.03f, -body}, {0.5f * s.x - 0.03f, -body}, {0, -s.y + 0.03f}};
    Mesh g = shapes::prism(std::vector<Vec2f>{gable[0], gable[2], gable[1]}, 0, 0.012f, 0.f);
    shapes::turn(g, {1, 0, 0}, 90);
    k.add(std::move(g), wall, {0, 0, -0.5f * s.z + 0.01f});
    for (const float sx : {-1.f, 1.f}) {
        slat(k, roof, {sx * (0.5f * s.x + 0.02f), body - 0.02f, 0}, {0, s.y, 0}, 0.02f, s.z + 0.04f);
        k.board(white, {sx * 0.22f * s.x, floor + 0.1f, -0.5f * s.z - 0.002f}, {0.14f, 0.14f, 0.008f}, 0.002f),
            k.board(white, {sx * 0.22f * s.x, 0.1f, -0.5f * s.z - 0.002f}, {0.14f, 0.14f, 0.008f}, 0.002f);
    }
    k.board(roof, {0.2f * s.x, 0.84f * s.y, -0.08f}, {0.07f, 0.14f * s.y, 0.07f}, 0.003f);
    const float l = -0.24f * s.x, r = 0.24f * s.x;
    k.board(green, {l, 0.018f, -0.08f}, {0.2f, 0.05f, 0.09f}, 0.012f),
        k.board(green, {l, 0.05f, -0.12f}, {0.2f, 0.06f, 0.03f}, 0.012f),
        block(k, blue, {l, 0.018f, 0.07f}, {0.2f, 0.003f, 0.12f});
    k.board(wood, {r, 0.1f, 0}, {0.14f, 0.012f, 0.1f}, 0.003f),
        k.board(wood, {r, 0.018f, 0}, {0.02f, 0.09f, 0.02f}, 0.003f);
    for (const float e : {-1.f, 1.f})
        k.board(white, {r + e * 0.1f, 0.018f, 0}, {0.04f, 0.05f, 0.045f}, 0.004f),
            k.board(white, {r + e * 0.118f, 0.06f, 0}, {0.008f, 0.06f, 0.045f}, 0.002f);
    k.board(yellow, {l, floor + 0.018f, -0.05f}, {0.12f, 0.05f, 0.22f}, 0.01f),
        k.board(wood, {l, floor + 0.018f, -0.165f}, {0.13f, 0.11f, 0.012f}, 0.004f),
        k.board(white, {l, floor + 0.068f, -0.12f}, {0.1f, 0.016f, 0.05f}, 0.006f);
    k.board(white, {r, floor + 0.018f, -0.06f}, {0.2f, 0.06f, 0.09f}, 0.014f),
        k.board(blue, {r + 0.1f, floor + 0.018f, 0.08f}, {0.06f, 0.12f, 0.05f}, 0.004f);
    k.board(wood, {0, body + 0.018f, 0}, {0.14f, 0.08f, 0.1f}, 0.006f);
}

// An engine with two wagons, on a few rails.
void build_toy_train(Kit& k) {
    const int red = k.main(plain("engine", {0.58f, 0.05f, 0.03f}, 0.35f)),
              black = color(k, "boiler", {0.04f, 0.04f, 0.045f}, 0.3f),
              blue = color(k, "blue wagon", {0.04f, 0.16f, 0.5f}, 0.4f),
              yellow = color(k, "yellow wagon", {0.68f, 0.48f, 0.04f}, 0.4f),
              brass = k.material(*material_named("brass")), wood = k.material(materials::timber("natural", 0.5f)),
              rail = color(k, "rails", {0.35f, 0.35f, 0.36f}, 0.35f);
    for (const float z : {-0.028f, 0.028f}) block(k, rail, {0.1f, 0.008f, z}, {0.58f, 0.008f, 0.006f});
    for (int i = 0; i < 10; ++i)
        block(k, wood, {-0.16f + 0.0577f * static_cast<float>(i), 0, 0}, {0.022f, 0.008f, 0.1f});
    const auto wheels = [&](float x0, float x1) {
        for (const float x : {x0, x1})
            for (const float z : {-0.036f, 0.036f})
                k.rod(black, {x, 0.034f, z - 0.006f}, {x, 0.034f, z + 0.006f}, 0.019f, -1, 12),
                    k.rod(brass, {x, 0.034f, z - 0.008f}, {x, 0.034f, z + 0.008f}, 0.006f, -1, 6);
    };
    wheels(0.2f, 0.32f), k.board(red, {0.26f, 0.04f, 0}, {0.2f, 0.022f, 0.07f}, 0.005f),
        k.rod(black, {0.22f, 0.09f, 0}, {0.35f, 0.09f, 0}, 0.032f, -1, 18),
        k.rod(brass, {0.345f, 0.09f, 0}, {0.358f, 0.09f, 0}, 0.024f, -1, 16);
    k.board(red, {0.19f, 0.06f, 0}, {0.07f, 0.085f, 0.075f}, 0.005f),
        k.board(black, {0.19f, 0.145f, 0}, {0.09f, 0.012f, 0.09f}, 0.005f),
        k.rod(black, {0.32f, 0.11f, 0}, {0.32f, 0.165f, 0}, 0.011f, 0.018f, 12),
        k.rod(brass, {0.265f, 0.115f, 0}, {0.265f, 0.137f, 0}, 0.012f, -1, 12);
    for (const float z : {-0.038f, 0.038f}) block(k, brass, {0.19f, 0.1f, z}, {0.035f, 0.03f, 0.001f});
    const std::array<int, 2> wagon{blue, yellow};
    for (int i = 0; i < 2; ++i) {
        const float x = 0.06f - 0.17f * static_cast<float>(i);
        wheels(x - 0.04f, x + 0.04f),
            k.board(wagon[static_cast<std::size_t>(i)], {x, 0.045f, 0}, {0.14f, i == 1 ? 0.04f : 0.085f, 0.07f},
                    0.005f),
            k.board(black, {x + 0.085f, 0.045f, 0}, {0.03f, 0.008f, 0.01f}, 0.002f);
        if (i != 1) {
            k.board(black, {x, 0.13f, 0}, {0.15f, 0.01f, 0.08f}, 0.004f);
            for (const float z : {-0.0355f, 0.0355f})
                for (int w = -1; w <= 1; ++w)
                    block(k, brass, {x + 0.042f * static_cast<float>(w), 0.085f, z}, {0.028f, 0.028f, 0.001f});
        } else
            for (int b = 0; b < 5; ++b)
                k.add(shapes::ball({x - 0.05f + 0.025f * static_cast<float>(b), 0.09f, b % 2 ? 0.012f : -0.012f},
                                   {0.018f, 0.018f, 0.018f}, 8),
                      wood);
    }
    on_surface(k);
}

void build_toy_car(Kit& k) {
    const int body = k.main(plain("toy car lacquer", k.accent(), 0.15f)),
              pane = color(k, "window", {0.05f, 0.07f, 0.09f}, 0.08f),
              tire = color(k, "tire", {0.025f, 0.025f, 0.025f}, 0.8f), chrome = k.material(steel()),
              lamp = color(k, "lights", {0.7f, 0.66f, 0.5f}, 0.15f);
    const std::vector<Vec2f> side{{-0.115f, -0.02f}, {-0.118f, -0.05f}, {-0.095f, -0.058f}, {-0.062f, -0.088f},
                                  {0.02f, -0.09f},   {0.055f, -0.06f},  {0.112f, -0.052f},  {0.118f, -0.022f}};
    std::vector<Vec2f> ccw(side.rbegin(), side.rend());
    const auto profile = [&](const std::vector<Vec2f>& o, float half, float bevel) {
        Mesh m = shapes::prism(o, -half, half, bevel);
        shapes::turn(m, {1, 0, 0}, 90);
        if (shapes::signed_volume(m) < 0)
            for (std::size_t i = 0; i + 2 < m.triangles.size(); i += 3) std::swap(m.triangles[i], m.triangles[i + 1]);
        return m;
    };
    Mesh m = profile(ccw, 0.05f, 0.008f);
    const std::vector<Vec2f> glass_side{{0.045f, -0.062f}, {0.017f, -0.085f}, {-0.06f, -0.083f}, {-0.084f, -0.062f}};
    Mesh w = profile(glass_side, 0.0515f, 0.001f);
    for (Mesh* p : {&m, &w}) shapes::turn(*p, {0, 1, 0}, -90);
    k.add(std::move(m), body), k.add(std::move(w), pane);
    for (const float sx : {-1.f, 1.f}) {
        for (const float z : {-0.07f, 0.07f}) toy_wheel(k, tire, chrome, {sx * 0.045f, 0.022f, z}, 0.022f, 0.018f);
        k.add(shapes::ball({sx * 0.033f, 0.042f, 0.115f}, {0.01f, 0.01f, 0.005f}, 8), lamp);
    }
    for (const float z : {-0.119f, 0.119f}) k.board(chrome, {0, 0.02f, z}, {0.09f, 0.01f, 0.006f}, 0.002f);
    on_surface(k);
}

// Seated, in a dress, with plaits of wool.
void build_doll(Kit& k) {
    const int dress = k.main(tinted(k.style.fabric, k.accent())),
              skin = color(k, "doll cloth", {0.62f, 0.4f, 0.28f}, 0.8f),
              hair = color(k, "wool hair", k.rng.chance(0.5f) ? Vec3f{0.2f, 0.08f, 0.03f} : Vec3f{0.6f, 0.38f, 0.1f},
                           0.95f),
              white = color(k, "lace", {0.75f, 0.73f, 0.7f}, 0.9f),
              dark = color(k, "eyes", {0.03f, 0.03f, 0.04f}, 0.3f), red = color(k, "shoes", {0.5f, 0.06f, 0.06f}, 0.4f);
    const std::array<Vec2f, 5> skirt{
        Vec2f{0.095f, 0}, {0.09f, 0.03f}, {0.05f, 0.08f}, {0.045f, 0.14f}, {0.02f, 0.165f}};
    k.add(shapes::lathe(skirt, 18, true), dress), k.add(shapes::ring(0.093f, 0.006f, 16), white, {0, 0.006f, 0}),
        k.add(shapes::ring(0.03f, 0.008f, 14), white, {0, 0.158f, 0});
    k.add(shapes::ball({0, 0.22f, 0}, {0.062f, 0.064f, 0.058f}, 16), skin),
        k.add(shapes::ball({0, 0.232f, -0.012f}, {0.067f, 0.062f, 0.058f}, 16), hair);
    for (const float s : {-1.f, 1.f}) {
        k.add(shapes::ball({s * 0.024f, 0.222f, 0.053f}, {0.008f, 0.01f, 0.005f}, 8), dark),
            k.add(shapes::ball({s * 0.036f, 0.2f, 0.046f}, {0.01f, 0.008f, 0.004f}, 8), red);
        for (int i = 0; i < 4; ++i)
            k.add(shapes::ball(
                      {s * (0.066f + 0.004f * static_cast<float>(i)), 0.2f - 0.024f * static_cast<float>(i), 0.012f},
                      {0.015f, 0.016f, 0.015f}, 8),
                  hair);
        k.rod(dress, {s * 0.04f, 0.14f, 0}, {s * 0.085f, 0.09f, 0.03f}, 0.02f, 0.016f, 8),
            k.add(shapes::ball({s * 0.09f, 0.08f, 0.035f}, {0.016f, 0.016f, 0.016f}, 8), skin);
        k.rod(white, {s * 0.035f, 0.022f, 0.06f}, {s * 0.045f, 0.02f, 0.14f}, 0.02f, 0.018f, 8),
            k.add(shapes::ball({s * 0.046f, 0.028f, 0.155f}, {0.022f, 0.03f, 0.022f}, 8), red);
    }
    k.rod(red, {-0.014f, 0.194f, 0.055f}, {0.014f, 0.194f, 0.055f}, 0.003f, -1, 5);
    on_surface(k);
}

// Walls and towers of plastic bricks with studs.
void build_toy_castle(Kit& k) {
    const int gray = k.main(plain("bricks", {0.36f, 0.37f, 0.38f}, 0.25f)),
              dark = color(k, "dark bricks", {0.12f, 0.12f, 0.13f}, 0.25f),
              green = color(k, "plate", {0.05f, 0.3f, 0.07f}, 0.25f),
              red = color(k, "red bricks", {0.55f, 0.04f, 0.03f}, 0.25f),
              yellow = color(k, "flag", {0.7f, 0.5f, 0.03f}, 0.4f);
    block(k, green, {0, 0, 0}, {0.42f, 0.008f, 0.42f});
    const auto wall = [&](Vec3f c, float wx, float wz, float h) {
        block(k, gray, c, {wx, h, wz});
        const int n = std::max(2, static_cast<int>(std::max(wx, wz) / 0.05f));
        for (int i = 0; i < n; i += 2) {
            const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(n) - 0.5f;
            block(k, dark, c + Vec3f{wx > wz ? t * wx : 0, h, wx > wz ? 0 : t * wz},
                  {wx > wz ? wx / static_cast<float>(n) : wx, 0.022f, wx > wz ? wz : wz / static_cast<float>(n)});
        }
    };
    for (const float e : {-1.f, 1.f})
        wall({e * 0.16f, 0.008f, 0}, 0.032f, 0.3f, 0.12f),
            wall({0, 0.008f, e * 0.16f}, 0.3f, 0.032f, e > 0 ? 0.1f : 0.13f);
    block(k, dark, {0, 0.008f, 0.177f}, {0.08f, 0.075f, 0.004f}),
        block(k, yellow, {0, 0.008f, 0.2f}, {0.07f, 0.006f, 0.05f});
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) {
            const Vec3f c{sx * 0.16f, 0.008f, sz * 0.16f};
            const float h = sz < 0 ? 0.24f : 0.18f;
            block(k, gray, c, {0.085f, h, 0.085f});
            for (int b = 1; b < 6; ++b)
                block(k, dark, c + Vec3f{0, h * static_cast<float>(b) / 6, 0}, {0.0854f, 0.002f, 0.0854f});
            if (sz > 0) {
                for (const float ex : {-1.f, 1.f})
                    for (const float ez : {-1.f, 1.f})
                        block(k, dark, c + Vec3f{ex * 0.03f, h, ez * 0.03f}, {0.025f, 0.025f, 0.025f});
            } else {
                k.add(shapes::lathe(std::array<Vec2f, 2>{Vec2f{0.065f, 0}, {0, 0.1f}}, 4), red, c + Vec3f{0, h, 0});
                k.rod(dark, c + Vec3f{0, h + 0.09f, 0}, c + Vec3f{0, h + 0.16f, 0}, 0.003f, -1, 5),
                    block(k, yellow, c + Vec3f{0.025f, h + 0.13f, 0}, {0.045f, 0.028f, 0.003f});
            }
        }
    block(k, gray, {0, 0.008f, -0.06f}, {0.13f, 0.2f, 0.12f}),
        k.add(shapes::lathe(std::array<Vec2f, 2>{Vec2f{0.1f, 0}, {0, 0.09f}}, 4), red, {0, 0.208f, -0.06f});
    for (int i = 0; i < 24; ++i) {
        const float a = static_cast<float>(i % 6), b = static_cast<float>(i / 6);
        k.add(shapes::lathe(std::array<Vec2f, 2>{Vec2f{0.009f, 0}, {0.009f, 0.006f}}, 6), green,
              {-0.1f + 0.04f * a, 0.008f, 0.03f + 0.03f * b});
    }
    on_surface(k);
}

}  // namespace fastscene::furniture
