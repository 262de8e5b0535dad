// Of gardens and sheds: a raised bed, cans, pots and tools, a trellis, a barrow, a mower.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// Leaves that stand out from a point.
void garden_leaves(Kit& k, int leaf, Vec3f at, float size, int count) {
    for (int i = 0; i < count; ++i) {
        const Vec3f d = around(kTau * (static_cast<float>(i) + k.rng.uniform(0.f, 0.8f)) / static_cast<float>(count)),
                    side{-d.z, 0, d.x};
        const float l = size * k.rng.uniform(0.7f, 1.1f), up = k.rng.uniform(0.5f, 1.1f);
        k.add(shapes::slab(2, 3, 0.002f,
                           [&](float u, float v) {
                               return at + d * (l * 0.8f * v) + Vec3f{0, l * (up * v - 0.55f * v * v), 0} +
                                      side * ((u - 0.5f) * 0.5f * l * std::sin(kPi * (0.12f + 0.86f * v)));
                           }),
              leaf);
    }
}

}  // namespace

// A box of boards full of earth, lettuces and herbs.
void build_planter_box(Kit& k) {
    const Vec3f s = k.wanted({1.3f, 0.6f, 0.5f});
    const int wood = k.main(materials::timber("natural", 0.75f)),
              earth = color(k, "earth", {0.06f, 0.04f, 0.025f}, 0.98f),
              green = color(k, "leaves", {0.1f, 0.3f, 0.05f}, 0.7f),
              pale = color(k, "lettuce", {0.28f, 0.45f, 0.08f}, 0.7f),
              purple = color(k, "blossom", {0.35f, 0.1f, 0.4f}, 0.7f);
    const float low = 0.06f, step = (s.y - 0.22f) / 3;
    for (int i = 0; i < 3; ++i) {
        const float y = low + step * static_cast<float>(i);
        for (const float e : {-1.f, 1.f})
            k.board(wood, {0, y, e * (0.5f * s.z - 0.015f)}, {s.x - 0.02f, step - 0.008f, 0.028f}, 0.004f),
                k.board(wood, {e * (0.5f * s.x - 0.025f), y, 0}, {0.028f, step - 0.008f, s.z - 0.06f}, 0.004f);
    }
    const float top = low + 3 * step;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.board(wood, {sx * (0.5f * s.x - 0.04f), 0, sz * (0.5f * s.z - 0.04f)}, {0.07f, top + 0.02f, 0.07f},
                    0.006f);
    block(k, earth, {0, top - 0.1f, 0}, {s.x - 0.06f, 0.07f, s.z - 0.06f});
    const int n = std::max(2, static_cast<int>(s.x / 0.22f));
    for (int row = 0; row < 2; ++row)
        for (int i = 0; i < n; ++i) {
            const Vec3f at{-0.5f * s.x + 0.1f + (s.x - 0.2f) * (static_cast<float>(i) + 0.5f) / static_cast<float>(n),
                           top - 0.035f, (row ? 0.22f : -0.22f) * s.z};
            if (row == 1) garden_leaves(k, pale, at, 0.1f, 9);
            else {
                garden_leaves(k, green, at, 0.17f, 8);
                if (i % 2)
                    for (int b = 0; b < 4; ++b)
                        k.add(shapes::ball(at + Vec3f{k.rng.uniform(-0.05f, 0.05f), k.rng.uniform(0.1f, 0.17f),
                                                      k.rng.uniform(-0.05f, 0.05f)},
                                           {0.012f, 0.016f, 0.012f}, 6),
                              purple);
            }
        }
}

void build_watering_can(Kit& k) {
    const int zinc = k.main(plain("zinc", {0.42f, 0.44f, 0.45f}, 0.35f));
    k.piece.materials[static_cast<std::size_t>(zinc)].metal = 0.7f;
    k.add(shapes::vessel(
              std::array<Vec2f, 5>{Vec2f{0.095f, 0}, {0.1f, 0.006f}, {0.09f, 0.2f}, {0.094f, 0.205f}, {0.09f, 0.21f}},
              0.004f, 24),
          zinc),
        k.add(shapes::slab(6, 4, 0.004f,
                           [](float u, float v) {
                               const float a = kPi * u;
                               return Vec3f{-0.088f * std::sin(a), 0.21f + 0.012f * std::sin(kPi * v),
                                            0.088f * std::cos(a) * (1 - v)};
                           }),
              zinc);
    k.rod(zinc, {0.07f, 0.05f, 0}, {0.3f, 0.28f, 0}, 0.022f, 0.013f, 12),
        k.rod(zinc, {0.295f, 0.275f, 0}, {0.335f, 0.315f, 0}, 0.014f, 0.045f, 16),
        k.rod(zinc, {0.05f, 0.2f, 0}, {0.2f, 0.19f, 0}, 0.006f, -1, 6);
    k.add(shapes::tube(std::vector<Vec3f>{{0.05f, 0.21f, 0},
                                          {0.02f, 0.29f, 0},
                                          {-0.06f, 0.31f, 0},
                                          {-0.15f, 0.25f, 0},
                                          {-0.16f, 0.14f, 0},
                                          {-0.09f, 0.06f, 0}},
                       0.01f, 8),
          zinc);
    on_surface(k);
}

