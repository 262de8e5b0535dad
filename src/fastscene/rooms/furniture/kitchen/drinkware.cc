// Drinks and what they are served from: glasses, bottles, taps, dispensers, teapots, plates, a pan.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/profiles.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// A bottle of many sides with a printed label; its glass is the main material.
void labelled_bottle(Kit& k, std::span<const Vec2f> profile, int glass, int cap, float cap_y, float cap_r, float radius,
                     float y0, float y1) {
    const auto side = shapes::curve(profile, 2);
    k.add(shapes::lathe(side, 20, true), glass);
    k.rod(cap, {0, cap_y, 0}, {0, profile.back().y + 0.003f, 0}, cap_r, -1, 12);
    const PrintSheet sheet = print_sheet(k, Print::wines);
    k.add(printed_can(sheet[k.rng.index(sheet.cells)], radius + 0.0012f, y0, y1, 20), sheet.material);
    on_surface(k);
}

}  // namespace

void build_wine_glass(Kit& k) {
    Material clear = glass();
    const int body = k.main(clear),
              wine = color(k, "wine", k.rng.chance(0.6f) ? Vec3f{0.16f, 0.008f, 0.02f} : Vec3f{0.55f, 0.42f, 0.12f},
                           0.05f);
    const std::array<Vec2f, 5> stem{
        Vec2f{0.034f, 0}, {0.033f, 0.003f}, {0.006f, 0.01f}, {0.0045f, 0.05f}, {0.006f, 0.088f}},
        bowl{Vec2f{0.006f, 0.088f}, {0.03f, 0.105f}, {0.041f, 0.135f}, {0.038f, 0.17f}, {0.032f, 0.2f}},
        full{Vec2f{0.003f, 0.091f}, {0.028f, 0.107f}, {0.036f, 0.122f}, {0.0385f, 0.135f}, {0, 0.1352f}};
    k.add(shapes::lathe(stem, 18), body), k.add(shapes::vessel(bowl, 0.0012f, 22), body),
        k.add(shapes::lathe(full, 18), wine);
    on_surface(k);
}

void build_glass_cup(Kit& k) {
    const int body = k.main(glass());
    const std::array<Vec2f, 3> side{Vec2f{0.028f, 0}, {0.031f, 0.02f}, {0.037f, 0.12f}};
    k.add(shapes::vessel(side, 0.002f, 20), body);
    on_surface(k);
}

void build_wine_bottle(Kit& k) {
    const bool red = k.rng.chance(0.7f);
    const int glass = k.main(
                  plain("bottle glass", red ? Vec3f{0.012f, 0.022f, 0.012f} : Vec3f{0.14f, 0.16f, 0.04f}, 0.06f)),
              foil = color(k, "foil", red ? Vec3f{0.2f, 0.015f, 0.02f} : Vec3f{0.5f, 0.38f, 0.14f}, 0.3f);
    const std::array<Vec2f, 8> p{Vec2f{0.034f, 0}, {0.038f, 0.005f}, {0.038f, 0.1f},   {0.038f, 0.185f},
                                 {0.03f, 0.215f},  {0.016f, 0.24f},  {0.0145f, 0.28f}, {0.0145f, 0.31f}};
    labelled_bottle(k, p, glass, foil, 0.255f, 0.0158f, 0.038f, 0.05f, 0.15f);
}

void build_beer_bottle(Kit& k) {
    const int glass = k.main(plain("bottle glass",
                                   k.rng.chance(0.6f) ? Vec3f{0.11f, 0.04f, 0.01f} : Vec3f{0.02f, 0.07f, 0.025f},
                                   0.06f)),
              cap = color(k, "crown cap", {0.55f, 0.42f, 0.12f}, 0.3f);
    const std::array<Vec2f, 8> p{Vec2f{0.028f, 0}, {0.031f, 0.004f},  {0.031f, 0.07f},  {0.031f, 0.13f},
                                 {0.025f, 0.155f}, {0.0145f, 0.185f}, {0.0125f, 0.21f}, {0.013f, 0.23f}};
    labelled_bottle(k, p, glass, cap, 0.226f, 0.0145f, 0.031f, 0.04f, 0.11f);
}

