// Machines for a coin: of chewing gum, of music, with a claw.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/profiles.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// A globe of gum balls on a foot with a crank.
void build_gumball_machine(Kit& k) {
    static constexpr std::array<Vec3f, 6> kGums{Vec3f{0.55f, 0.03f, 0.03f}, {0.65f, 0.45f, 0.03f}, {0.05f, 0.3f, 0.1f},
                                                {0.04f, 0.16f, 0.5f},       {0.66f, 0.64f, 0.6f},  {0.6f, 0.2f, 0.3f}};
    const int body = k.main(plain("enamel", {0.5f, 0.025f, 0.025f}, 0.2f)), metal = k.material(steel()),
              pane = k.material(glass()), dark = color(k, "slot", {0.02f, 0.02f, 0.02f}, 0.5f);
    std::array<int, 6> gums{};
    for (std::size_t i = 0; i < gums.size(); ++i) gums[i] = color(k, "gum", kGums[i], 0.15f);
    const std::array<Vec2f, 5> foot{Vec2f{0.2f, 0}, {0.2f, 0.02f}, {0.09f, 0.05f}, {0.04f, 0.09f}, {0.035f, 0.6f}},
        case_{Vec2f{0.09f, 0.6f}, {0.13f, 0.63f}, {0.13f, 0.8f}, {0.16f, 0.83f}, {0.165f, 0.85f}};
    k.add(shapes::lathe(foot, 24), body), k.add(shapes::lathe(case_, 24), body);
    k.rod(metal, {0, 0.73f, 0.12f}, {0, 0.73f, 0.145f}, 0.045f, 0.04f, 18),
        k.board(metal, {0, 0.72f, 0.15f}, {0.06f, 0.02f, 0.02f}, 0.004f),
        k.board(metal, {0, 0.635f, 0.135f}, {0.07f, 0.05f, 0.02f}, 0.004f),
        block(k, dark, {0, 0.642f, 0.144f}, {0.05f, 0.03f, 0.004f});
    const Vec3f c{0, 1.02f, 0};
    for (int layer = 0; layer < 6; ++layer) {
        const float y = -0.14f + 0.042f * static_cast<float>(layer),
                    r = std::sqrt(std::max(0.f, 0.182f * 0.182f - y * y)) - 0.024f;
        const int count = static_cast<int>(kTau * r / 0.048f);
        for (int i = 0; i < count; ++i)
            k.add(shapes::ball(c +
                                   around(kTau * (static_cast<float>(i) + 0.5f * static_cast<float>(layer % 2)) /
                                          static_cast<float>(count)) *
                                       r +
                                   Vec3f{0, y, 0},
                               {0.024f, 0.024f, 0.024f}, 6),
                  gums[static_cast<std::size_t>(k.rng.index(6))]);
    }
    for (int i = 0; i < 14; ++i)
        k.add(shapes::ball(c + around(2.4f * static_cast<float>(i)) * (0.036f * std::sqrt(static_cast<float>(i))) +
                               Vec3f{0, 0.085f, 0},
                           {0.024f, 0.024f, 0.024f}, 6),
              gums[static_cast<std::size_t>(k.rng.index(6))]);
    k.add(shapes::ball(c, {0.19f, 0.19f, 0.19f}, 24), pane);
    const std::array<Vec2f, 5> lid{Vec2f{0.1f, 1.175f}, {0.105f, 1.18f}, {0.09f, 1.21f}, {0.03f, 1.23f}, {0, 1.232f}};
    k.add(shapes::lathe(lid, 20), body), k.add(shapes::ball({0, 1.245f, 0}, {0.022f, 0.02f, 0.022f}, 10), metal);
}

