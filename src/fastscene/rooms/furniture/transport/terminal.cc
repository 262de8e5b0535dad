// Of airports, queues and cloakrooms: gates, scanners, belts, ropes, luggage; of kindergartens: cubbies, drawings.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

namespace {

Vec3f luggage_tone(Kit& k) {
    const Vec3f tones[7] = {{0.05f, 0.06f, 0.08f}, {0.4f, 0.04f, 0.05f}, {0.05f, 0.16f, 0.36f}, {0.08f, 0.3f, 0.26f},
                            {0.5f, 0.5f, 0.5f},    {0.6f, 0.38f, 0.06f}, {0.28f, 0.16f, 0.3f}};
    return tones[k.rng.index(7)];
}

}  // namespace

// An arch of two panels with a lit bar on top.
void build_security_gate(Kit& k) {
    const int body = k.main(plain("detector", {0.55f, 0.57f, 0.58f}, 0.4f)),
              dark = color(k, "edge", {0.04f, 0.04f, 0.045f}, 0.5f), green = lit(k, "lamp", {0.2f, 2.2f, 0.5f}),
              red = lit(k, "lamp red", {2.2f, 0.2f, 0.2f});
    for (const float sx : {-1.f, 1.f}) {
        k.board(body, {sx * 0.42f, 0.02f, 0}, {0.09f, 2.1f, 0.56f}, 0.03f),
            k.board(dark, {sx * 0.42f, 0, 0}, {0.14f, 0.05f, 0.62f}, 0.012f);
        for (const float sz : {-1.f, 1.f}) block(k, dark, {sx * 0.42f, 0.1f, sz * 0.277f}, {0.03f, 1.9f, 0.008f});
        for (int i = 0; i < 6; ++i)
            block(k, i == 2 && sx > 0 ? red : green, {sx * 0.42f, 0.4f + 0.26f * static_cast<float>(i), 0.281f},
                  {0.014f, 0.16f, 0.004f});
    }
    k.board(body, {0, 2.05f, 0}, {0.93f, 0.2f, 0.5f}, 0.03f),
        k.board(dark, {0, 2.09f, 0.248f}, {0.4f, 0.12f, 0.01f}, 0.003f);
    for (int i = 0; i < 4; ++i)
        block(k, i < 3 ? green : red, {-0.13f + 0.085f * static_cast<float>(i), 2.13f, 0.253f}, {0.06f, 0.03f, 0.003f});
    k.piece.clearance_front_m = 0.8f;
}

// A belt that runs through a box with curtains of rubber; trays and bags on it, and a screen.
void build_baggage_scanner(Kit& k) {
    const int body = k.main(plain("scanner", {0.52f, 0.55f, 0.58f}, 0.4f)),
              belt = color(k, "belt", {0.03f, 0.03f, 0.032f}, 0.7f), metal = k.material(steel()),
              tray = color(k, "tray", {0.35f, 0.37f, 0.4f}, 0.5f),
              blue = color(k, "panel", {0.06f, 0.16f, 0.36f}, 0.4f);
    k.board(metal, {0, 0.66f, 0}, {2.8f, 0.08f, 0.7f}, 0.01f),
        k.board(belt, {0, 0.735f, 0}, {2.78f, 0.012f, 0.58f}, 0.004f);
    for (const float sx : {-1.f, 1.f}) {
        for (const float sz : {-1.f, 1.f})
            k.rod(metal, {sx * 1.25f, 0, sz * 0.28f}, {sx * 1.25f, 0.67f, sz * 0.28f}, 0.025f, -1, 8);
        k.rod(belt, {sx * 1.39f, 0.705f, -0.29f}, {sx * 1.39f, 0.705f, 0.29f}, 0.038f, -1, 14);
        for (int i = 0; i < 7; ++i)
            block(k, belt, {sx * 0.605f, 0.755f, -0.26f + 0.087f * static_cast<float>(i)}, {0.006f, 0.47f, 0.082f});
    }
    k.board(body, {0, 0, 0}, {1.1f, 0.7f, 0.86f}, 0.02f);
    for (const float sz : {-1.f, 1.f}) k.board(body, {0, 0.68f, sz * 0.37f}, {1.2f, 0.6f, 0.12f}, 0.02f);
    k.board(body, {0, 1.22f, 0}, {1.2f, 0.2f, 0.86f}, 0.03f),
        k.board(blue, {0, 0.9f, 0.432f}, {0.7f, 0.2f, 0.01f}, 0.004f);
    k.board(tray, {-1.02f, 0.747f, 0.02f}, {0.42f, 0.1f, 0.5f}, 0.012f),
        k.board(belt, {-1.02f, 0.82f, 0.02f}, {0.3f, 0.1f, 0.34f}, 0.04f);
    k.board(color(k, "bag", luggage_tone(k), 0.6f), {1.0f, 0.747f, 0}, {0.5f, 0.26f, 0.34f}, 0.06f);
    k.merge(k.small("monitor"), {0.25f, 1.42f, 0.1f});
    k.piece.clearance_front_m = 0.8f;
}