// Spades, a rake, a fork and a broom on a wall.
void build_garden_tools(Kit& k) {
    const int wood = k.main(materials::timber("natural", 0.6f)),
              iron = color(k, "tool steel", {0.12f, 0.12f, 0.125f}, 0.5f), rail = k.material(k.style.wood),
              straw = color(k, "straw", {0.5f, 0.36f, 0.14f}, 0.95f),
              green = color(k, "green handle", {0.04f, 0.2f, 0.08f}, 0.5f);
    k.board(rail, {0, 1.2f, 0.012f}, {1.3f, 0.1f, 0.024f}, 0.005f);
    for (int i = 0; i < 5; ++i) {
        const float x = -0.52f + 0.26f * static_cast<float>(i), z = 0.06f, low = i == 0 ? 0.32f : i == 4 ? 0.34f : 0.3f;
        k.rod(rail, {x - 0.03f, 1.24f, 0.02f}, {x - 0.03f, 1.26f, 0.09f}, 0.008f, -1, 6),
            k.rod(rail, {x + 0.03f, 1.24f, 0.02f}, {x + 0.03f, 1.26f, 0.09f}, 0.008f, -1, 6),
            k.rod(wood, {x, low, z}, {x, 1.42f, z}, 0.016f, -1, 10);
        const auto tine = [&](float dx, float y0, float y1) {
            k.rod(iron, {x + dx, y1, z}, {x + dx, y0, z + 0.02f}, 0.007f, 0.004f, 6);
        };
        if (i == 0)
            k.board(iron, {x, 0.02f, z}, {0.18f, 0.3f, 0.012f}, 0.005f),
                k.rod(green, {x - 0.06f, 1.42f, z}, {x + 0.06f, 1.42f, z}, 0.016f, -1, 8);
        if (i == 1) {
            k.rod(iron, {x - 0.09f, 0.3f, z}, {x + 0.09f, 0.3f, z}, 0.009f, -1, 6),
                k.rod(green, {x - 0.06f, 1.42f, z}, {x + 0.06f, 1.42f, z}, 0.016f, -1, 8);
            for (int t = 0; t < 4; ++t) tine(-0.085f + 0.057f * static_cast<float>(t), 0.02f, 0.3f);
        }
        if (i == 2) {
            k.rod(iron, {x - 0.18f, 0.3f, z}, {x + 0.18f, 0.3f, z}, 0.01f, -1, 6);
            for (int t = 0; t < 10; ++t) tine(-0.17f + 0.038f * static_cast<float>(t), 0.22f, 0.3f);
        }
        if (i == 3)
            k.board(iron, {x, 0.2f, z + 0.05f}, {0.16f, 0.1f, 0.012f}, 0.004f),
                k.rod(iron, {x, 0.32f, z}, {x, 0.26f, z + 0.05f}, 0.01f, -1, 6);
        if (i == 4)
            k.rod(straw, {x, 0.0f, z}, {x, 0.36f, z}, 0.11f, 0.03f, 12),
                k.rod(green, {x, 0.22f, z}, {x, 0.24f, z}, 0.063f, -1, 12);
    }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.25f;
}

// Empty flower pots, one in the other.
void build_pot_stack(Kit& k) {
    const int clay = k.main(plain("terracotta", {0.42f, 0.17f, 0.09f}, 0.85f));
    const auto pot = [&](Vec3f at, float r, float h, float lean) {
        Mesh m = shapes::vessel(
            std::array<Vec2f, 5>{
                Vec2f{0.66f * r, 0}, {0.92f * r, 0.78f * h}, {r, 0.78f * h}, {r, 0.99f * h}, {0.99f * r, h}},
            0.01f, 20);
        if (lean != 0.f) shapes::turn(m, {0, 0, 1}, lean);
        k.add(std::move(m), clay, at);
    };
    for (int i = 0; i < 5; ++i)
        pot({-0.12f + 0.004f * static_cast<float>(i % 2), 0.055f * static_cast<float>(i), 0}, 0.12f, 0.21f, 0);
    for (int i = 0; i < 4; ++i) pot({0.13f, 0.045f * static_cast<float>(i), 0.06f}, 0.09f, 0.16f, 0);
    pot({0.08f, 0.085f, -0.17f}, 0.09f, 0.17f, 90);
}

