// Of photographers, weavers, tailors, draughtsmen.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// Three legs that spread from a head at `top`.
void tripod(Kit& k, int metal, Vec3f at, float top, float spread) {
    for (int i = 0; i < 3; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / 3 + 0.5f) * spread;
        k.rod(metal, at + Vec3f{0, top, 0}, at + out + Vec3f{0, 0.01f, 0}, 0.016f, 0.012f, 8);
    }
}

}  // namespace

// A lamp in a box of black cloth with a white front, on a stand; it looks along +z and down.
void build_softbox(Kit& k) {
    const int black = k.main(plain("black cloth", {0.015f, 0.015f, 0.016f}, 0.8f)),
              metal = color(k, "stand", {0.05f, 0.05f, 0.055f}, 0.4f), front = lit(k, "softbox front", {9, 8.7f, 8.2f});
    tripod(k, metal, {0, 0, 0}, 0.75f, 0.48f);
    k.rod(metal, {0, 0.5f, 0}, {0, 1.75f, 0}, 0.016f, -1, 10);
    const Vec3f at{0, 1.82f, 0.06f};
    constexpr float kTilt = 22;
    const auto put = [&](Mesh m, int material) {
        shapes::turn(m, {1, 0, 0}, kTilt);
        k.add(std::move(m), material, at);
    };
    // From the lamp to the front it widens.
    put(shapes::sheet(4, 1,
                      [&](float u, float v) {
                          const std::array<Vec2f, 5> corner{Vec2f{-1, -1}, {-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
                          const Vec2f c = corner[static_cast<std::size_t>(std::lround(4 * u))];
                          const float wide = std::lerp(0.1f, 0.42f, v), high = std::lerp(0.1f, 0.55f, v);
                          return Vec3f{c.x * wide, c.y * high, std::lerp(-0.12f, 0.3f, v)};
                      }),
        black);
    Mesh face = shapes::box({0.82f, 1.08f, 0.015f}, 0.004f);
    shapes::move(face, {0, 0, 0.29f});
    put(std::move(face), front);
    Mesh body = shapes::box({0.16f, 0.18f, 0.26f}, 0.02f);
    shapes::move(body, {0, 0, -0.24f});
    put(std::move(body), black);
    for (const float side : {-1.f, 1.f}) {
        Mesh rim = shapes::box({0.03f, 1.1f, 0.05f}, 0.006f), bar = shapes::box({0.84f, 0.03f, 0.05f}, 0.006f);
        shapes::move(rim, {side * 0.42f, 0, 0.29f}), shapes::move(bar, {0, side * 0.55f, 0.29f});
        put(std::move(rim), black), put(std::move(bar), black);
    }
}

// A roll of paper between two stands that hangs down and runs out over the floor.
void build_photo_backdrop(Kit& k) {
    const Vec3f s = k.wanted({3.0f, 2.55f, 2.2f});
    const int paper = k.main(plain("backdrop paper", {0.66f, 0.64f, 0.6f}, 0.85f)),
              metal = color(k, "stand", {0.05f, 0.05f, 0.055f}, 0.4f);
    constexpr float kBend = 0.5f;
    const float back = -s.z / 2 + 0.2f, flat_m = s.z - 0.3f - kBend, arc = 0.5f * kPi * kBend, up = s.y - kBend - 0.1f,
                all = flat_m + arc + up;
    const float w = s.x - 0.35f;
    k.add(
        shapes::slab(2, 48, 0.006f,
                     [&](float u, float v) {
                         const float at = v * all, x = w * (u - 0.5f), front = s.z / 2 - 0.08f;
                         if (at < flat_m) return Vec3f{x, 0.008f, front - at};
                         if (at < flat_m + arc) {
                             const float a = (at - flat_m) / kBend;
                             return Vec3f{x, 0.008f + kBend * (1 - std::cos(a)), front - flat_m - kBend * std::sin(a)};
                         }
                         return Vec3f{x, 0.008f + kBend + at - flat_m - arc, front - flat_m - kBend};
                     }),
        paper);
    k.rod(paper, {-w / 2, s.y - 0.08f, back}, {w / 2, s.y - 0.08f, back}, 0.06f, -1, 20);
    for (const float side : {-1.f, 1.f}) {
        const Vec3f at{side * (s.x / 2 - 0.09f), 0, back};
        k.rod(metal, at, at + Vec3f{0, s.y - 0.04f, 0}, 0.018f, -1, 10);
        for (const float z : {-0.18f, 0.3f})
            k.rod(metal, at + Vec3f{0, 0.3f, 0}, at + Vec3f{0, 0.012f, z}, 0.012f, -1, 8);
        k.rod(metal, at + Vec3f{0, s.y - 0.08f, 0}, {side * (w / 2 - 0.02f), s.y - 0.08f, back}, 0.02f, -1, 10);
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.8f;
}

// A camera with a long lens on three legs; it looks along +z.
void build_camera_tripod(Kit& k) {
    const int black = k.main(plain("camera", {0.02f, 0.02f, 0.022f}, 0.5f)),
              metal = color(k, "tripod", {0.06f, 0.06f, 0.065f}, 0.4f),
              lens = color(k, "lens", {0.01f, 0.012f, 0.03f}, 0.05f),
              red = color(k, "ring", {0.5f, 0.03f, 0.02f}, 0.4f);
    tripod(k, metal, {0, 0, 0}, 1.2f, 0.42f);
    k.rod(metal, {0, 0.8f, 0}, {0, 1.38f, 0}, 0.016f, -1, 10),
        k.rod(metal, {0, 1.34f, 0}, {-0.12f, 1.24f, -0.34f}, 0.01f, -1, 8);
    k.board(metal, {0, 1.37f, 0}, {0.07f, 0.03f, 0.1f}, 0.006f);
    k.board(black, {0, 1.4f, -0.02f}, {0.16f, 0.11f, 0.08f}, 0.015f),
        k.board(black, {0, 1.5f, -0.02f}, {0.06f, 0.035f, 0.07f}, 0.008f);
    k.rod(black, {0, 1.455f, 0.02f}, {0, 1.455f, 0.2f}, 0.04f, 0.046f, 20),
        k.rod(red, {0, 1.455f, 0.17f}, {0, 1.455f, 0.177f}, 0.0475f, -1, 20);
    k.add(shapes::ball({0, 1.455f, 0.2f}, {0.038f, 0.038f, 0.014f}, 14), lens);
}

// An enlarger on its baseboard, on a bench with trays of developer.
void build_enlarger(Kit& k) {
    const Vec3f s = k.wanted({1.9f, 1.75f, 0.7f});
    const int wood = k.main(k.style.wood2), black = color(k, "enlarger", {0.03f, 0.03f, 0.032f}, 0.4f),
              metal = k.material(steel()), red = lit(k, "safelight", {3.6f, 0.12f, 0.04f}),
              paper = color(k, "photographic paper", {0.7f, 0.69f, 0.66f}, 0.4f);
    const std::array<int, 3> tray{color(k, "red tray", {0.5f, 0.05f, 0.04f}, 0.4f),
                                  color(k, "white tray", {0.65f, 0.65f, 0.63f}, 0.4f),
                                  color(k, "grey tray", {0.25f, 0.26f, 0.27f}, 0.4f)};
    const int fluid = color(k, "developer", {0.2f, 0.16f, 0.12f}, 0.05f);
    k.board(wood, {0, 0.84f, 0}, {s.x, 0.04f, s.z}, 0.006f);
    for (const float x : {-1.f, 1.f})
        for (const float z : {-1.f, 1.f})
            k.board(wood, {x * (s.x / 2 - 0.05f), 0, z * (s.z / 2 - 0.05f)}, {0.06f, 0.84f, 0.06f}, 0.005f);
    k.board(wood, {0, 0.25f, 0}, {s.x - 0.1f, 0.03f, s.z - 0.1f}, 0.004f);
    const float ex = -s.x / 2 + 0.36f;
    k.board(black, {ex, 0.88f, 0}, {0.5f, 0.03f, 0.55f}, 0.006f),
        k.board(paper, {ex, 0.911f, 0.06f}, {0.24f, 0.003f, 0.3f}, 0.001f);
    k.rod(metal, {ex, 0.91f, -0.22f}, {ex, s.y, -0.16f}, 0.022f, -1, 12);
    k.board(black, {ex, 1.36f, -0.06f}, {0.14f, 0.14f, 0.3f}, 0.02f);
    const std::array<Vec2f, 5> head{Vec2f{0.03f, 1.2f}, {0.06f, 1.3f}, {0.13f, 1.38f}, {0.13f, 1.58f}, {0.07f, 1.64f}};
    k.add(shapes::lathe(head, 22), black, {ex, 0, 0.06f});
    k.add(shapes::prism(shapes::circle(0.05f, 16), 1.185f, 1.2f, 0.002f), red, {ex, 0, 0.06f});
    for (int i = 0; i < 3; ++i) {
        const float x = -s.x / 2 + 0.85f + 0.36f * static_cast<float>(i);
        for (const float side : {-1.f, 1.f})
            k.board(tray[static_cast<std::size_t>(i)], {x + side * 0.155f, 0.88f, 0}, {0.012f, 0.07f, 0.42f}, 0.003f),
                k.board(tray[static_cast<std::size_t>(i)], {x, 0.88f, side * 0.205f}, {0.32f, 0.07f, 0.012f}, 0.003f);
        k.board(fluid, {x, 0.89f, 0}, {0.3f, 0.03f, 0.4f}, 0.001f);
        k.board(paper, {x + 0.02f, 0.921f, 0.02f}, {0.18f, 0.002f, 0.24f}, 0.0005f);
        const int brown = color(k, "bottle", {0.12f, 0.05f, 0.02f}, 0.1f);
        bottle(k, brown, black, {x, 0.28f, 0}, 0.3f, 0.055f),
            bottle(k, brown, black, {x + 0.14f, 0.28f, 0.05f}, 0.26f, 0.05f);
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.7f;
}

// Prints that dry on a line, held by pegs.
void build_print_line(Kit& k) {
    const Vec3f s = k.wanted({2.2f, 0.42f, 0.05f});
    const int peg = color(k, "peg", {0.45f, 0.3f, 0.15f}, 0.7f), cord = color(k, "cord", {0.6f, 0.58f, 0.52f}, 0.9f),
              paper = k.main(plain("print", {0.72f, 0.71f, 0.69f}, 0.3f)),
              ink = color(k, "print dark", {0.05f, 0.05f, 0.05f}, 0.3f),
              half = color(k, "print grey", {0.28f, 0.28f, 0.28f}, 0.3f);
    std::vector<Vec3f> line;
    for (int i = 0; i <= 16; ++i) {
        const float t = static_cast<float>(i) / 8 - 1;
        line.push_back({0.5f * s.x * t, s.y - 0.05f * (1 - t * t) - 0.01f, 0.03f});
    }
    k.add(shapes::tube(line, 0.004f, 6), cord);
    const int prints = std::max(3, static_cast<int>(s.x / 0.3f));
    for (int i = 0; i < prints; ++i) {
        const float t = 2 * (static_cast<float>(i) + 0.5f) / static_cast<float>(prints) - 1, x = 0.5f * s.x * t,
                    y = s.y - 0.05f * (1 - t * t) - 0.01f, w = 0.2f, h = i % 3 == 1 ? 0.2f : 0.28f;
        block(k, paper, {x, y - h, 0.03f}, {w, h, 0.003f});
        block(k, half, {x, y - h + 0.02f, 0.032f}, {w - 0.03f, h - 0.04f, 0.002f});
        k.add(shapes::ball({x + 0.02f, y - 0.6f * h, 0.0335f}, {0.045f, 0.06f, 0.001f}, 10), i % 2 == 0 ? paper : ink);
        block(k, ink, {x, y - h + 0.025f, 0.0335f}, {w - 0.04f, 0.3f * h, 0.001f});
        for (const float side : {-1.f, 1.f})
            block(k, peg, {x + side * 0.06f, y - 0.03f, 0.032f}, {0.014f, 0.06f, 0.016f});
    }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.5f;
}

// A red lamp by which one develops.
void build_safelight(Kit& k) {
    const int body = k.main(plain("lamp housing", {0.04f, 0.04f, 0.042f}, 0.4f)),
              red = lit(k, "safelight", {7.f, 0.18f, 0.06f});
    k.board(body, {0, 0, 0.06f}, {0.34f, 0.26f, 0.12f}, 0.02f),
        k.board(red, {0, 0.03f, 0.122f}, {0.28f, 0.2f, 0.008f}, 0.004f);
    for (const float y : {0.08f, 0.18f}) k.rod(body, {-0.15f, y, 0.128f}, {0.15f, y, 0.128f}, 0.006f, -1, 8);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.9f;
}

// A frame loom with its warp, the cloth half woven; a bench before it.
void build_loom(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 1.65f, 1.5f});
    const int wood = k.main(k.style.wood), warp = color(k, "warp", {0.62f, 0.57f, 0.46f}, 0.9f);
    const std::array<int, 3> cloth{color(k, "weft", {0.45f, 0.07f, 0.05f}, 0.95f),
                                   color(k, "weft", {0.06f, 0.13f, 0.3f}, 0.95f),
                                   color(k, "weft", {0.6f, 0.45f, 0.16f}, 0.95f)};
    const float hx = s.x / 2 - 0.05f;
    for (const float side : {-1.f, 1.f}) {
        for (const float z : {-0.5f, 0.0f, 0.4f})
            k.board(wood, {side * hx, 0, z}, {0.09f, z == 0.f ? s.y : 0.95f, 0.09f}, 0.008f);
        for (const float y : {0.25f, 0.86f}) k.board(wood, {side * hx, y, -0.05f}, {0.08f, 0.09f, 1.05f}, 0.008f);
        k.board(wood, {side * hx * 0.55f, 0, 0.65f}, {0.06f, 0.48f, 0.24f}, 0.006f);
    }
    k.board(wood, {0, 0.48f, 0.65f}, {s.x * 0.75f, 0.04f, 0.28f}, 0.008f);
    k.board(wood, {0, s.y - 0.1f, 0}, {s.x, 0.1f, 0.1f}, 0.008f),
        k.board(wood, {0, 1.2f, 0.02f}, {s.x - 0.2f, 0.06f, 0.04f}, 0.006f);
    k.rod(wood, {-hx, 0.95f, -0.5f}, {hx, 0.95f, -0.5f}, 0.06f, -1, 16),
        k.rod(wood, {-hx, 0.92f, 0.4f}, {hx, 0.92f, 0.4f}, 0.05f, -1, 16);
    const float w = s.x - 0.4f;
    for (int i = 0; i < 70; ++i) {
        const float x = w * (static_cast<float>(i) / 69 - 0.5f);
        k.rod(warp, {x, 1.0f, -0.5f}, {x, 0.965f, 0.02f}, 0.002f, -1, 4);
        k.rod(warp, {x, 0.82f, 0.0f}, {x, 1.2f, 0.0f}, 0.0015f, -1, 4);
    }
    for (int i = 0; i < 12; ++i)
        k.board(cloth[static_cast<std::size_t>(i % 3)],
                {0, 0.955f - 0.0008f * static_cast<float>(i), 0.02f + 0.031f * (static_cast<float>(i) + 0.5f)},
                {w, 0.008f, 0.031f}, 0.001f);
    k.board(cloth[0], {0, 0.45f, 0.44f}, {w, 0.48f, 0.01f}, 0.002f);
    k.board(wood, {0, 0.9f, 0.05f}, {s.x - 0.24f, 0.14f, 0.03f}, 0.005f);
    for (int i = 0; i < 4; ++i)
        k.board(wood, {0.16f * (static_cast<float>(i) - 1.5f), 0.06f, 0.15f}, {0.08f, 0.03f, 0.55f}, 0.005f);
    k.piece.clearance_front_m = 0.5f;
}

// A table with a sewing machine, cloth under its needle, reels of thread.
void build_sewing_table(Kit& k) {
    const Vec3f s = k.wanted({1.3f, 1.12f, 0.65f});
    const int wood = k.main(k.style.wood), black = color(k, "sewing machine", {0.02f, 0.021f, 0.024f}, 0.12f),
              metal = k.material(steel()), gold = k.material(*material_named("brass")),
              cloth = color(k, "cloth", k.accent(), 0.9f);
    k.board(wood, {0, 0.72f, 0}, {s.x, 0.04f, s.z}, 0.006f);
    const int iron = k.material(*material_named("iron"));
    for (const float side : {-1.f, 1.f}) {
        const float x = side * (s.x / 2 - 0.15f);
        for (const float z : {-1.f, 1.f}) k.rod(iron, {x, 0, z * 0.26f}, {x, 0.72f, z * 0.12f}, 0.018f, -1, 8);
        Mesh ring = shapes::ring(0.12f, 0.016f, 20);
        shapes::turn(ring, {0, 0, 1}, 90);
        k.add(std::move(ring), iron, {x, 0.36f, 0});
    }
    k.board(iron, {0, 0.12f, 0.02f}, {0.5f, 0.02f, 0.28f}, 0.004f);
    const float mx = -0.1f;
    k.board(black, {mx, 0.76f, 0}, {0.44f, 0.05f, 0.2f}, 0.015f),
        k.board(black, {mx + 0.16f, 0.81f, 0}, {0.1f, 0.24f, 0.11f}, 0.03f);
    k.board(black, {mx, 0.98f, 0}, {0.42f, 0.09f, 0.1f}, 0.03f),
        k.board(black, {mx - 0.17f, 0.88f, 0}, {0.08f, 0.14f, 0.09f}, 0.02f);
    k.board(gold, {mx, 1.01f, 0.051f}, {0.24f, 0.025f, 0.003f}, 0.001f);
    k.rod(metal, {mx - 0.17f, 0.81f, 0}, {mx - 0.17f, 0.9f, 0}, 0.006f, -1, 8);
    Mesh wheel = shapes::ring(0.075f, 0.022f, 24);
    shapes::turn(wheel, {0, 0, 1}, 90);
    k.add(std::move(wheel), metal, {mx + 0.25f, 0.97f, 0});
    k.rod(metal, {mx + 0.2f, 0.97f, 0}, {mx + 0.26f, 0.97f, 0}, 0.02f, -1, 10);
    k.soft(cloth, {mx - 0.3f, 0.762f, 0.08f}, {0.5f, 0.05f, 0.42f}, {0.02f, 0.01f, 0.01f, 14});
    for (int i = 0; i < 5; ++i) {
        const std::array<Vec2f, 4> reel{Vec2f{0.02f, 0}, {0.014f, 0.008f}, {0.014f, 0.05f}, {0.02f, 0.058f}};
        k.add(shapes::lathe(reel, 12), color(k, "thread", k.accent(), 0.7f),
              {0.3f + 0.06f * static_cast<float>(i % 3), 0.76f, -0.2f + 0.07f * static_cast<float>(i / 3)});
    }
    k.top(0.76f, 0.42f, 0.1f, 0.16f, 0.16f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.7f;
}

// Bolts of cloth on shelves.
void build_fabric_shelf(Kit& k) {
    const Vec3f s = k.wanted({1.6f, 2.05f, 0.45f});
    const int wood = k.main(k.style.wood), core = color(k, "core", {0.5f, 0.4f, 0.26f}, 0.9f);
    for (const float side : {-1.f, 0.f, 1.f})
        k.board(wood, {side * (s.x / 2 - 0.015f), 0, 0}, {0.03f, s.y, s.z}, 0.004f);
    for (int level = 0; level < 6; ++level) {
        const float y = 0.05f + (s.y - 0.08f) * static_cast<float>(level) / 5;
        k.board(wood, {0, y, 0}, {s.x, 0.025f, s.z}, 0.004f);
        if (level == 5) break;
        for (const float side : {-1.f, 1.f})
            for (int i = 0; i < 3; ++i) {
                const float x = side * s.x / 4 + 0.23f * (static_cast<float>(i) - 1);
                const int cloth = color(
                    k, "bolt of cloth",
                    k.rng.chance(0.4f)
                        ? k.accent()
                        : Vec3f{k.rng.uniform(0.08f, 0.6f), k.rng.uniform(0.08f, 0.5f), k.rng.uniform(0.08f, 0.55f)},
                    0.9f);
                for (int j = 0; j < 1 + k.rng.index(2); ++j) {
                    const float at = y + 0.1f + 0.15f * static_cast<float>(j);
                    k.rod(cloth, {x, at, -s.z / 2 + 0.03f}, {x, at, s.z / 2 + 0.01f}, 0.075f, -1, 16);
                    k.rod(core, {x, at, s.z / 2}, {x, at, s.z / 2 + 0.015f}, 0.02f, -1, 8);
                }
            }
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

// A drawing board that slopes, with a rule, a lamp on an arm and a plan.
void build_drafting_table(Kit& k) {
    const Vec3f s = k.wanted({1.4f, 1.4f, 0.9f});
    const int wood = k.main(k.style.wood), metal = color(k, "frame", {0.06f, 0.06f, 0.065f}, 0.4f),
              paper = color(k, "drawing paper", {0.74f, 0.74f, 0.71f}, 0.8f),
              ink = color(k, "ink", {0.05f, 0.09f, 0.25f}, 0.7f), rule = k.material(steel()),
              lamp = k.material(glow("drawing lamp", {12, 10.5f, 8}));
    constexpr float kTilt = 24;
    const Vec3f mid{0, 0.95f, 0};
    const auto put = [&](Vec3f size, Vec3f at, int material) {
        Mesh m = shapes::box(size, 0.003f);
        shapes::move(m, at), shapes::turn(m, {1, 0, 0}, kTilt);
        k.add(std::move(m), material, mid);
    };
    put({s.x, 0.03f, s.z - 0.02f}, {0, 0, 0}, wood),
        put({s.x - 0.25f, 0.003f, s.z - 0.22f}, {0, 0.017f, -0.02f}, paper);
    put({s.x - 0.04f, 0.012f, 0.05f}, {0, 0.024f, 0.12f}, rule),
        put({s.x, 0.04f, 0.03f}, {0, 0.02f, s.z / 2 - 0.02f}, wood);
    // A ground plan.
    for (const auto& [x0, z0, x1, z1] : {std::tuple{-0.4f, -0.3f, 0.35f, -0.3f},
                                         {-0.4f, 0.05f, 0.35f, 0.05f},
                                         {-0.4f, -0.3f, -0.4f, 0.05f},
                                         {0.35f, -0.3f, 0.35f, 0.05f},
                                         {-0.05f, -0.3f, -0.05f, -0.08f},
                                         {-0.05f, -0.12f, 0.2f, -0.12f},
                                         {-0.4f, -0.1f, -0.2f, -0.1f}})
        put({std::fabs(x1 - x0) + 0.012f, 0.002f, std::fabs(z1 - z0) + 0.012f}, {(x0 + x1) / 2, 0.02f, (z0 + z1) / 2},
            ink);
    for (const float side : {-1.f, 1.f}) {
        const float x = side * (s.x / 2 - 0.2f);
        k.board(metal, {x, 0, 0}, {0.06f, 0.04f, 0.75f}, 0.01f),
            k.board(metal, {x, 0.04f, 0}, {0.05f, 0.85f, 0.07f}, 0.01f);
    }
    k.board(metal, {0, 0.3f, 0}, {s.x - 0.4f, 0.05f, 0.04f}, 0.006f);
    const Vec3f foot{s.x / 2 - 0.08f, 1.12f, -0.34f}, elbow{s.x / 2 - 0.12f, s.y - 0.02f, -0.38f},
        head{0.25f, s.y - 0.03f, -0.1f};
    k.rod(metal, foot, elbow, 0.009f, -1, 8), k.rod(metal, elbow, head, 0.009f, -1, 8);
    const std::array<Vec2f, 3> shade{Vec2f{0.1f, -0.1f}, {0.07f, -0.03f}, {0.03f, 0}};
    k.add(shapes::shade(shade, 18), metal, head),
        k.add(shapes::ball(head + Vec3f{0, -0.07f, 0}, {0.035f, 0.035f, 0.035f}, 10), lamp);
    k.piece.clearance_front_m = 0.7f;
}

}  // namespace fastscene::furniture