// A tower of brass with three taps over a drip tray.
void build_beer_tap(Kit& k) {
    const int metal = k.main(*material_named("brass")), dark = color(k, "grip", {0.03f, 0.02f, 0.016f}, 0.3f),
              tray = k.material(steel()), grid = color(k, "grid", {0.05f, 0.05f, 0.05f}, 0.5f),
              white = k.material(porcelain());
    k.board(tray, {0, 0, 0.05f}, {0.44f, 0.025f, 0.2f}, 0.006f),
        block(k, grid, {0, 0.022f, 0.06f}, {0.4f, 0.005f, 0.14f});
    for (const float x : {-0.13f, 0.13f})
        k.rod(metal, {x, 0.02f, -0.02f}, {x, 0.34f, -0.02f}, 0.03f, -1, 16),
            k.rod(metal, {x, 0.02f, -0.02f}, {x, 0.035f, -0.02f}, 0.048f, -1, 16);
    k.rod(metal, {-0.2f, 0.34f, -0.02f}, {0.2f, 0.34f, -0.02f}, 0.038f, -1, 18);
    for (const float s : {-1.f, 1.f})
        k.add(shapes::ball({s * 0.2f, 0.34f, -0.02f}, {0.045f, 0.045f, 0.045f}, 14), metal);
    static constexpr std::array<Vec3f, 3> kBrands{
        Vec3f{0.45f, 0.03f, 0.03f}, {0.04f, 0.2f, 0.1f}, {0.04f, 0.1f, 0.35f}};
    for (int i = 0; i < 3; ++i) {
        const float x = 0.15f * static_cast<float>(i - 1);
        k.rod(tray, {x, 0.34f, 0.01f}, {x, 0.34f, 0.085f}, 0.013f, -1, 10),
            k.rod(tray, {x, 0.345f, 0.075f}, {x, 0.27f, 0.09f}, 0.012f, 0.009f, 10);
        k.rod(tray, {x, 0.35f, 0.07f}, {x, 0.38f, 0.075f}, 0.008f, -1, 8),
            k.rod(dark, {x, 0.38f, 0.075f}, {x, 0.5f, 0.1f}, 0.013f, 0.02f, 12);
        Mesh badge = shapes::prism(shapes::circle(0.035f, 18), 0, 0.008f, 0.002f);
        shapes::turn(badge, {1, 0, 0}, 90);
        k.add(std::move(badge), color(k, "badge", kBrands[static_cast<std::size_t>(i)], 0.3f), {x, 0.43f, 0.112f}),
            k.add(front_ring(0.03f, 0.005f, 18), white, {x, 0.43f, 0.121f});
    }
    on_surface(k);
}