// A belt in an oval with slanted sides of steel, and what has arrived on it.
void build_baggage_carousel(Kit& k) {
    const Vec3f s = k.wanted({4.2f, 0.5f, 2.2f});
    const int metal = k.main(steel()), belt = color(k, "belt", {0.035f, 0.035f, 0.037f}, 0.7f),
              dark = color(k, "base", {0.05f, 0.05f, 0.055f}, 0.6f),
              edge = color(k, "bumper", {0.02f, 0.02f, 0.02f}, 0.6f);
    const auto oval = [&](float inset) {
        return shapes::rounded_rectangle(s.x - 2 * inset, s.z - 2 * inset, std::max(0.08f, 0.5f * s.z - inset - 0.01f),
                                         12);
    };
    k.add(shapes::prism(oval(0.1f), 0, 0.12f, 0.004f), dark),
        k.add(shapes::prism(oval(0.02f), 0.12f, 0.34f, 0.01f), metal),
        k.add(shapes::prism(oval(0.f), 0.33f, 0.38f, 0.015f), edge),
        k.add(shapes::prism(oval(0.05f), 0.37f, 0.4f, 0.004f), belt);
    k.add(shapes::prism(oval(0.62f), 0.39f, 0.56f, 0.03f), metal);
    const float straight = s.x - s.z;
    for (int i = 0; i < 40; ++i) {
        const float side = i < 20 ? 1.f : -1.f, x = -0.5f * straight + straight * static_cast<float>(i % 20) / 19;
        block(k, edge, {x, 0.4f, side * (0.5f * s.z - 0.335f)}, {0.012f, 0.003f, 0.52f});
    }
    for (int i = 0; i < 6; ++i) {
        const float side = i % 2 ? 1.f : -1.f,
                    x = -0.5f * straight + straight * (static_cast<float>(i / 2) + k.rng.uniform(0.1f, 0.9f)) / 3;
        const std::size_t from = k.piece.meshes.size();
        const int shell = color(k, "luggage", luggage_tone(k), k.rng.uniform(0.3f, 0.7f));
        const float w = k.rng.uniform(0.5f, 0.72f), h = k.rng.uniform(0.2f, 0.28f);
        k.board(shell, {}, {w, h, 0.42f}, 0.05f), block(k, edge, {0, 0.48f * h, 0}, {w + 0.004f, 0.012f, 0.424f}),
            k.board(edge, {0, 0.5f * h, 0.22f}, {0.16f, 0.025f, 0.03f}, 0.008f);
        const float a = k.rng.uniform(-30.f, 30.f);
        for (std::size_t j = from; j < k.piece.meshes.size(); ++j)
            shapes::move(shapes::turn(k.piece.meshes[j], {0, 1, 0}, a), {x, 0.405f, side * (0.5f * s.z - 0.33f)});
    }
    k.piece.clearance_front_m = 1.0f;
}

