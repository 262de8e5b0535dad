// Of workshops, garages, cellars, greenhouses, laundries and large kitchens.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// A thick top with a vice, a shelf with boxes, a drawer, tools that lie about.
void build_workbench(Kit& k) {
    const Vec3f s = k.wanted({1.9f, 0.88f, 0.7f});
    const int wood = k.main(materials::timber("oak", 0.7f)), iron = color(k, "vice", {0.05f, 0.09f, 0.16f}, 0.4f),
              metal = k.material(steel()), box = color(k, "tool box", {0.45f, 0.04f, 0.03f}, 0.3f),
              grip = color(k, "grip", {0.6f, 0.3f, 0.02f}, 0.6f),
              handle = k.material(materials::timber("natural", 0.6f));
    k.board(wood, {0, s.y - 0.08f, 0}, {s.x, 0.08f, s.z}, 0.008f),
        k.board(wood, {0, 0.2f, 0}, {s.x - 0.1f, 0.03f, s.z - 0.1f});
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.board(wood, {sx * (0.5f * s.x - 0.08f), 0, sz * (0.5f * s.z - 0.07f)}, {0.1f, s.y - 0.08f, 0.1f}, 0.006f);
    for (const float sz : {-1.f, 1.f})
        k.board(wood, {0, s.y - 0.2f, sz * (0.5f * s.z - 0.06f)}, {s.x - 0.1f, 0.12f, 0.03f});
    k.board(box, {-0.3f * s.x, 0.23f, 0}, {0.5f, 0.24f, 0.26f}, 0.02f),
        k.rod(metal, {-0.3f * s.x - 0.12f, 0.5f, 0}, {-0.3f * s.x + 0.12f, 0.5f, 0}, 0.012f);
    k.board(handle, {0.2f * s.x, 0.23f, 0}, {0.5f, 0.3f, 0.4f}, 0.004f);
    const Vec3f v{0.5f * s.x - 0.3f, s.y, 0.5f * s.z - 0.12f};
    k.board(iron, v, {0.2f, 0.05f, 0.24f}, 0.01f),
        k.board(iron, v + Vec3f{0, 0.05f, -0.05f}, {0.18f, 0.12f, 0.06f}, 0.012f),
        k.board(iron, v + Vec3f{0, 0.05f, 0.09f}, {0.18f, 0.12f, 0.05f}, 0.012f),
        k.rod(metal, v + Vec3f{0, 0.09f, 0.1f}, v + Vec3f{0, 0.09f, 0.24f}, 0.018f),
        k.rod(metal, v + Vec3f{-0.1f, 0.09f, 0.22f}, v + Vec3f{0.1f, 0.09f, 0.22f}, 0.008f);
    // A hammer, a plane, screwdrivers, shavings.
    k.rod(handle, {-0.5f, s.y + 0.02f, 0.1f}, {-0.22f, s.y + 0.02f, 0.16f}, 0.014f),
        k.board(metal, {-0.21f, s.y, 0.165f}, {0.035f, 0.035f, 0.12f}, 0.006f);
    k.board(handle, {0.1f, s.y, 0.05f}, {0.07f, 0.05f, 0.26f}, 0.01f),
        k.board(metal, {0.1f, s.y + 0.04f, 0.03f}, {0.05f, 0.08f, 0.02f}, 0.004f),
        k.add(shapes::ball({0.1f, s.y + 0.08f, 0.14f}, {0.022f, 0.03f, 0.022f}, 10), handle);
    for (int i = 0; i < 3; ++i)
        k.rod(grip, {-0.75f + 0.06f * static_cast<float>(i), s.y + 0.016f, -0.1f},
              {-0.75f + 0.06f * static_cast<float>(i), s.y + 0.016f, 0.0f}, 0.016f),
            k.rod(metal, {-0.75f + 0.06f * static_cast<float>(i), s.y + 0.016f, 0},
                  {-0.75f + 0.06f * static_cast<float>(i), s.y + 0.012f, 0.12f}, 0.004f, -1, 6);
    k.top(s.y, 0.32f, -0.15f, 0.25f, 0.12f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.9f;
}

// Saws, hammers, pliers and wrenches on a board with their outlines.
void build_tool_wall(Kit& k) {
    const Vec3f s = k.wanted({1.8f, 1.0f, 0.06f});
    const int board = k.main(materials::timber("natural", 0.8f)), metal = k.material(steel()),
              handle = color(k, "handle", {0.3f, 0.13f, 0.05f}, 0.5f),
              red = color(k, "grip", {0.5f, 0.04f, 0.03f}, 0.5f), blue = color(k, "grip", {0.04f, 0.12f, 0.4f}, 0.5f);
    k.board(board, {0, 0, 0.009f}, {s.x, s.y, 0.018f}, 0.002f);
    const float z = 0.032f;
    for (int i = 0; i < 7; ++i) {  // wrenches by size
        const float x = -0.44f * s.x + 0.07f * static_cast<float>(i), l = 0.14f + 0.025f * static_cast<float>(i),
                    y = 0.86f * s.y;
        k.board(metal, {x, y - l, z}, {0.018f, l, 0.006f}, 0.002f);
        for (const float end : {0.f, l})
            k.add(shapes::prism(shapes::circle(0.02f, 12), 0, 0.008f, 0.001f), metal, {x, y - end, z});
    }
    for (int i = 0; i < 3; ++i) {  // hammers
        const float x = -0.02f + 0.14f * static_cast<float>(i);
        k.rod(handle, {x, 0.5f * s.y, z}, {x, 0.86f * s.y, z}, 0.013f, -1, 8),
            k.board(metal, {x, 0.86f * s.y, z}, {0.11f, 0.035f, 0.03f}, 0.006f);
    }
    for (int i = 0; i < 4; ++i) {  // pliers
        const float x = 0.27f * s.x + 0.09f * static_cast<float>(i);
        for (const float sx : {-1.f, 1.f})
            k.rod(i % 2 ? red : blue, {x, 0.76f * s.y, z}, {x + sx * 0.028f, 0.62f * s.y, z}, 0.009f, -1, 6);
        k.rod(metal, {x, 0.76f * s.y, z}, {x, 0.84f * s.y, z}, 0.013f, 0.006f, 8);
    }
    for (int i = 0; i < 8; ++i) {  // screwdrivers
        const float x = -0.44f * s.x + 0.065f * static_cast<float>(i);
        k.rod(i % 3 ? red : blue, {x, 0.4f * s.y, z}, {x, 0.49f * s.y, z}, 0.014f, -1, 8),
            k.rod(metal, {x, 0.22f * s.y, z}, {x, 0.4f * s.y, z}, 0.004f, -1, 6);
    }
    Mesh blade = shapes::box({0.5f, 0.09f, 0.003f}, 0.0008f);
    k.add(std::move(blade), metal, {0.2f, 0.34f * s.y, z}),
        k.board(handle, {0.5f, 0.27f * s.y, z}, {0.12f, 0.13f, 0.02f}, 0.02f);
    const std::array<Vec3f, 5> bow{Vec3f{0.12f, 0.12f * s.y, z},
                                   {0.12f, 0.24f * s.y, z},
                                   {0.3f, 0.26f * s.y, z},
                                   {0.48f, 0.24f * s.y, z},
                                   {0.48f, 0.12f * s.y, z}};
    k.add(shapes::tube(bow, 0.008f), red),
        k.rod(metal, {0.12f, 0.13f * s.y, z}, {0.48f, 0.13f * s.y, z}, 0.003f, -1, 5);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.15f;
}

void build_barrel(Kit& k) {
    const int wood = k.main(materials::timber("oak", 0.7f)), iron = k.material(*material_named("iron"));
    const std::array<Vec2f, 5> p{Vec2f{0.27f, 0}, {0.33f, 0.2f}, {0.345f, 0.44f}, {0.33f, 0.68f}, {0.27f, 0.88f}};
    const auto side = shapes::curve(p, 4);
    k.add(shapes::lathe(side, 26, true), wood);
    for (const auto& [y, r] : {std::pair{0.06f, 0.29f}, {0.24f, 0.337f}, {0.64f, 0.337f}, {0.82f, 0.29f}}) {
        const std::array<Vec2f, 2> hoop{Vec2f{r + 0.004f, y - 0.02f}, {r + 0.004f, y + 0.02f}};
        k.add(shapes::vessel(hoop, 0.004f, 28), iron);
    }
    k.top(0.88f, 0, 0, 0.17f, 0.17f);
}

// Casks on their sides, in two tiers on a cradle.
void build_cask_rack(Kit& k) {
    const Vec3f s = k.wanted({2.2f, 1.55f, 0.95f});
    const int wood = k.main(materials::timber("oak", 0.7f)), iron = k.material(*material_named("iron")),
              beam = k.material(k.style.wood2);
    const std::array<Vec2f, 5> p{Vec2f{0.27f, -0.44f}, {0.33f, -0.24f}, {0.345f, 0}, {0.33f, 0.24f}, {0.27f, 0.44f}};
    const auto side = shapes::curve(p, 3);
    for (int row = 0; row < 2; ++row) {
        const int count = std::max(1, static_cast<int>(s.x / 0.72f)) - row;
        const float y = 0.45f + 0.7f * static_cast<float>(row);
        for (const float z : {-0.26f, 0.26f}) k.board(beam, {0, y - 0.45f, z}, {s.x, 0.12f, 0.1f}, 0.008f);
        for (int i = 0; i < count; ++i) {
            const float x = 0.72f * (static_cast<float>(i) - 0.5f * static_cast<float>(count - 1));
            Mesh cask = shapes::lathe(side, 22, true);
            shapes::turn(cask, {1, 0, 0}, 90);
            k.add(std::move(cask), wood, {x, y, 0});
            for (const auto& [at, r] : {std::pair{0.36f, 0.302f}, {0.2f, 0.338f}, {-0.2f, 0.338f}, {-0.36f, 0.302f}}) {
                Mesh hoop = shapes::ring(r, 0.012f, 24);
                shapes::turn(hoop, {1, 0, 0}, 90);
                k.add(std::move(hoop), iron, {x, y, at});
            }
            k.rod(beam, {x, y - 0.16f, 0.43f}, {x, y - 0.16f, 0.52f}, 0.018f),
                k.rod(beam, {x, y - 0.1f, 0.5f}, {x, y - 0.22f, 0.5f}, 0.01f);
        }
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.8f;
}

// A bench with pots, trays of seedlings and a watering can.
void build_potting_bench(Kit& k) {
    const Vec3f s = k.wanted({1.8f, 0.82f, 0.75f});
    const int wood = k.main(materials::timber("natural", 0.85f)),
              clay = color(k, "terracotta", {0.42f, 0.17f, 0.08f}, 0.85f),
              leaf = color(k, "leaf", {0.07f, 0.2f, 0.04f}, 0.7f),
              pale = color(k, "young leaf", {0.16f, 0.32f, 0.06f}, 0.7f),
              soil = color(k, "soil", {0.03f, 0.02f, 0.012f}, 0.95f),
              red = color(k, "tomato", {0.5f, 0.04f, 0.02f}, 0.3f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.board(wood, {sx * (0.5f * s.x - 0.06f), 0, sz * (0.5f * s.z - 0.06f)}, {0.07f, s.y - 0.03f, 0.07f},
                    0.006f);
    for (int i = 0; i < 6; ++i)
        k.board(wood, {0, s.y - 0.03f, s.z * ((static_cast<float>(i) + 0.5f) / 6 - 0.5f)},
                {s.x, 0.03f, s.z / 6 - 0.012f}, 0.003f),
            k.board(wood, {0, 0.25f, s.z * ((static_cast<float>(i) + 0.5f) / 6 - 0.5f) * 0.9f},
                    {s.x - 0.1f, 0.02f, s.z / 6 - 0.03f}, 0.003f);
    const std::array<Vec2f, 3> pot{Vec2f{0.06f, 0}, {0.085f, 0.15f}, {0.095f, 0.155f}};
    for (int row = 0; row < 3; ++row)
        for (int i = 0; i < 7; ++i) {
            const Vec3f at{-0.5f * s.x + s.x * (static_cast<float>(i) + 0.5f) / 7, s.y,
                           (static_cast<float>(row) - 1.f) * 0.24f};
            k.add(shapes::vessel(pot, 0.008f, 12), clay, at),
                k.add(shapes::prism(shapes::circle(0.075f, 12), 0.12f, 0.13f, 0.001f), soil, at);
            const bool tall = row == 0 && i % 2 == 0;
            const int leaves = tall ? 12 : 7;
            for (int l = 0; l < leaves; ++l) {
                const float a = k.rng.uniform(0, kTau),
                            h = 0.14f + (tall ? 0.05f * static_cast<float>(l) : k.rng.uniform(0.f, 0.14f)),
                            r = k.rng.uniform(0.03f, 0.09f);
                k.add(shapes::ball({0, 0, 0}, {0.05f, 0.018f, 0.035f}, 6), l % 3 ? leaf : pale,
                      at + Vec3f{r * std::cos(a), h, r * std::sin(a)});
                if (tall && l % 4 == 2)
                    k.add(shapes::ball({0, 0, 0}, {0.028f, 0.026f, 0.028f}, 8), red,
                          at + Vec3f{-r * std::cos(a), h, -r * std::sin(a)});
            }
            if (tall) k.rod(wood, at + Vec3f{0, 0.1f, 0}, at + Vec3f{0, 0.75f, 0}, 0.008f, -1, 6);
        }
    k.piece.clearance_front_m = 0.7f;
}

// Two machines of a laundromat one above the other, with large round doors.
void build_laundry_tower(Kit& k) {
    const Vec3f s = k.wanted({0.75f, 1.95f, 0.8f});
    const int body = k.main(plain("machine steel", {0.5f, 0.51f, 0.52f}, 0.3f)), chrome = k.material(steel()),
              dark = color(k, "drum", {0.02f, 0.022f, 0.025f}, 0.15f),
              panel = color(k, "panel", {0.04f, 0.12f, 0.35f}, 0.35f),
              led = color(k, "button", {0.7f, 0.55f, 0.05f}, 0.3f);
    for (int i = 0; i < 2; ++i) {
        const float y = 0.5f * s.y * static_cast<float>(i), h = 0.5f * s.y, z = 0.5f * s.z;
        k.board(body, {0, y + 0.01f, -0.01f}, {s.x - 0.01f, h - 0.015f, s.z - 0.03f}, 0.012f),
            k.board(panel, {0, y + h - 0.17f, z - 0.03f}, {s.x - 0.06f, 0.12f, 0.02f}, 0.004f);
        for (int b = 0; b < 4; ++b)
            k.rod(led, {0.1f + 0.05f * static_cast<float>(b), y + h - 0.11f, z - 0.02f},
                  {0.1f + 0.05f * static_cast<float>(b), y + h - 0.11f, z - 0.008f}, 0.014f, -1, 10);
        Mesh rim = shapes::ring(0.25f, 0.05f, 32), pane = shapes::ball({0, 0, 0}, {0.22f, 0.22f, 0.05f}, 24);
        shapes::turn(rim, {1, 0, 0}, 90);
        k.add(std::move(rim), chrome, {0, y + 0.42f, z - 0.03f}),
            k.add(std::move(pane), dark, {0, y + 0.42f, z - 0.05f}),
            k.board(chrome, {0.27f, y + 0.37f, z - 0.01f}, {0.05f, 0.1f, 0.03f}, 0.01f);
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.9f;
}

// A range of burners over ovens, with pans.
void build_gas_range(Kit& k) {
    const Vec3f s = k.wanted({1.6f, 0.9f, 0.85f});
    const int body = k.main(steel()), dark = color(k, "cast iron", {0.025f, 0.025f, 0.026f}, 0.6f),
              knob = color(k, "knob", {0.04f, 0.04f, 0.04f}, 0.3f), pan = k.material(*material_named("copper"));
    k.board(dark, {0, 0, 0}, {s.x - 0.1f, 0.12f, s.z - 0.1f}),
        k.board(body, {0, 0.12f, 0}, {s.x, s.y - 0.12f, s.z}, 0.01f),
        k.board(body, {0, s.y, -0.5f * s.z + 0.03f}, {s.x, 0.3f, 0.05f}, 0.01f);
    const int doors = 2, burners = std::max(2, static_cast<int>(s.x / 0.4f));
    for (int i = 0; i < doors; ++i) {
        const float x = s.x * ((static_cast<float>(i) + 0.5f) / doors - 0.5f);
        k.board(dark, {x, 0.3f, 0.5f * s.z}, {0.5f * s.x - 0.2f, 0.26f, 0.01f}, 0.003f),
            k.rod(body, {x - 0.25f, 0.64f, 0.5f * s.z + 0.04f}, {x + 0.25f, 0.64f, 0.5f * s.z + 0.04f}, 0.014f);
    }
    for (int i = 0; i < 2 * burners; ++i)
        k.rod(knob,
              {s.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(2 * burners) - 0.5f), 0.77f, 0.5f * s.z},
              {s.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(2 * burners) - 0.5f), 0.77f,
               0.5f * s.z + 0.035f},
              0.025f, 0.02f, 12);
    for (int i = 0; i < burners; ++i)
        for (const float sz : {-1.f, 1.f}) {
            const float x = s.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(burners) - 0.5f), z = sz * 0.2f;
            for (int b = -1; b <= 1; ++b)
                k.board(dark, {x + 0.1f * static_cast<float>(b), s.y, z}, {0.018f, 0.03f, 0.32f}, 0.003f),
                    k.board(dark, {x, s.y, z + 0.1f * static_cast<float>(b)}, {0.34f, 0.03f, 0.018f}, 0.003f);
            if (!k.rng.chance(0.5f)) continue;
            const std::array<Vec2f, 2> wall{Vec2f{0.13f, 0}, {0.14f, k.rng.chance(0.5f) ? 0.22f : 0.07f}};
            k.add(shapes::vessel(wall, 0.004f, 20), k.rng.chance(0.5f) ? pan : body, {x, s.y + 0.03f, z}),
                k.rod(dark, {x, s.y + 0.08f, z + 0.13f}, {x + 0.04f, s.y + 0.1f, z + 0.34f}, 0.011f);
        }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.9f;
}

// A steel table with a shelf of pots below and boards and bowls on top.
void build_steel_table(Kit& k) {
    const Vec3f s = k.wanted({1.8f, 0.9f, 0.75f});
    const int body = k.main(steel()), wood = k.material(materials::timber("natural", 0.7f)),
              white = k.material(porcelain());
    k.board(body, {0, s.y - 0.04f, 0}, {s.x, 0.04f, s.z}, 0.006f),
        k.board(body, {0, 0.28f, 0}, {s.x - 0.08f, 0.025f, s.z - 0.08f}, 0.004f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.board(body, {sx * (0.5f * s.x - 0.05f), 0, sz * (0.5f * s.z - 0.05f)}, {0.045f, s.y - 0.04f, 0.045f},
                    0.004f);
    for (int i = 0; i < 4; ++i) {
        const float r = 0.14f + 0.02f * static_cast<float>(i % 2);
        const std::array<Vec2f, 2> wall{Vec2f{r, 0}, {r, 0.16f + 0.05f * static_cast<float>(i % 3)}};
        k.add(shapes::vessel(wall, 0.004f, 20), body, {-0.38f * s.x + 0.25f * s.x * static_cast<float>(i), 0.305f, 0});
    }
    k.board(wood, {-0.25f * s.x, s.y, 0.08f}, {0.45f, 0.03f, 0.3f}, 0.008f);
    const std::array<Vec2f, 3> bowl{Vec2f{0.06f, 0}, {0.13f, 0.05f}, {0.16f, 0.11f}};
    k.add(shapes::vessel(bowl, 0.006f, 20), body, {0.2f * s.x, s.y, 0.05f});
    const std::array<Vec2f, 2> dish{Vec2f{0.12f, 0}, {0.13f, 0.012f}};
    for (int i = 0; i < 9; ++i)
        k.add(shapes::lathe(dish, 20, true), white, {0.4f * s.x, s.y + 0.013f * static_cast<float>(i), -0.1f});
    k.top(s.y, 0, -0.2f, 0.3f * s.x, 0.12f);
    k.piece.clearance_front_m = 0.8f;
}

// A steel hood with filters, at the wall above the range.
void build_extractor_hood(Kit& k) {
    const Vec3f s = k.wanted({2.0f, 0.6f, 0.9f});
    const int body = k.main(steel()), dark = color(k, "filter", {0.12f, 0.12f, 0.12f}, 0.5f),
              lamp = k.material(glow("hood light", {5, 4.7f, 4.2f}));
    k.board(body, {0, 0, 0.5f * s.z}, {s.x, 0.14f, s.z}, 0.006f);
    for (int i = 0; i < 4; ++i) {
        const float t = static_cast<float>(i) / 4;
        k.board(body, {0, 0.14f + 0.11f * static_cast<float>(i), 0.5f * s.z * (1.f - 0.5f * t) - 0.02f},
                {s.x * (1.f - 0.12f * t), 0.112f, s.z * (1.f - 0.5f * t) - 0.04f}, 0.004f);
    }
    for (int i = 0; i < 5; ++i)
        k.board(dark, {s.x * ((static_cast<float>(i) + 0.5f) / 5 - 0.5f), -0.004f, 0.5f * s.z},
                {s.x / 5 - 0.05f, 0.01f, s.z - 0.2f}, 0.002f);
    k.board(lamp, {0, -0.008f, s.z - 0.07f}, {s.x - 0.3f, 0.012f, 0.06f}, 0.002f);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.95f;
}

// Steel bars from floor to ceiling height, with a door in them.
void build_cell_bars(Kit& k) {
    const Vec3f s = k.wanted({2.2f, 2.3f, 0.08f});
    const int iron = k.main(plain("bars", {0.1f, 0.105f, 0.11f}, 0.5f));
    for (const float y : {0.f, 0.5f * s.y, s.y - 0.06f}) k.board(iron, {0, y, 0}, {s.x, 0.06f, 0.02f}, 0.003f);
    for (float x = -0.5f * s.x + 0.03f; x < 0.5f * s.x; x += 0.115f) k.rod(iron, {x, 0, 0}, {x, s.y, 0}, 0.013f, -1, 8);
    k.board(iron, {0.15f * s.x, 0.95f, 0.02f}, {0.14f, 0.18f, 0.04f}, 0.006f);
    for (const float x : {0.12f * s.x - 0.42f, 0.12f * s.x + 0.42f})
        k.board(iron, {x, 0, 0}, {0.05f, s.y, 0.04f}, 0.004f);
    k.piece.clearance_front_m = 0.3f;
}

void build_vending_machine(Kit& k) {
    const Vec3f s = k.wanted({0.95f, 1.83f, 0.8f});
    const int body = k.main(plain("machine lacquer", k.accent(), 0.3f)),
              inner = color(k, "liner", {0.7f, 0.7f, 0.68f}, 0.5f),
              dark = color(k, "slot", {0.02f, 0.02f, 0.02f}, 0.4f),
              lamp = k.material(glow("inner light", {5, 4.9f, 4.6f}));
    k.board(body, {0, 0, -0.12f}, {s.x, s.y, s.z - 0.24f}, 0.012f), k.board(body, {0, 0, 0}, {s.x, 0.42f, s.z}, 0.012f),
        k.board(body, {0, s.y - 0.12f, 0}, {s.x, 0.12f, s.z}, 0.012f),
        k.board(body, {0.5f * s.x - 0.12f, 0.42f, 0}, {0.24f, s.y - 0.54f, s.z}, 0.01f),
        k.board(body, {-0.5f * s.x + 0.03f, 0.42f, 0}, {0.06f, s.y - 0.54f, s.z}, 0.01f);
    k.board(inner, {-0.09f, 0.42f, 0.165f}, {s.x - 0.3f, s.y - 0.54f, 0.01f}, 0.002f),
        k.board(lamp, {-0.09f, s.y - 0.15f, 0.34f}, {s.x - 0.34f, 0.025f, 0.03f}, 0.004f);
    for (int i = 0; i < 5; ++i) {
        const float y = 0.44f + 0.245f * static_cast<float>(i);
        k.board(inner, {-0.09f, y, 0.27f}, {s.x - 0.32f, 0.012f, 0.2f}, 0.002f),
            stock(k, i < 3 ? Goods::packets : Goods::bottles, -0.5f * s.x + 0.07f, 0.5f * s.x - 0.26f, y + 0.012f,
                  0.21f, 0.36f, 0.2f);
    }
    k.board(dark, {-0.09f, 0.14f, 0.5f * s.z - 0.004f}, {0.56f, 0.18f, 0.01f}, 0.003f),
        k.board(dark, {0.5f * s.x - 0.12f, 1.05f, 0.5f * s.z}, {0.14f, 0.22f, 0.012f}, 0.004f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.8f;
}

// A panel of light set below the ceiling of offices, shops and schools.
void build_light_panel(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 0.06f, 0.32f});
    const int frame = k.main(plain("panel frame", {0.72f, 0.72f, 0.71f}, 0.5f)),
              lamp = k.material(glow("panel light", {7.5f, 7.1f, 6.4f}));
    k.board(frame, {0, -s.y, 0}, {s.x, s.y, s.z}, 0.006f),
        k.board(lamp, {0, -s.y - 0.004f, 0}, {s.x - 0.05f, 0.012f, s.z - 0.05f}, 0.002f);
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