// A cabinet with nozzles in a row, a lit sign above, a drip tray.
void build_soda_fountain(Kit& k) {
    static constexpr std::array<Vec3f, 5> kSodas{Vec3f{0.5f, 0.02f, 0.02f},
                                                 {0.6f, 0.26f, 0.02f},
                                                 {0.08f, 0.36f, 0.08f},
                                                 {0.04f, 0.12f, 0.42f},
                                                 {0.62f, 0.5f, 0.05f}};
    const int body = k.main(steel()), dark = color(k, "black plastic", {0.025f, 0.025f, 0.027f}, 0.4f),
              grid = color(k, "grid", {0.09f, 0.09f, 0.09f}, 0.5f), light = lit(k, "lit sign", {1.5f, 1.45f, 1.35f}),
              cup = color(k, "paper cup", {0.68f, 0.66f, 0.6f}, 0.7f);
    const float w = 0.66f;
    k.board(body, {0, 0.02f, -0.13f}, {w, 0.72f, 0.3f}, 0.012f),
        k.board(body, {0, 0.02f, 0.08f}, {w, 0.1f, 0.36f}, 0.01f),
        block(k, grid, {0, 0.118f, 0.12f}, {w - 0.06f, 0.006f, 0.22f});
    k.board(body, {0, 0.44f, 0.07f}, {w, 0.32f, 0.3f}, 0.02f),
        k.board(light, {0, 0.6f, 0.222f}, {w - 0.05f, 0.13f, 0.006f}, 0.003f),
        block(k, dark, {0, 0.13f, 0.022f}, {w - 0.05f, 0.3f, 0.006f});
    for (int i = 0; i < 5; ++i) {
        const float x = (w - 0.12f) * (static_cast<float>(i) - 2.f) / 4.f;
        const int paint = color(k, "soda", kSodas[static_cast<std::size_t>(i)], 0.3f);
        k.board(paint, {x, 0.47f, 0.222f}, {0.095f, 0.11f, 0.012f}, 0.004f),
            block(k, paint, {x, 0.62f, 0.226f}, {0.09f, 0.085f, 0.004f});
        k.rod(dark, {x, 0.385f, 0.13f}, {x, 0.445f, 0.13f}, 0.018f, 0.026f, 12),
            k.board(dark, {x, 0.32f, 0.1f}, {0.034f, 0.1f, 0.01f}, 0.003f);
    }
    const std::array<Vec2f, 2> p{Vec2f{0.03f, 0}, {0.043f, 0.12f}};
    for (const float x : {-0.135f, 0.27f}) k.add(shapes::vessel(p, 0.003f, 16), cup, {x, 0.124f, 0.13f});
    for (const float sx : {-1.f, 1.f})
        for (const float z : {-0.22f, 0.2f}) k.rod(dark, {sx * 0.28f, 0, z}, {sx * 0.28f, 0.025f, z}, 0.02f, -1, 8);
    constexpr float kCompact = 0.72f;  // of a full-size fountain: it stands on a counter or a sideboard
    for (Mesh& m : k.piece.meshes)
        for (Vec3f& at : m.positions) at = at * kCompact;
    on_surface(k);
}

// Two tanks of juice over taps.
void build_juice_dispenser(Kit& k) {
    static constexpr std::array<Vec3f, 4> kJuices{
        Vec3f{0.65f, 0.27f, 0.015f}, {0.4f, 0.025f, 0.04f}, {0.55f, 0.42f, 0.06f}, {0.2f, 0.38f, 0.06f}};
    const int base = k.main(steel()), dark = color(k, "black plastic", {0.025f, 0.025f, 0.027f}, 0.4f),
              air = color(k, "empty tank", {0.5f, 0.52f, 0.51f}, 0.05f);
    const int first = k.rng.index(4);
    k.board(base, {0, 0.02f, -0.03f}, {0.42f, 0.2f, 0.32f}, 0.015f),
        k.board(dark, {0, 0.02f, 0.17f}, {0.4f, 0.03f, 0.12f}, 0.006f);
    for (int i = 0; i < 2; ++i) {
        const float x = i ? 0.1f : -0.1f;
        const int juice = color(k, "juice", kJuices[static_cast<std::size_t>((first + i) % 4)], 0.06f);
        k.board(juice, {x, 0.22f, -0.03f}, {0.18f, 0.2f, 0.28f}, 0.012f),
            k.board(air, {x, 0.42f, -0.03f}, {0.18f, 0.1f, 0.28f}, 0.012f),
            k.board(dark, {x, 0.52f, -0.03f}, {0.188f, 0.025f, 0.288f}, 0.008f);
        k.rod(dark, {x, 0.17f, 0.12f}, {x, 0.17f, 0.18f}, 0.02f, -1, 10),
            k.rod(dark, {x, 0.12f, 0.165f}, {x, 0.175f, 0.17f}, 0.012f, -1, 8),
            k.board(base, {x, 0.175f, 0.175f}, {0.03f, 0.06f, 0.012f}, 0.003f);
    }
    for (const float sx : {-1.f, 1.f})
        for (const float z : {-0.14f, 0.1f}) k.rod(dark, {sx * 0.17f, 0, z}, {sx * 0.17f, 0.025f, z}, 0.018f, -1, 8);
    on_surface(k);
}