// Posts of brass with ropes that sag between them.
void build_rope_barrier(Kit& k) {
    const Vec3f s = k.wanted({2.4f, 0.98f, 0.34f});
    Material metal = plain("brass", {0.62f, 0.44f, 0.16f}, 0.25f);
    metal.metal = 1.f;
    const int rope = k.main(plain("velvet rope", {0.36f, 0.015f, 0.03f}, 0.85f)), brass = k.material(metal);
    const int posts = std::max(2, static_cast<int>(std::round(s.x / 1.1f)) + 1);
    const float step = (s.x - 0.32f) / static_cast<float>(posts - 1);
    for (int i = 0; i < posts; ++i) {
        const float x = -0.5f * s.x + 0.16f + step * static_cast<float>(i);
        const std::array<Vec2f, 5> foot{
            Vec2f{0.16f, 0}, {0.16f, 0.012f}, {0.12f, 0.03f}, {0.04f, 0.045f}, {0.022f, 0.06f}};
        k.add(shapes::lathe(foot, 24), brass, {x, 0, 0}),
            k.rod(brass, {x, 0.05f, 0}, {x, s.y - 0.06f, 0}, 0.021f, -1, 12),
            k.add(shapes::ball({x, s.y - 0.035f, 0}, {0.036f, 0.035f, 0.036f}, 14), brass),
            k.rod(brass, {x, s.y - 0.13f, 0}, {x, s.y - 0.1f, 0}, 0.034f, -1, 12);
        if (i + 1 == posts) continue;
        std::vector<Vec3f> sag;
        for (int j = 0; j <= 14; ++j) {
            const float t = static_cast<float>(j) / 14;
            sag.push_back({x + 0.03f + (step - 0.06f) * t, s.y - 0.115f - 0.95f * t * (1 - t), 0});
        }
        k.add(shapes::tube(sag, 0.019f, 8), rope);
        for (const std::size_t e : {std::size_t{0}, sag.size() - 2}) k.rod(brass, sag[e], sag[e + 1], 0.024f, -1, 10);
    }
}

// A hard case with wheels and its handle pulled out.
void build_suitcase(Kit& k) {
    const int shell = k.main(plain("suitcase", luggage_tone(k), 0.35f)),
              dark = color(k, "wheel", {0.03f, 0.03f, 0.03f}, 0.6f), metal = k.material(steel());
    k.board(shell, {0, 0.05f, 0}, {0.44f, 0.6f, 0.26f}, 0.045f),
        block(k, dark, {0, 0.052f, 0}, {0.442f, 0.597f, 0.01f});
    for (int i = 0; i < 5; ++i)
        for (const float sz : {-1.f, 1.f})
            k.board(shell, {-0.14f + 0.07f * static_cast<float>(i), 0.1f, sz * 0.131f}, {0.02f, 0.5f, 0.01f}, 0.004f);
    for (const float sx : {-1.f, 1.f}) {
        for (const float sz : {-1.f, 1.f})
            k.rod(dark, {sx * 0.17f - 0.012f, 0.027f, sz * 0.09f}, {sx * 0.17f + 0.012f, 0.027f, sz * 0.09f}, 0.027f,
                  -1, 10),
                block(k, dark, {sx * 0.17f, 0.035f, sz * 0.09f}, {0.045f, 0.025f, 0.045f});
        k.rod(metal, {sx * 0.085f, 0.64f, -0.09f}, {sx * 0.085f, 0.98f, -0.09f}, 0.008f, -1, 8);
    }
    k.board(dark, {0, 0.97f, -0.09f}, {0.22f, 0.03f, 0.035f}, 0.012f),
        k.board(dark, {0, 0.65f, 0.02f}, {0.16f, 0.02f, 0.03f}, 0.008f),
        block(k, metal, {0.17f, 0.42f, 0.136f}, {0.05f, 0.02f, 0.004f});
}

