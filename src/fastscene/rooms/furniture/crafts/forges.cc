// Of smithies, cauldrons, breweries and boiler rooms: what is heated.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// A kettle of copper with bands and a neck, its foot at `at`.
void copper_still(Kit& k, int copper, int brass, Vec3f at, float r, float high) {
    const std::array<Vec2f, 9> p{Vec2f{0.75f * r, 0},       {r, 0.16f * high},         {r, 0.5f * high},
                                 {0.85f * r, 0.62f * high}, {0.45f * r, 0.74f * high}, {0.24f * r, 0.8f * high},
                                 {0.2f * r, 0.96f * high},  {0.26f * r, 0.98f * high}, {0.1f * r, high}};
    k.add(shapes::lathe(shapes::curve(p, 3), 32, true), copper, at);
    for (const float y : {0.18f, 0.5f}) k.add(shapes::ring(r, 0.03f, 36), brass, at + Vec3f{0, y * high, 0});
}

}  // namespace

// A hearth of brick with glowing coals under a hood, its bellows beside.
void build_forge(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 2.3f, 1.1f});
    const int brick = k.main(*material_named("brick")), soot = color(k, "soot", {0.02f, 0.019f, 0.018f}, 0.95f),
              iron = k.material(*material_named("iron")), coal = color(k, "coal", {0.015f, 0.015f, 0.016f}, 0.7f),
              leather = color(k, "bellows", {0.17f, 0.08f, 0.035f}, 0.7f), wood = k.material(k.style.wood);
    const int ember = k.material(flame("embers", {9, 1.9f, 0.15f})),
              hot = k.material(flame("hot coals", {17, 6.5f, 0.7f}));
    k.board(brick, {0, 0, 0}, {s.x, 0.72f, s.z}, 0.01f),
        k.board(soot, {0, 0.72f, 0.02f}, {s.x - 0.3f, 0.02f, s.z - 0.3f}, 0.004f);
    for (const float side : {-1.f, 1.f})
        k.board(brick, {side * (s.x / 2 - 0.08f), 0.72f, 0}, {0.16f, 0.14f, s.z}, 0.008f);
    k.board(brick, {0, 0.72f, -s.z / 2 + 0.1f}, {s.x, 0.75f, 0.2f}, 0.008f);
    for (int i = 0; i < 60; ++i) {
        const float a = k.rng.uniform(0, kTau), r = 0.36f * std::sqrt(k.rng.uniform(0, 1)),
                    size = k.rng.uniform(0.025f, 0.05f);
        k.add(shapes::ball({r * std::cos(a) * 1.3f, 0.75f + 0.06f * (1 - r / 0.36f), 0.05f + r * std::sin(a)},
                           {size, 0.7f * size, size}, 7),
              r < 0.14f   ? hot
              : r < 0.26f ? ember
                          : coal);
    }
    // The hood: four sides that narrow to the flue.
    k.add(shapes::sheet(4, 1,
                        [&](float u, float v) {
                            const std::array<Vec2f, 5> corner{Vec2f{-1, -1}, {-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
                            const Vec2f c = corner[static_cast<std::size_t>(std::lround(4 * u))];
                            return Vec3f{c.x * std::lerp(0.62f, 0.2f, v), std::lerp(1.35f, 1.85f, v),
                                         std::lerp(0.f, -0.2f, v) + c.y * std::lerp(0.48f, 0.17f, v)};
                        }),
          iron);
    k.board(iron, {0, 1.85f, -0.2f}, {0.4f, s.y - 1.85f, 0.34f}, 0.01f);
    // Tongs and pokers hang at the front, a poker lies in the coals.
    for (int i = 0; i < 4; ++i)
        k.rod(iron, {-0.5f + 0.33f * static_cast<float>(i), 0.2f, s.z / 2 + 0.02f},
              {-0.5f + 0.33f * static_cast<float>(i), 0.68f, s.z / 2 + 0.02f}, 0.011f, -1, 6);
    k.rod(iron, {0.06f, 0.8f, 0.05f}, {0.3f, 0.86f, s.z / 2 + 0.12f}, 0.012f, -1, 6);
    Mesh sack = shapes::soft_box({0.3f, 0.34f, 0.6f}, {0.06f, 0.03f, 0.01f, 14, k.seed()});
    k.add(std::move(sack), leather, {s.x / 2 + 0.22f, 0.72f, -0.1f});
    for (const float y : {0.52f, 0.9f}) k.board(wood, {s.x / 2 + 0.22f, y, -0.1f}, {0.34f, 0.03f, 0.66f}, 0.006f);
    k.board(wood, {s.x / 2 + 0.22f, 0, -0.1f}, {0.3f, 0.52f, 0.4f}, 0.01f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 1.0f;
}

// An anvil on a stump, a hammer across it.
void build_anvil(Kit& k) {
    const int iron = k.main(plain("anvil", {0.1f, 0.1f, 0.105f}, 0.35f)), face = k.material(steel()),
              handle = k.material(k.style.wood), hot = lit(k, "hot iron", {6, 1.4f, 0.15f});
    Material bark = plain("stump", {0.2f, 0.12f, 0.07f}, 0.9f);
    bark.pattern = Pattern::bark, bark.color_b = {0.1f, 0.06f, 0.03f}, bark.scale_m = 0.08f, bark.bump_m = 0.003f;
    const std::array<Vec2f, 3> stump{Vec2f{0.3f, 0}, {0.27f, 0.1f}, {0.27f, 0.5f}};
    k.add(shapes::lathe(stump, 22), k.material(bark));
    k.add(shapes::ring(0.275f, 0.014f, 24), iron, {0, 0.42f, 0});
    k.board(iron, {0, 0.5f, 0}, {0.32f, 0.07f, 0.24f}, 0.015f),
        k.board(iron, {0, 0.57f, 0}, {0.16f, 0.1f, 0.13f}, 0.02f),
        k.board(iron, {0.02f, 0.66f, 0}, {0.44f, 0.1f, 0.15f}, 0.012f);
    k.board(face, {0.02f, 0.755f, 0}, {0.43f, 0.008f, 0.14f}, 0.002f);
    k.rod(iron, {-0.18f, 0.715f, 0}, {-0.46f, 0.745f, 0}, 0.055f, 0.01f, 16);
    k.rod(handle, {0.16f, 0.79f, -0.05f}, {-0.1f, 0.79f, 0.22f}, 0.014f, -1, 8),
        k.board(iron, {0.16f, 0.763f, -0.05f}, {0.07f, 0.055f, 0.13f}, 0.01f);
    k.rod(hot, {-0.1f, 0.772f, 0.02f}, {0.02f, 0.772f, -0.02f}, 0.011f, -1, 6),
        k.rod(iron, {-0.1f, 0.772f, 0.02f}, {-0.42f, 0.79f, 0.14f}, 0.011f, -1, 6);
    k.piece.clearance_front_m = 0.6f;
}

// A cauldron over a fire, its brew aglow.
void build_cauldron(Kit& k) {
    const int iron = k.main(plain("cauldron", {0.03f, 0.03f, 0.032f}, 0.5f)),
              brew = lit(k, "brew", {0.35f, 2.6f, 0.4f}), bubble = lit(k, "bubble", {0.7f, 3.6f, 0.8f}),
              wood = color(k, "log", {0.16f, 0.09f, 0.05f}, 0.95f),
              stone = color(k, "hearth stone", {0.2f, 0.19f, 0.17f}, 0.9f);
    const int fire = k.material(flame("fire", {9, 2.6f, 0.3f}));
    const std::array<Vec2f, 7> pot{Vec2f{0.12f, 0.3f}, {0.32f, 0.36f}, {0.42f, 0.52f}, {0.41f, 0.68f},
                                   {0.33f, 0.82f},     {0.36f, 0.86f}, {0.4f, 0.88f}};
    k.add(shapes::vessel(shapes::curve(pot, 3), 0.02f, 30), iron),
        k.add(shapes::ring(0.39f, 0.03f, 30), iron, {0, 0.88f, 0});
    k.add(shapes::prism(shapes::circle(0.34f, 28), 0.78f, 0.79f, 0.002f), brew);
    for (int i = 0; i < 14; ++i) {
        const Vec3f out = around(k.rng.uniform(0, kTau)) * k.rng.uniform(0.05f, 0.29f);
        const float r = k.rng.uniform(0.02f, 0.05f);
        k.add(shapes::ball(out + Vec3f{0, 0.79f, 0}, {r, 0.7f * r, r}, 10), bubble);
    }
    for (int i = 0; i < 3; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / 3);
        k.rod(iron, out * 0.34f + Vec3f{0, 0.44f, 0}, out * 0.42f, 0.028f, 0.02f, 8);
        k.rod(wood, out * 0.3f + Vec3f{0, 0.04f, 0}, out * -0.12f + Vec3f{0, 0.12f, 0}, 0.035f, -1, 8);
    }
    for (const float side : {-1.f, 1.f}) {
        Mesh ring = shapes::ring(0.07f, 0.014f, 18);
        shapes::turn(ring, {1, 0, 0}, 90);
        k.add(std::move(ring), iron, {side * 0.44f, 0.72f, 0});
    }
    for (int i = 0; i < 7; ++i) {
        const Vec3f at = around(kTau * static_cast<float>(i) / 7) * 0.14f;
        const std::array<Vec2f, 5> p{
            Vec2f{0.001f, 0}, {0.035f, 0.03f}, {0.04f, 0.07f}, {0.018f, 0.15f}, {0.001f, 0.21f}};
        k.add(shapes::lathe(p, 9, true), fire, at + Vec3f{0, 0.06f, 0});
    }
    for (int i = 0; i < 10; ++i) {
        const Vec3f at = around(kTau * static_cast<float>(i) / 10) * 0.46f;
        k.add(shapes::ball(at + Vec3f{0, 0.06f, 0}, {0.1f, 0.07f, 0.08f}, 9), stone);
    }
    // A ladle.
    k.rod(wood, {0.1f, 0.78f, 0.05f}, {0.36f, 1.2f, 0.16f}, 0.014f, -1, 8);
    k.piece.clearance_front_m = 0.6f;
}

// Two coppers with domes, their pipe, and a platform rail.
void build_brew_kettle(Kit& k) {
    const Vec3f s = k.wanted({2.7f, 2.4f, 1.3f});
    const int copper = k.main(*material_named("copper")), brass = k.material(*material_named("brass")),
              metal = k.material(steel()), stone = k.material(*material_named("stone")),
              dial = color(k, "dial", {0.7f, 0.68f, 0.6f}, 0.5f);
    k.board(stone, {0, 0, 0}, {s.x, 0.18f, s.z}, 0.01f);
    const float r = std::min(0.25f * s.x - 0.04f, s.z / 2 - 0.06f);
    for (const float side : {-1.f, 1.f}) {
        copper_still(k, copper, brass, {side * 0.25f * s.x, 0.18f, 0}, r, s.y - 0.22f);
        // A manhole and a thermometer at the front.
        Mesh hole = shapes::ring(0.15f, 0.03f, 24);
        shapes::turn(hole, {1, 0, 0}, 90);
        k.add(std::move(hole), brass, {side * 0.25f * s.x, 0.85f, r - 0.01f});
        k.add(shapes::ball({side * 0.25f * s.x, 0.85f, r - 0.03f}, {0.15f, 0.15f, 0.05f}, 18), copper);
        k.add(shapes::ball({side * 0.25f * s.x + 0.28f, 1.1f, 0.88f * r}, {0.06f, 0.06f, 0.03f}, 14), dial);
        k.rod(metal, {side * 0.25f * s.x, 0.3f, r - 0.05f}, {side * 0.25f * s.x, 0.3f, r + 0.1f}, 0.03f, -1, 10),
            k.rod(brass, {side * 0.25f * s.x - 0.07f, 0.36f, r + 0.06f}, {side * 0.25f * s.x + 0.07f, 0.36f, r + 0.06f},
                  0.012f, -1, 8);
    }
    const float y = s.y - 0.1f, x = 0.25f * s.x;
    const std::array<Vec3f, 6> pipe{Vec3f{-x, y - 0.05f, 0},  {-0.8f * x, y + 0.02f, 0}, {-0.3f * x, y + 0.04f, 0},
                                    {0.3f * x, y + 0.04f, 0}, {0.8f * x, y + 0.02f, 0},  {x, y - 0.05f, 0}};
    k.add(shapes::tube(pipe, 0.05f, 14), copper);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.8f;
}

// A boiler that lies, with its door, gauges, valves and pipes.
void build_boiler(Kit& k) {
    const Vec3f s = k.wanted({1.9f, 2.2f, 2.3f});
    const int shell = k.main(plain("boiler paint", {0.07f, 0.15f, 0.12f}, 0.45f)),
              iron = k.material(*material_named("iron")), brass = k.material(*material_named("brass")),
              copper = k.material(*material_named("copper")), dial = color(k, "dial", {0.72f, 0.7f, 0.62f}, 0.5f),
              red = color(k, "valve wheel", {0.5f, 0.04f, 0.03f}, 0.35f), brick = k.material(*material_named("brick")),
              dark = color(k, "needle", {0.02f, 0.02f, 0.02f}, 0.5f);
    const int ember = k.material(flame("boiler fire", {10, 3, 0.35f}));
    const float r = 0.68f, y = 1.0f, front = s.z / 2 - 0.22f;
    k.board(brick, {0, 0, -0.1f}, {1.2f, 0.42f, s.z - 0.5f}, 0.01f);
    k.rod(shell, {0, y, -s.z / 2 + 0.1f}, {0, y, front}, r, -1, 40);
    for (float z = -s.z / 2 + 0.2f; z < front; z += 0.5f) {
        k.rod(iron, {0, y, z}, {0, y, z + 0.06f}, r + 0.015f, -1, 40);
        for (int i = 0; i < 20; ++i) {
            const float a = kTau * static_cast<float>(i) / 20;
            k.add(shapes::ball({(r + 0.015f) * std::cos(a), y + (r + 0.015f) * std::sin(a), z + 0.03f},
                               {0.015f, 0.015f, 0.015f}, 6),
                  iron);
        }
    }
    // The fire door, with a grate one sees the fire through.
    k.board(iron, {0, 0.5f, front + 0.03f}, {0.62f, 0.44f, 0.06f}, 0.03f);
    k.board(ember, {0, 0.58f, front + 0.062f}, {0.46f, 0.26f, 0.006f}, 0.002f);
    for (int i = 0; i < 7; ++i)
        k.board(iron, {-0.21f + 0.07f * static_cast<float>(i), 0.56f, front + 0.068f}, {0.025f, 0.3f, 0.014f}, 0.004f);
    for (const float side : {-1.f, 1.f}) {
        for (const auto& [size, thick, material] : {std::tuple{0.12f, 0.02f, brass}}) {
            Mesh ring = shapes::ring(size, thick, 22),
                 plate = shapes::prism(shapes::circle(size, 22), 0, 0.014f, 0.002f);
            for (Mesh* m : {&ring, &plate}) shapes::turn(*m, {1, 0, 0}, 90);
            k.add(std::move(plate), dial, {side * 0.3f, 1.32f, front + 0.02f}),
                k.add(std::move(ring), material, {side * 0.3f, 1.32f, front + 0.034f});
            k.rod(dark, {side * 0.3f, 1.32f, front + 0.038f}, {side * 0.3f + 0.07f, 1.37f, front + 0.038f}, 0.005f, -1,
                  6);
        }
        Mesh wheel = shapes::ring(0.1f, 0.022f, 22);
        shapes::turn(wheel, {1, 0, 0}, 90);
        k.add(std::move(wheel), red, {side * 0.52f, 1.0f, front + 0.14f});
        k.rod(brass, {side * 0.52f, 1.0f, front}, {side * 0.52f, 1.0f, front + 0.15f}, 0.02f, -1, 10);
        k.rod(red, {side * 0.52f - 0.1f, 1.0f, front + 0.14f}, {side * 0.52f + 0.1f, 1.0f, front + 0.14f}, 0.009f, -1,
              6);
        const std::array<Vec3f, 5> pipe{Vec3f{side * 0.4f, y + 0.5f, 0.3f},
                                        {side * 0.4f, s.y - 0.3f, 0.3f},
                                        {side * 0.5f, s.y - 0.12f, 0.3f},
                                        {side * 0.75f, s.y - 0.1f, 0.3f},
                                        {side * (s.x / 2 - 0.05f), s.y - 0.1f, 0.3f}};
        k.add(shapes::tube(pipe, 0.06f, 14), side > 0 ? copper : iron);
    }
    k.rod(iron, {0, y + r - 0.05f, -0.5f}, {0, s.y, -0.5f}, 0.16f, -1, 24);
    k.rod(brass, {0, 1.5f, front + 0.03f}, {0, 1.68f, front + 0.03f}, 0.02f, -1, 10);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.9f;
}

// An owl on a perch.
void build_owl(Kit& k) {
    const int down = k.main(plain("feathers", {0.33f, 0.23f, 0.14f}, 0.95f)),
              pale = color(k, "breast", {0.56f, 0.48f, 0.36f}, 0.95f),
              eye = color(k, "eye", {0.75f, 0.4f, 0.02f}, 0.1f), dark = color(k, "pupil", {0.01f, 0.01f, 0.01f}, 0.1f),
              wood = k.material(k.style.wood), beak = color(k, "beak", {0.1f, 0.08f, 0.05f}, 0.4f);
    k.add(shapes::prism(shapes::circle(0.22f, 24), 0, 0.03f, 0.006f), wood),
        k.rod(wood, {0, 0.03f, 0}, {0, 1.2f, 0}, 0.022f, -1, 10),
        k.rod(wood, {-0.24f, 1.2f, 0}, {0.24f, 1.2f, 0}, 0.02f, -1, 10);
    const std::array<Limb, 3> body{Limb{{0, 1.3f, -0.02f}, {0, 1.44f, 0}, 0.1f, 0.11f},
                                   {{0, 1.44f, 0}, {0, 1.56f, 0.01f}, 0.1f, 0.095f},
                                   {{0, 1.26f, -0.07f}, {0, 1.12f, -0.1f}, 0.05f, 0.03f}};
    k.add(shapes::skin(body, 0.03f, 0.018f), down);
    k.add(shapes::ball({0, 1.38f, 0.05f}, {0.085f, 0.12f, 0.07f}, 16), pale);
    for (const float side : {-1.f, 1.f}) {
        k.add(shapes::ball({side * 0.045f, 1.57f, 0.075f}, {0.042f, 0.042f, 0.025f}, 14), pale),
            k.add(shapes::ball({side * 0.045f, 1.57f, 0.092f}, {0.024f, 0.024f, 0.014f}, 12), eye),
            k.add(shapes::ball({side * 0.045f, 1.57f, 0.103f}, {0.012f, 0.012f, 0.006f}, 10), dark);
        k.rod(down, {side * 0.06f, 1.62f, 0.02f}, {side * 0.085f, 1.72f, 0}, 0.022f, 0.004f, 8);
        k.add(shapes::ball({side * 0.1f, 1.38f, -0.01f}, {0.03f, 0.13f, 0.08f}, 14), down);
        k.rod(beak, {side * 0.035f, 1.2f, 0}, {side * 0.035f, 1.25f, 0.03f}, 0.014f, -1, 6);
    }
    k.rod(beak, {0, 1.55f, 0.1f}, {0, 1.515f, 0.115f}, 0.014f, 0.003f, 8);
}

}  // namespace fastscene::furniture