void build_teapot(Kit& k) {
    const int body = k.main(k.rng.chance(0.5f) ? porcelain() : plain("glaze", k.accent(), 0.15f));
    const std::array<Vec2f, 7> p{Vec2f{0.045f, 0}, {0.05f, 0.006f},  {0.078f, 0.04f}, {0.082f, 0.075f},
                                 {0.06f, 0.115f},  {0.042f, 0.127f}, {0.04f, 0.129f}},
        lid{Vec2f{0.041f, 0.128f}, {0.042f, 0.132f}, {0.036f, 0.14f}, {0.015f, 0.148f},
            {0.006f, 0.152f},      {0.006f, 0.156f}, {0, 0.156f}};
    k.add(shapes::lathe(shapes::curve(p, 2), 26, true), body), k.add(shapes::lathe(lid, 20), body),
        k.add(shapes::ball({0, 0.163f, 0}, {0.013f, 0.012f, 0.013f}, 12), body);
    const std::array<Vec3f, 4> spout{
        Vec3f{-0.07f, 0.045f, 0}, {-0.105f, 0.06f, 0}, {-0.118f, 0.1f, 0}, {-0.14f, 0.122f, 0}};
    for (std::size_t i = 0; i + 1 < spout.size(); ++i) {
        const float r = 0.02f - 0.0045f * static_cast<float>(i);
        k.rod(body, spout[i], spout[i + 1], r, r - 0.0045f, 10);
        if (i > 0) k.add(shapes::ball(spout[i], {r, r, r}, 10), body);
    }
    std::vector<Vec3f> handle;
    for (int i = 0; i <= 8; ++i) {
        const float a = 1.4f - 2.8f * static_cast<float>(i) / 8.f;
        handle.push_back({0.075f + 0.05f * std::cos(a), 0.075f + 0.042f * std::sin(a), 0});
    }
    k.add(shapes::tube(handle, 0.008f, 8), body);
    on_surface(k);
}

void build_plate_stack(Kit& k) {
    const int glaze = k.main(k.rng.chance(0.6f) ? porcelain() : plain("glaze", k.accent(), 0.2f));
    const int count = 6 + k.rng.index(4);
    const std::array<Vec2f, 5> p{Vec2f{0.07f, 0}, {0.085f, 0.004f}, {0.11f, 0.014f}, {0.13f, 0.019f}, {0.131f, 0.022f}};
    for (int i = 0; i < count; ++i) {
        const Vec3f at{k.rng.uniform(-0.0025f, 0.0025f), 0.0095f * static_cast<float>(i),
                       k.rng.uniform(-0.0025f, 0.0025f)};
        if (i + 1 == count) k.add(shapes::vessel(p, 0.004f, 24), glaze, at);
        else {
            const std::array<Vec2f, 3> rim{Vec2f{0.09f, 0.006f}, {0.13f, 0.019f}, {0.131f, 0.022f}};
            k.add(shapes::lathe(rim, 24), glaze, at);
        }
    }
    k.add(shapes::lathe(std::array<Vec2f, 3>{Vec2f{0.07f, 0}, {0.07f, 0.004f}, {0.1f, 0.012f}}, 24), glaze);
    on_surface(k);
}

void build_pan(Kit& k) {
    const int iron = k.main(plain("cast iron", {0.03f, 0.03f, 0.031f}, 0.45f)),
              dark = color(k, "grip", {0.04f, 0.025f, 0.018f}, 0.5f), metal = k.material(steel());
    const std::array<Vec2f, 4> p{Vec2f{0.1f, 0}, {0.11f, 0.006f}, {0.135f, 0.045f}, {0.138f, 0.05f}};
    k.add(shapes::vessel(p, 0.004f, 26), iron);
    k.rod(metal, {0.13f, 0.04f, 0}, {0.19f, 0.058f, 0}, 0.009f, -1, 8),
        k.rod(dark, {0.18f, 0.055f, 0}, {0.33f, 0.075f, 0}, 0.012f, 0.015f, 10);
    on_surface(k);
}

}  // namespace fastscene::furniture