void build_backpack(Kit& k) {
    const int cloth = k.main(plain("backpack cloth", lerp(luggage_tone(k), k.accent(), 0.4f), 0.8f)),
              dark = color(k, "strap", {0.04f, 0.04f, 0.045f}, 0.8f), metal = k.material(steel());
    k.soft(cloth, {0, 0, 0}, {0.31f, 0.44f, 0.17f}, {0.07f, 0.02f, 0.003f, 7}),
        k.soft(cloth, {0, 0.03f, 0.1f}, {0.25f, 0.2f, 0.09f}, {0.035f, 0.012f, 0.002f, 4});
    for (const float sx : {-1.f, 1.f}) {
        k.soft(cloth, {sx * 0.16f, 0.03f, 0}, {0.06f, 0.17f, 0.11f}, {0.025f, 0.008f, 0.001f, 3});
        std::vector<Vec3f> strap;
        for (int i = 0; i <= 10; ++i) {
            const float t = static_cast<float>(i) / 10;
            strap.push_back({sx * (0.06f + 0.05f * t), 0.41f - 0.36f * t, -0.075f - 0.065f * std::sin(kPi * t)});
        }
        k.add(shapes::tube(strap, 0.014f, 6), dark);
    }
    std::vector<Vec3f> grip, zip;
    for (int i = 0; i <= 10; ++i) {
        const float a = kPi * static_cast<float>(i) / 10;
        grip.push_back({0.04f * std::cos(a), 0.43f + 0.035f * std::sin(a), -0.05f}),
            zip.push_back({0.125f * std::cos(a), 0.28f + 0.115f * std::sin(a), 0.083f});
    }
    k.add(shapes::tube(grip, 0.008f, 6), dark), k.add(shapes::tube(zip, 0.004f, 5), dark),
        block(k, dark, {0, 0.17f, 0.147f}, {0.2f, 0.006f, 0.004f}),
        block(k, metal, {0.09f, 0.145f, 0.149f}, {0.008f, 0.03f, 0.003f});
}

// Beads of five colors on eight wires.
void build_abacus(Kit& k) {
    const int wood = k.main(k.style.wood), metal = k.material(steel());
    const Vec3f tones[5] = {
        {0.6f, 0.03f, 0.03f}, {0.75f, 0.5f, 0.02f}, {0.04f, 0.4f, 0.12f}, {0.04f, 0.15f, 0.55f}, {0.7f, 0.25f, 0.02f}};
    for (const float sx : {-1.f, 1.f})
        k.board(wood, {sx * 0.16f, 0, 0}, {0.022f, 0.33f, 0.03f}, 0.006f),
            k.board(wood, {sx * 0.16f, 0, 0}, {0.03f, 0.022f, 0.12f}, 0.006f);
    for (const float y : {0.015f, 0.31f}) k.board(wood, {0, y, 0}, {0.32f, 0.02f, 0.026f}, 0.005f);
    for (int r = 0; r < 8; ++r) {
        const float y = 0.06f + 0.033f * static_cast<float>(r);
        const int bead = color(k, "bead", tones[r % 5], 0.3f), left = k.rng.index(9);
        k.rod(metal, {-0.15f, y, 0}, {0.15f, y, 0}, 0.002f, -1, 5);
        for (int i = 0; i < 8; ++i)
            k.add(shapes::ball({i < left ? -0.138f + 0.023f * static_cast<float>(i)
                                         : 0.138f - 0.023f * static_cast<float>(7 - i),
                                y, 0},
                               {0.0105f, 0.0145f, 0.0145f}, 7),
                  bead);
    }
    on_surface(k);
}