// A lattice with a climbing rose.
void build_trellis(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 1.9f, 0.14f});
    const int wood = k.main(materials::timber("natural", 0.7f)), stem = color(k, "stem", {0.16f, 0.1f, 0.05f}, 0.9f),
              leaf = color(k, "leaves", {0.08f, 0.25f, 0.05f}, 0.7f),
              rose = color(k, "roses", k.rng.chance(0.5f) ? Vec3f{0.6f, 0.05f, 0.1f} : Vec3f{0.72f, 0.6f, 0.6f}, 0.7f);
    const int columns = std::max(3, static_cast<int>(s.x / 0.2f)), rows = std::max(4, static_cast<int>(s.y / 0.22f));
    for (int i = 0; i <= columns; ++i)
        k.board(wood, {(s.x - 0.03f) * (static_cast<float>(i) / static_cast<float>(columns) - 0.5f), 0, 0.015f},
                {0.03f, s.y, 0.015f}, 0.002f);
    for (int i = 0; i < rows; ++i)
        k.board(wood, {0, 0.12f + (s.y - 0.18f) * static_cast<float>(i) / static_cast<float>(rows - 1), 0.028f},
                {s.x, 0.03f, 0.013f}, 0.002f);
    for (int v = 0; v < 4; ++v) {
        std::vector<Vec3f> path;
        const float x0 = (v - 1.5f) * 0.22f * s.x, end = k.rng.uniform(0.75f, 0.98f);
        for (int i = 0; i <= 12; ++i) {
            const float t = static_cast<float>(i) / 12;
            path.push_back({std::clamp(x0 * (0.5f + t) + 0.09f * std::sin(7 * t + static_cast<float>(v)), -0.48f * s.x,
                                       0.48f * s.x),
                            end * s.y * t, 0.05f});
        }
        k.add(shapes::tube(path, 0.009f, 5), stem);
        for (std::size_t i = 2; i < path.size(); ++i) {
            for (int n = 0; n < 6; ++n) {
                const Vec3f c = path[i] + Vec3f{k.rng.uniform(-0.09f, 0.09f), k.rng.uniform(-0.08f, 0.08f),
                                                k.rng.uniform(0.f, 0.04f)},
                            d = normalize(Vec3f{k.rng.uniform(-1.f, 1.f), k.rng.uniform(-0.6f, 0.8f), 0.5f}),
                            side = normalize(cross(d, Vec3f{0.2f, 0.3f, 1}));
                k.add(shapes::slab(1, 2, 0.002f,
                                   [&](float u, float w) {
                                       return c + d * (0.075f * w) +
                                              side * ((u - 0.5f) * 0.06f * std::sin(kPi * (0.15f + 0.8f * w)));
                                   }),
                      leaf);
            }
            if (k.rng.chance(0.45f))
                k.add(shapes::ball(path[i] + Vec3f{k.rng.uniform(-0.06f, 0.06f), 0.03f, 0.045f},
                                   {0.032f, 0.03f, 0.026f}, 8),
                      rose);
        }
    }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.02f;
}