// An arch of wood with tubes that shine in colors, a grille below, records behind glass.
void build_jukebox(Kit& k) {
    const int wood = k.main(k.style.wood2), chrome = k.material(steel()),
              amber = lit(k, "amber tube", {2.2f, 0.9f, 0.12f}), red = lit(k, "red tube", {1.9f, 0.12f, 0.1f}),
              green = lit(k, "green tube", {0.2f, 1.5f, 0.4f}), page = lit(k, "title strips", {1.0f, 0.9f, 0.6f}),
              dark = color(k, "record", {0.015f, 0.015f, 0.016f}, 0.25f),
              cloth = color(k, "grille cloth", {0.22f, 0.05f, 0.04f}, 0.9f),
              text = color(k, "title", {0.1f, 0.05f, 0.03f}, 0.6f);
    const float hw = 0.44f, straight = 1.02f, z = 0.26f;
    k.add(front_prism(arch(hw, straight, 20), -z, z, 0.015f), wood);
    k.add(front_prism(arch(0.29f, straight - 0.62f, 18), z, z + 0.012f, 0.003f), dark, {0, 0.66f, 0});
    const auto tube = [&](float r, float y0, int mat, float thick, float forward) {
        std::vector<Vec3f> path{{-r, y0, forward}};
        for (int i = 0; i <= 16; ++i) {
            const float a = kPi * (1.f - static_cast<float>(i) / 16.f);
            path.push_back({r * std::cos(a), straight + r * std::sin(a), forward});
        }
        path.push_back({r, y0, forward});
        k.add(shapes::tube(path, thick, 8), mat);
    };
    tube(0.395f, 0.1f, amber, 0.034f, z + 0.01f), tube(0.33f, 0.62f, red, 0.02f, z + 0.008f),
        tube(0.365f, 0.1f, chrome, 0.008f, z + 0.012f), tube(0.43f, 0.06f, chrome, 0.009f, z + 0.006f);
    for (int i = 0; i < 5; ++i) {  // records on edge, one lies on the table
        Mesh disc = shapes::prism(shapes::circle(0.11f, 22), 0, 0.004f, 0.001f);
        shapes::turn(disc, {1, 0, 0}, 90);
        k.add(std::move(disc), i == 2 ? amber : chrome,
              {-0.16f + 0.08f * static_cast<float>(i), 1.12f - 0.02f * std::abs(static_cast<float>(i) - 2.f),
               z + 0.012f + 0.003f * static_cast<float>(i)});
    }
    k.board(page, {0, 0.74f, z + 0.01f}, {0.5f, 0.2f, 0.012f}, 0.003f);
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 3; ++i)
            block(k, text, {0.16f * static_cast<float>(i - 1), 0.757f + 0.037f * static_cast<float>(j), z + 0.022f},
                  {0.12f, 0.012f, 0.002f});
    k.board(chrome, {0, 0.64f, z + 0.02f}, {0.62f, 0.07f, 0.06f}, 0.012f);
    for (int i = 0; i < 10; ++i)
        block(k, i % 2 ? red : page, {-0.23f + 0.051f * static_cast<float>(i), 0.662f, z + 0.05f},
              {0.034f, 0.03f, 0.008f});
    k.board(cloth, {0, 0.14f, z}, {0.62f, 0.47f, 0.01f}, 0.003f);
    for (int i = 0; i < 7; ++i)
        k.rod(chrome, {-0.27f + 0.09f * static_cast<float>(i), 0.14f, z + 0.014f},
              {-0.27f + 0.09f * static_cast<float>(i), 0.61f, z + 0.014f}, 0.007f, -1, 6);
    for (const float y : {0.22f, 0.36f, 0.5f}) k.rod(green, {-0.3f, y, z + 0.02f}, {0.3f, y, z + 0.02f}, 0.01f, -1, 8);
    k.board(chrome, {0, 0, z - 0.02f}, {0.9f, 0.09f, 0.06f}, 0.012f),
        k.board(wood, {0, 0, -0.02f}, {0.92f, 0.1f, 0.5f}, 0.014f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.7f;
}