// Cubbies of a kindergarten: a seat with shoes below, hooks with coats, a box and a name over each.
void build_cubby_shelf(Kit& k) {
    const Vec3f s = k.wanted({1.6f, 1.3f, 0.38f});
    const int wood = k.main(k.style.wood), metal = k.material(steel()),
              label = color(k, "name", {0.82f, 0.8f, 0.72f}, 0.8f);
    const int n = std::max(2, static_cast<int>(std::round(s.x / 0.32f)));
    const float step = (s.x - 0.025f) / static_cast<float>(n), zf = 0.5f * s.z;
    k.board(wood, {0, 0, -zf + 0.008f}, {s.x, s.y, 0.016f}, 0.003f);
    for (int i = 0; i <= n; ++i)
        k.board(wood, {-0.5f * s.x + 0.0125f + step * static_cast<float>(i), 0, 0}, {0.022f, s.y, s.z}, 0.005f);
    for (const float y : {0.03f, 0.3f, s.y - 0.3f, s.y - 0.025f})
        k.board(wood, {0, y, 0}, {s.x - 0.02f, 0.022f, s.z - 0.006f}, 0.004f);
    const Vec3f tones[6] = {{0.6f, 0.06f, 0.06f}, {0.1f, 0.25f, 0.6f}, {0.75f, 0.5f, 0.05f},
                            {0.08f, 0.4f, 0.2f},  {0.5f, 0.15f, 0.4f}, {0.75f, 0.3f, 0.08f}};
    for (int i = 0; i < n; ++i) {
        const float x = -0.5f * s.x + 0.0125f + step * (static_cast<float>(i) + 0.5f), y = s.y - 0.38f;
        const Vec3f tone = tones[k.rng.index(6)];
        const int own = color(k, "cubby color", tone, 0.7f), other = color(k, "cloth", tones[k.rng.index(6)], 0.85f);
        for (const float sx : {-1.f, 1.f})
            k.rod(metal, {x + sx * 0.07f, y, -zf + 0.02f}, {x + sx * 0.07f, y + 0.01f, -zf + 0.07f}, 0.006f, -1, 6);
        if (k.rng.chance(0.8f)) {
            const float down = k.rng.uniform(0.38f, 0.5f);
            k.add(shapes::slab(14, 6, 0.012f,
                               [=](float u, float v) {
                                   const float a = (u - 0.5f) * 2.8f, open = 0.035f + 0.085f * std::min(1.f, 2.2f * v);
                                   return Vec3f{
                                       x + open * std::sin(a), y - down * v,
                                       -zf + 0.06f + (0.02f + 0.09f * v) * std::cos(a) * (1 + 0.15f * std::sin(9 * a))};
                               }),
                  other);
        }
        k.board(own, {x, s.y - 0.278f, 0.02f}, {step - 0.07f, 0.17f, s.z - 0.1f}, 0.008f),
            block(k, label, {x, s.y - 0.022f, zf - 0.002f}, {0.12f, 0.018f, 0.003f}),
            block(k, label, {x, s.y - 0.22f, zf - 0.03f}, {0.1f, 0.05f, 0.003f});
        for (const float sx : {-1.f, 1.f})
            k.board(other, {x + sx * 0.05f, 0.052f, 0.04f}, {0.065f, 0.07f, 0.17f}, 0.03f);
        if (k.rng.chance(0.4f)) k.board(own, {x, 0.322f, 0.02f}, {0.18f, 0.2f, 0.12f}, 0.05f);
    }
    k.top(s.y, 0, 0, 0.46f * s.x, 0.4f * s.z);
    k.piece.clearance_front_m = 0.6f, k.piece.against_wall = true;
}