void build_wheelbarrow(Kit& k) {
    const int tray = k.main(plain("barrow lacquer", {0.04f, 0.22f, 0.09f}, 0.4f)),
              wood = k.material(materials::timber("natural", 0.6f)),
              tire = color(k, "tire", {0.03f, 0.03f, 0.03f}, 0.8f), metal = k.material(steel()),
              earth = color(k, "earth", {0.07f, 0.045f, 0.03f}, 0.98f);
    Mesh wheel = shapes::ring(0.14f, 0.045f, 24);
    shapes::turn(wheel, {0, 0, 1}, 90), k.add(std::move(wheel), tire, {0, 0.185f, 0.55f}),
        k.rod(metal, {-0.04f, 0.185f, 0.55f}, {0.04f, 0.185f, 0.55f}, 0.1f, -1, 16);
    const auto corner = [](float u, float y) { return Vec3f{0.22f + 0.11f * y, 0.3f + 0.3f * y, u}; };
    for (const float s : {-1.f, 1.f}) {
        const Vec3f a = corner(0, 0), b = corner(0, 1);
        k.add(shapes::slab(
                  1, 1, 0.008f,
                  [&](float u, float v) {
                      return Vec3f{s * lerp(a, b, v).x, lerp(a, b, v).y, (0.32f + 0.1f * v) - (u * (0.7f + 0.16f * v))};
                  }),
              tray);
        k.add(shapes::slab(1, 1, 0.008f,
                           [&](float u, float v) {
                               const float x = (0.44f + 0.22f * v) * (u - 0.5f);
                               return Vec3f{x, 0.3f + 0.3f * v, s > 0 ? 0.32f + 0.1f * v : -0.38f - 0.06f * v};
                           }),
              tray);
        k.rod(wood, {s * 0.05f, 0.2f, 0.57f}, {s * 0.28f, 0.56f, -0.85f}, 0.022f, -1, 10),
            k.rod(tire, {s * 0.265f, 0.53f, -0.74f}, {s * 0.285f, 0.565f, -0.88f}, 0.026f, -1, 10);
        k.add(shapes::tube(std::vector<Vec3f>{{s * 0.17f, 0.36f, -0.1f},
                                              {s * 0.22f, 0.02f, -0.22f},
                                              {s * 0.22f, 0.02f, -0.34f},
                                              {s * 0.22f, 0.42f, -0.42f}},
                           0.016f, 8),
              metal);
        k.rod(tray, {s * 0.33f, 0.6f, 0.42f}, {s * 0.33f, 0.6f, -0.44f}, 0.012f, -1, 8),
            k.rod(tray, {-0.33f, 0.6f, s > 0 ? 0.42f : -0.44f}, {0.33f, 0.6f, s > 0 ? 0.42f : -0.44f}, 0.012f, -1, 8);
    }
    k.board(tray, {0, 0.29f, -0.03f}, {0.44f, 0.012f, 0.7f}, 0.003f),
        k.add(shapes::ball({0, 0.46f, 0}, {0.27f, 0.15f, 0.36f}, 16), earth);
}

void build_lawn_mower(Kit& k) {
    const int deck = k.main(plain("mower lacquer", {0.55f, 0.05f, 0.03f}, 0.3f)),
              dark = color(k, "engine", {0.03f, 0.03f, 0.033f}, 0.5f), metal = k.material(steel()),
              cloth = color(k, "grass bag", {0.05f, 0.055f, 0.05f}, 0.95f),
              hub = color(k, "hub", {0.65f, 0.62f, 0.1f}, 0.5f);
    k.add(shapes::prism(shapes::rounded_rectangle(0.5f, 0.68f, 0.12f), 0.08f, 0.22f, 0.04f), deck, {0, 0, 0.25f});
    k.add(shapes::lathe(
              std::array<Vec2f, 5>{Vec2f{0.16f, 0.2f}, {0.17f, 0.3f}, {0.14f, 0.36f}, {0.1f, 0.4f}, {0.04f, 0.41f}}, 20,
              true),
          dark, {0, 0, 0.25f}),
        k.board(deck, {0, 0.36f, 0.25f}, {0.14f, 0.03f, 0.14f}, 0.01f),
        k.rod(metal, {0.14f, 0.3f, 0.38f}, {0.14f, 0.36f, 0.38f}, 0.03f, -1, 10);
    for (const float sx : {-1.f, 1.f}) {
        for (const float z : {0.0f, 0.5f})
            k.rod(dark, {sx * 0.24f, 0.1f, z}, {sx * 0.29f, 0.1f, z}, 0.1f, -1, 18),
                k.rod(hub, {sx * 0.285f, 0.1f, z}, {sx * 0.295f, 0.1f, z}, 0.05f, -1, 12);
        k.add(shapes::tube(
                  std::vector<Vec3f>{{sx * 0.2f, 0.2f, 0.02f}, {sx * 0.22f, 0.5f, -0.35f}, {sx * 0.22f, 0.98f, -0.78f}},
                  0.014f, 8),
              metal);
    }
    k.rod(dark, {-0.22f, 0.98f, -0.78f}, {0.22f, 0.98f, -0.78f}, 0.018f, -1, 10),
        k.rod(deck, {-0.2f, 0.9f, -0.74f}, {0.2f, 0.9f, -0.74f}, 0.008f, -1, 6);
    k.soft(cloth, {0, 0.14f, -0.36f}, {0.42f, 0.34f, 0.5f}, {0.06f, 0.02f, 0.004f, 8});
}

}  // namespace fastscene::furniture