// A case of glass full of plush, a claw on a rail, a desk with a stick.
void build_claw_machine(Kit& k) {
    static constexpr std::array<Vec3f, 6> kPlush{Vec3f{0.55f, 0.3f, 0.1f}, {0.6f, 0.2f, 0.3f},   {0.15f, 0.35f, 0.55f},
                                                 {0.62f, 0.5f, 0.08f},     {0.6f, 0.58f, 0.54f}, {0.2f, 0.42f, 0.14f}};
    const int body = k.main(plain("cabinet", {0.5f, 0.03f, 0.12f}, 0.3f)), metal = k.material(steel()),
              pane = k.material(glass()), dark = color(k, "black plastic", {0.02f, 0.02f, 0.022f}, 0.4f),
              light = lit(k, "case light", {2.0f, 1.9f, 1.7f}), sign = lit(k, "lit sign", {1.7f, 0.9f, 0.1f}),
              back = color(k, "case back", {0.35f, 0.42f, 0.6f}, 0.6f), red = lit(k, "button", {1.8f, 0.1f, 0.08f}),
              yellow = color(k, "stripe", {0.68f, 0.48f, 0.03f}, 0.4f);
    std::array<int, 6> plush{};
    for (std::size_t i = 0; i < plush.size(); ++i) plush[i] = color(k, "plush", kPlush[i], 0.95f);
    const float w = 0.85f, d = 0.85f, z = 0.5f * d;
    k.board(body, {0, 0, 0}, {w, 0.8f, d}, 0.015f), k.board(body, {0, 1.72f, 0}, {w, 0.26f, d}, 0.015f),
        block(k, back, {0, 0.8f, -z + 0.03f}, {w - 0.06f, 0.92f, 0.02f});
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.board(metal, {sx * (0.5f * w - 0.025f), 0.78f, sz * (z - 0.025f)}, {0.05f, 0.95f, 0.05f}, 0.006f);
    block(k, pane, {0, 0.8f, z - 0.02f}, {w - 0.1f, 0.92f, 0.006f});
    for (const float sx : {-1.f, 1.f}) block(k, pane, {sx * (0.5f * w - 0.02f), 0.8f, 0}, {0.006f, 0.92f, d - 0.1f});
    block(k, light, {0, 1.7f, 0}, {w - 0.2f, 0.02f, d - 0.3f}),
        k.board(sign, {0, 1.76f, z}, {w - 0.1f, 0.18f, 0.012f}, 0.004f);
    for (int i = 0; i < 5; ++i)
        k.add(shapes::prism(star(0.05f, 0.022f), 0, 0.006f, 0.001f), body),
            shapes::turn(k.piece.meshes.back(), {1, 0, 0}, 90),
            shapes::move(k.piece.meshes.back(), {0.15f * static_cast<float>(i - 2), 1.85f, z + 0.012f});
    const std::array<Vec2f, 4> desk{Vec2f{z, 0.62f}, {z + 0.16f, 0.62f}, {z + 0.16f, 0.72f}, {z, 0.8f}};
    k.add(side_prism(desk, -0.5f * w + 0.02f, 0.5f * w - 0.02f, 0.01f), dark);
    k.rod(metal, {-0.16f, 0.73f, z + 0.09f}, {-0.16f, 0.83f, z + 0.1f}, 0.008f, -1, 8),
        k.add(shapes::ball({-0.16f, 0.85f, z + 0.1f}, {0.028f, 0.028f, 0.028f}, 12), yellow),
        k.rod(red, {0.12f, 0.74f, z + 0.09f}, {0.12f, 0.765f, z + 0.1f}, 0.032f, -1, 14);
    k.board(dark, {-0.2f, 0.18f, z}, {0.3f, 0.28f, 0.012f}, 0.006f),
        k.board(metal, {0.22f, 0.3f, z}, {0.16f, 0.2f, 0.012f}, 0.004f);
    for (const float y : {0.08f, 0.54f}) block(k, yellow, {0, y, z + 0.003f}, {w - 0.06f, 0.03f, 0.004f});
    for (int i = 0; i < 26; ++i) {
        const Vec3f at{k.rng.uniform(-0.31f, 0.31f), 0.85f + 0.055f * static_cast<float>(i % 3),
                       k.rng.uniform(-0.28f, 0.3f)};
        const int fur = plush[static_cast<std::size_t>(k.rng.index(6))];
        k.add(shapes::ball(at, {0.07f, 0.065f, 0.06f}, 8), fur),
            k.add(shapes::ball(at + Vec3f{0, 0.075f, 0.03f}, {0.05f, 0.048f, 0.046f}, 8), fur);
        for (const float sx : {-1.f, 1.f})
            k.add(shapes::ball(at + Vec3f{sx * 0.036f, 0.115f, 0.025f}, {0.018f, 0.02f, 0.012f}, 5), fur),
                k.add(shapes::ball(at + Vec3f{sx * 0.017f, 0.083f, 0.073f}, {0.007f, 0.007f, 0.005f}, 5), dark);
    }
    k.rod(metal, {-0.36f, 1.66f, 0.05f}, {0.36f, 1.66f, 0.05f}, 0.014f, -1, 8),
        k.board(dark, {0.08f, 1.58f, 0.05f}, {0.12f, 0.07f, 0.12f}, 0.01f),
        k.rod(metal, {0.08f, 1.36f, 0.05f}, {0.08f, 1.58f, 0.05f}, 0.006f, -1, 6),
        k.rod(metal, {0.08f, 1.32f, 0.05f}, {0.08f, 1.38f, 0.05f}, 0.035f, -1, 12);
    for (int i = 0; i < 3; ++i) {
        const Vec3f c{0.08f, 1.33f, 0.05f}, out = around(kTau * static_cast<float>(i) / 3.f + 0.5f);
        const std::array<Vec3f, 4> finger{c, c + out * 0.09f - Vec3f{0, 0.03f, 0}, c + out * 0.1f - Vec3f{0, 0.1f, 0},
                                          c + out * 0.045f - Vec3f{0, 0.15f, 0}};
        k.add(shapes::tube(finger, 0.008f, 6), metal);
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.7f;
}

}  // namespace fastscene::furniture