// What children drew, on paper of many colors, pinned up side by side: suns, houses, people, trees.
void build_drawings(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 0.95f, 0.012f});
    const int white = k.main(plain("paper", {0.82f, 0.81f, 0.77f}, 0.9f)),
              yellow = color(k, "paint yellow", {0.85f, 0.6f, 0.03f}, 0.8f),
              blue = color(k, "paint blue", {0.05f, 0.22f, 0.65f}, 0.8f),
              red = color(k, "paint red", {0.65f, 0.05f, 0.05f}, 0.8f),
              green = color(k, "paint green", {0.06f, 0.42f, 0.1f}, 0.8f),
              brown = color(k, "paint brown", {0.25f, 0.12f, 0.05f}, 0.8f),
              cream = color(k, "colored paper", {0.62f, 0.74f, 0.82f}, 0.9f);
    const int columns = std::max(1, static_cast<int>(s.x / 0.36f)), rows = std::max(1, static_cast<int>(s.y / 0.3f));
    const float dx = s.x / static_cast<float>(columns), dy = s.y / static_cast<float>(rows);
    for (int i = 0; i < columns * rows; ++i) {
        const std::size_t from = k.piece.meshes.size();
        const float w = 0.29f, h = 0.21f, z = 0.004f;
        block(k, i % 3 == 2 ? cream : white, {0, -0.5f * h, 0.002f}, {w, h, 0.002f}),
            k.add(shapes::ball({0, 0.46f * h, 0.006f}, {0.007f, 0.007f, 0.006f}, 6), red);
        const auto dot = [&](int m, float x, float y, float r) {
            Mesh d = shapes::prism(shapes::circle(r, 12), 0, 0.0012f, 0.0002f);
            shapes::turn(d, {1, 0, 0}, 90), k.add(std::move(d), m, {x, y, z});
        };
        const int what = k.rng.index(4);
        if (what == 0) {
            block(k, brown, {-0.02f, -0.09f, z}, {0.09f, 0.075f, 0.001f}),
                block(k, blue, {-0.04f, -0.055f, z + 0.001f}, {0.02f, 0.022f, 0.001f}),
                block(k, red, {0, -0.09f, z + 0.001f}, {0.02f, 0.04f, 0.001f});
            for (const float sx : {-1.f, 1.f})
                slat(k, red, {-0.02f + sx * 0.055f, -0.017f, z}, {-0.02f, 0.035f, z}, 0.012f, 0.001f);
            dot(yellow, 0.1f, 0.06f, 0.024f);
        } else if (what == 1) {
            dot(yellow, -0.07f, 0.045f, 0.032f);
            for (int r = 0; r < 8; ++r) {
                const float a = kTau * static_cast<float>(r) / 8;
                const Vec3f d{std::cos(a), std::sin(a), 0};
                slat(k, yellow, Vec3f{-0.07f, 0.045f, z} + d * 0.038f, Vec3f{-0.07f, 0.045f, z} + d * 0.055f, 0.005f,
                     0.001f);
            }
            block(k, green, {0, -0.1f, z}, {0.27f, 0.03f, 0.001f}), dot(red, 0.08f, -0.03f, 0.016f),
                block(k, green, {0.08f, -0.08f, z}, {0.005f, 0.04f, 0.001f});
        } else if (what == 2) {
            for (int p = 0; p < 2; ++p) {
                const float x = -0.05f + 0.1f * static_cast<float>(p), t = p ? 0.75f : 1.f;
                dot(brown, x, -0.08f + 0.13f * t, 0.022f * t),
                    block(k, p ? red : blue, {x, -0.05f, z}, {0.034f, 0.09f * t, 0.001f}),
                    slat(k, brown, {x - 0.04f * t, 0.0f, z}, {x + 0.04f * t, 0.01f, z}, 0.006f, 0.001f);
                for (const float sx : {-1.f, 1.f})
                    block(k, brown, {x + sx * 0.01f, -0.095f, z}, {0.006f, 0.046f, 0.001f});
            }
        } else {
            block(k, brown, {0, -0.09f, z}, {0.022f, 0.08f, 0.001f}), dot(green, 0, 0.025f, 0.05f),
                dot(green, -0.04f, 0.0f, 0.035f), dot(green, 0.04f, 0.0f, 0.035f), dot(red, 0.02f, 0.03f, 0.008f),
                dot(red, -0.03f, 0.01f, 0.008f);
            block(k, blue, {0, 0.085f, z}, {0.26f, 0.014f, 0.001f});
        }
        const float turn = k.rng.uniform(-5.f, 5.f), x = -0.5f * s.x + dx * (static_cast<float>(i % columns) + 0.5f),
                    y = dy * (static_cast<float>(i / columns) + 0.5f);
        for (std::size_t j = from; j < k.piece.meshes.size(); ++j)
            shapes::move(shapes::turn(k.piece.meshes[j], {0, 0, 1}, turn), {x, y, 0});
    }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.0f;
}

}  // namespace fastscene::furniture
