// Of shops and halls of single trades: ice cream, spices, spectacles, pets; a climbing wall, a lathe, an aeroplane.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// Tubs of ice cream below a curved pane; cones stand on top.
void build_ice_cream_counter(Kit& k) {
    const Vec3f s = k.wanted({2.6f, 1.35f, 0.9f});
    const int body = k.main(plain("counter front", {0.72f, 0.42f, 0.46f}, 0.35f)),
              white = color(k, "counter", {0.72f, 0.72f, 0.7f}, 0.3f), metal = k.material(steel()),
              pane = k.material(glass()), cone = color(k, "wafer", {0.5f, 0.28f, 0.09f}, 0.8f);
    const int light = lit(k, "counter light", {5, 4.8f, 4.4f});
    constexpr std::array<Vec3f, 8> kFlavours{Vec3f{0.72f, 0.65f, 0.48f}, {0.14f, 0.06f, 0.03f}, {0.66f, 0.18f, 0.22f},
                                             {0.4f, 0.58f, 0.36f},       {0.68f, 0.5f, 0.12f},  {0.26f, 0.09f, 0.26f},
                                             {0.42f, 0.25f, 0.14f},      {0.25f, 0.5f, 0.62f}};
    k.board(body, {0, 0.08f, 0.02f}, {s.x, 0.78f, s.z - 0.1f}, 0.03f),
        k.board(metal, {0, 0, 0}, {s.x - 0.1f, 0.08f, s.z - 0.2f}, 0.01f),
        k.board(white, {0, 0.86f, 0}, {s.x + 0.04f, 0.05f, s.z}, 0.015f);
    for (int i = 0; i < static_cast<int>(s.x / 0.16f); ++i)
        block(k, white, {-s.x / 2 + 0.08f + 0.16f * static_cast<float>(i), 0.12f, s.z / 2 - 0.028f},
              {0.07f, 0.7f, 0.008f});
    const int columns = std::max(3, static_cast<int>(s.x / 0.3f));
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < 2; ++j) {
            const float x = (s.x - 0.16f) * ((static_cast<float>(i) + 0.5f) / static_cast<float>(columns) - 0.5f),
                        z = 0.19f - 0.3f * static_cast<float>(j), y = 0.91f + 0.04f * static_cast<float>(j);
            k.board(metal, {x, y, z}, {0.27f, 0.05f, 0.28f}, 0.008f);
            const int ice = color(k, "ice cream", kFlavours[static_cast<std::size_t>((i + 4 * j + k.rng.index(2)) % 8)],
                                  0.75f);
            Mesh heap = shapes::soft_box({0.25f, 0.12f, 0.26f}, {0.05f, 0.03f, 0.004f, 6, k.seed()});
            for (Vec3f& p : heap.positions)
                if (p.y > 0) p.y += 0.012f * shapes::wobble(p * 9.f, 7);
            shapes::smooth_normals(heap);
            k.add(std::move(heap), ice, {x, y + 0.07f, z});
            block(k, metal, {x + 0.06f, y + 0.14f, z - 0.02f}, {0.02f, 0.09f, 0.01f});
        }
    k.add(shapes::slab(2, 14, 0.008f,
                       [&](float u, float v) {
                           const float a = 0.5f * kPi * v;
                           return Vec3f{(s.x - 0.06f) * (u - 0.5f), 0.92f + 0.32f * std::sin(a),
                                        0.02f + (s.z / 2 - 0.05f) * std::cos(a)};
                       }),
          pane);
    k.board(white, {0, 1.22f, -0.12f}, {s.x, 0.03f, 0.36f}, 0.008f),
        k.board(light, {0, 1.205f, 0.02f}, {s.x - 0.1f, 0.014f, 0.03f}, 0.003f);
    for (const float side : {-1.f, 1.f})
        k.board(white, {side * (s.x / 2 - 0.02f), 0.9f, -0.14f}, {0.04f, 0.34f, 0.32f}, 0.01f);
    for (int i = 0; i < 6; ++i) {
        const float x = 0.32f * s.x + 0.09f * static_cast<float>(i % 3), z = -0.18f + 0.09f * static_cast<float>(i / 3);
        k.rod(cone, {x, 1.25f, z}, {x, 1.34f, z}, 0.012f, 0.036f, 12);
    }
    k.piece.clearance_front_m = 0.9f;
}

// Open sacks with spices heaped in them, scoops, a scale.
void build_spice_sacks(Kit& k) {
    const Vec3f s = k.wanted({1.9f, 0.75f, 0.95f});
    const int sack = k.main(plain("sackcloth", {0.42f, 0.32f, 0.19f}, 0.95f)),
              scoop = k.material(*material_named("brass")), tag = color(k, "label", {0.7f, 0.68f, 0.6f}, 0.8f);
    constexpr std::array<Vec3f, 8> kSpices{Vec3f{0.62f, 0.3f, 0.02f}, {0.4f, 0.05f, 0.02f}, {0.22f, 0.1f, 0.04f},
                                           {0.55f, 0.43f, 0.2f},      {0.2f, 0.25f, 0.06f}, {0.05f, 0.04f, 0.03f},
                                           {0.6f, 0.14f, 0.03f},      {0.34f, 0.17f, 0.05f}};
    const int columns = std::max(2, static_cast<int>(s.x / 0.46f)), first = k.rng.index(8);
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < 2; ++j) {
            const float r = 0.2f, h = (j == 0 ? 0.42f : 0.58f),
                        x = s.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(columns) - 0.5f),
                        z = 0.23f - 0.46f * static_cast<float>(j);
            const std::array<Vec2f, 7> p{Vec2f{0.85f * r, 0},   {r, 0.1f * h},         {1.04f * r, 0.5f * h},
                                         {0.94f * r, 0.9f * h}, {1.0f * r, 0.97f * h}, {1.06f * r, h},
                                         {0.98f * r, 1.02f * h}};
            k.add(shapes::vessel(shapes::curve(p, 2), 0.014f, 22), sack, {x, 0, z});
            const int spice = color(k, "spice", kSpices[static_cast<std::size_t>((first + i + 3 * j) % 8)], 0.95f);
            const std::array<Vec2f, 4> heap{Vec2f{0.9f * r, 0}, {0.6f * r, 0.06f}, {0.2f * r, 0.12f}, {0.002f, 0.135f}};
            k.add(shapes::lathe(heap, 20, true), spice, {x, 0.93f * h, z});
            k.rod(scoop, {x + 0.02f, 0.98f * h + 0.05f, z + 0.02f}, {x + 0.14f, 0.98f * h + 0.14f, z + 0.1f}, 0.012f,
                  -1, 8),
                k.add(shapes::ball({x + 0.02f, 0.98f * h + 0.05f, z + 0.02f}, {0.035f, 0.02f, 0.05f}, 10), scoop);
            block(k, tag, {x, 0.7f * h, z + 1.02f * r}, {0.11f, 0.07f, 0.004f});
        }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.7f;
}

// Spectacles in rows before a lit wall.
void build_glasses_wall(Kit& k) {
    const Vec3f s = k.wanted({1.8f, 2.1f, 0.32f});
    const int body = k.main(plain("display", {0.66f, 0.66f, 0.65f}, 0.4f)),
              lens = color(k, "lens", {0.08f, 0.1f, 0.12f}, 0.05f);
    const int light = lit(k, "shelf light", {3.2f, 3.1f, 2.9f});
    const std::array<int, 4> frame{
        color(k, "frame", {0.02f, 0.02f, 0.02f}, 0.25f), color(k, "frame", {0.22f, 0.08f, 0.02f}, 0.25f),
        color(k, "frame", {0.4f, 0.03f, 0.04f}, 0.25f), color(k, "frame", {0.03f, 0.09f, 0.25f}, 0.25f)};
    k.board(body, {0, 0, -s.z / 2 + 0.03f}, {s.x, s.y, 0.06f}, 0.006f),
        k.board(body, {0, 0, 0}, {s.x, 0.55f, s.z}, 0.01f);
    for (int level = 0; level < 6; ++level) {
        const float y = 0.66f + 0.2f * static_cast<float>(level);
        k.board(body, {0, y, -s.z / 2 + 0.13f}, {s.x - 0.06f, 0.015f, 0.16f}, 0.003f),
            k.board(light, {0, y - 0.012f, -s.z / 2 + 0.09f}, {s.x - 0.1f, 0.008f, 0.02f}, 0.002f);
        const int pairs = static_cast<int>((s.x - 0.1f) / 0.2f);
        for (int i = 0; i < pairs; ++i) {
            const float x = (s.x - 0.1f) * ((static_cast<float>(i) + 0.5f) / static_cast<float>(pairs) - 0.5f),
                        z = -s.z / 2 + 0.2f;
            const int f = frame[static_cast<std::size_t>(k.rng.index(4))];
            for (const float side : {-1.f, 1.f}) {
                Mesh rim = shapes::ring(0.028f, 0.009f, 8);
                shapes::turn(rim, {1, 0, 0}, 90);
                k.add(std::move(rim), f, {x + side * 0.036f, y + 0.05f, z}),
                    k.add(shapes::ball({x + side * 0.036f, y + 0.05f, z}, {0.025f, 0.025f, 0.003f}, 6), lens);
                k.rod(f, {x + side * 0.066f, y + 0.06f, z}, {x + side * 0.066f, y + 0.05f, z - 0.1f}, 0.0035f, -1, 4);
            }
        }
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

// Cages and tanks of a pet shop: fish above, rabbits and birds.
void build_pet_cages(Kit& k) {
    const Vec3f s = k.wanted({2.0f, 2.1f, 0.55f});
    const int frame = k.main(plain("rack", {0.09f, 0.1f, 0.11f}, 0.4f)), wire = k.material(steel()),
              hay = color(k, "hay", {0.55f, 0.42f, 0.18f}, 0.95f),
              white = color(k, "white fur", {0.68f, 0.66f, 0.62f}, 0.95f),
              brown = color(k, "brown fur", {0.26f, 0.15f, 0.08f}, 0.95f);
    const std::array<int, 3> bird{color(k, "yellow feathers", {0.7f, 0.52f, 0.03f}, 0.8f),
                                  color(k, "green feathers", {0.1f, 0.42f, 0.06f}, 0.8f),
                                  color(k, "blue feathers", {0.06f, 0.22f, 0.6f}, 0.8f)};
    const int water = lit(k, "aquarium water", {0.12f, 0.62f, 0.85f}), pane = k.material(glass()),
              sand = color(k, "sand", {0.5f, 0.42f, 0.28f}, 0.9f),
              weed = color(k, "water plant", {0.05f, 0.26f, 0.05f}, 0.7f),
              orange = color(k, "goldfish", {0.75f, 0.24f, 0.02f}, 0.4f);
    const float front = s.z / 2;
    for (const float side : {-1.f, 0.f, 1.f})
        k.board(frame, {side * (s.x / 2 - 0.02f), 0, 0}, {0.04f, s.y, s.z}, 0.004f);
    for (int level = 0; level < 4; ++level) {
        const float y = 0.04f + (s.y - 0.08f) * static_cast<float>(level) / 3, room = (s.y - 0.08f) / 3;
        k.board(frame, {0, y, 0}, {s.x, 0.04f, s.z}, 0.004f);
        if (level == 3) break;
        for (const float side : {-1.f, 1.f}) {
            const float x = side * s.x / 4, w = s.x / 2 - 0.08f;
            if (level == 1) {  // a tank
                k.board(water, {x, y + 0.08f, -front + 0.05f}, {w, room - 0.2f, 0.02f}, 0.002f),
                    k.board(sand, {x, y + 0.04f, 0}, {w, 0.05f, s.z - 0.08f}, 0.004f),
                    k.board(pane, {x, y + 0.06f, front - 0.02f}, {w, room - 0.14f, 0.006f}, 0.001f);
                for (int i = 0; i < 6; ++i) {
                    const Vec3f at{x + k.rng.uniform(-0.4f, 0.4f) * w, y + k.rng.uniform(0.2f, 0.48f),
                                   k.rng.uniform(-0.1f, 0.15f)};
                    k.add(shapes::ball(at, {0.05f, 0.025f, 0.012f}, 10), orange),
                        k.add(shapes::ball(at + Vec3f{-0.055f, 0, 0}, {0.02f, 0.03f, 0.006f}, 8), orange);
                    const float wx = x + k.rng.uniform(-0.42f, 0.42f) * w;
                    k.rod(weed, {wx, y + 0.08f, -0.05f}, {wx + 0.04f, y + k.rng.uniform(0.25f, 0.5f), 0}, 0.012f,
                          0.004f, 6);
                }
                continue;
            }
            const int bars = static_cast<int>(w / 0.035f);
            for (int i = 0; i <= bars; ++i)
                k.rod(wire,
                      {x + w * (static_cast<float>(i) / static_cast<float>(bars) - 0.5f), y + 0.04f, front - 0.02f},
                      {x + w * (static_cast<float>(i) / static_cast<float>(bars) - 0.5f), y + room, front - 0.02f},
                      0.003f, -1, 4);
            for (const float t : {0.3f, 0.65f})
                k.rod(wire, {x - w / 2, y + t * room, front - 0.02f}, {x + w / 2, y + t * room, front - 0.02f}, 0.004f,
                      -1, 5);
            if (level == 0) {  // rabbits
                k.soft(hay, {x, y + 0.04f, 0}, {w, 0.07f, s.z - 0.1f}, {0.03f, 0.02f, 0.02f, 10});
                for (const float off : {-0.22f, 0.2f}) {
                    const int coat = k.rng.chance(0.5f) ? white : brown;
                    const Vec3f at{x + off, y + 0.1f, 0.02f};
                    k.add(shapes::ball(at + Vec3f{0, 0.09f, 0}, {0.14f, 0.1f, 0.09f}, 14), coat),
                        k.add(shapes::ball(at + Vec3f{0.13f, 0.15f, 0.02f}, {0.07f, 0.065f, 0.06f}, 12), coat);
                    for (const float ear : {-0.02f, 0.025f})
                        k.rod(coat, at + Vec3f{0.12f, 0.2f, ear}, at + Vec3f{0.08f, 0.34f, 1.6f * ear}, 0.018f, 0.012f,
                              8);
                }
            } else {  // birds on a perch
                k.rod(hay, {x - w / 2, y + 0.25f, 0}, {x + w / 2, y + 0.25f, 0}, 0.01f, -1, 8);
                for (int i = 0; i < 3; ++i) {
                    const Vec3f at{x + 0.22f * (static_cast<float>(i) - 1), y + 0.26f, 0};
                    const int coat = bird[static_cast<std::size_t>((i + (side > 0 ? 1 : 0)) % 3)];
                    k.add(shapes::ball(at + Vec3f{0, 0.07f, 0}, {0.045f, 0.075f, 0.045f}, 12), coat),
                        k.add(shapes::ball(at + Vec3f{0, 0.16f, 0.012f}, {0.036f, 0.036f, 0.036f}, 12), coat);
                    k.rod(coat, at + Vec3f{0, 0.04f, -0.03f}, at + Vec3f{0, -0.1f, -0.08f}, 0.016f, 0.008f, 8),
                        k.rod(hay, at + Vec3f{0, 0.16f, 0.04f}, at + Vec3f{0, 0.15f, 0.065f}, 0.01f, 0.002f, 6);
                }
            }
        }
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

// A climbing wall: panels that lean, coloured holds, a rope.
void build_climbing_wall(Kit& k) {
    const Vec3f s = k.wanted({2.6f, 3.6f, 0.9f});
    const int panel = k.main(plain("climbing panel", {0.5f, 0.48f, 0.44f}, 0.85f)),
              second = color(k, "climbing panel", {0.32f, 0.38f, 0.44f}, 0.85f),
              bolt = color(k, "bolt hole", {0.06f, 0.06f, 0.06f}, 0.7f),
              rope = color(k, "rope", {0.1f, 0.35f, 0.6f}, 0.9f);
    const std::array<int, 6> hold{
        color(k, "red hold", {0.6f, 0.05f, 0.04f}, 0.6f),   color(k, "yellow hold", {0.72f, 0.5f, 0.03f}, 0.6f),
        color(k, "blue hold", {0.04f, 0.18f, 0.55f}, 0.6f), color(k, "green hold", {0.06f, 0.42f, 0.08f}, 0.6f),
        color(k, "orange hold", {0.7f, 0.2f, 0.03f}, 0.6f), color(k, "purple hold", {0.3f, 0.06f, 0.4f}, 0.6f)};
    // Upright to 1.4 m, then leaning into the room, then upright again.
    const std::array<Vec2f, 4> line{
        Vec2f{0, -s.z / 2 + 0.12f}, {1.3f, -s.z / 2 + 0.2f}, {0.78f * s.y, s.z / 2 - 0.2f}, {s.y, s.z / 2 - 0.16f}};
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec2f a = line[i], b = line[i + 1];
        k.add(shapes::slab(2, 1, 0.04f,
                           [&](float u, float v) {
                               return Vec3f{s.x * (u - 0.5f), std::lerp(a.x, b.x, v), std::lerp(a.y, b.y, v)};
                           }),
              i == 1 ? second : panel);
        const Vec3f up = normalize(Vec3f{0, b.x - a.x, b.y - a.y}), out{0, -up.z, up.y};
        const float length_m = std::hypot(b.x - a.x, b.y - a.y);
        for (int n = 0; n < static_cast<int>(7.5f * length_m * s.x / 2.6f); ++n) {
            const Vec3f at = Vec3f{k.rng.uniform(-0.45f, 0.45f) * s.x, a.x, a.y} +
                             up * (k.rng.uniform(0.06f, 0.94f) * length_m);
            const Vec3f size{k.rng.uniform(0.05f, 0.12f), k.rng.uniform(0.04f, 0.09f), k.rng.uniform(0.04f, 0.07f)};
            Mesh m = shapes::ball({0, 0, 0}, size, 10);
            for (Vec3f& p : m.positions) p = p * (1.f + 0.25f * shapes::wobble(p * 16.f + at, 4));
            shapes::smooth_normals(m);
            k.add(std::move(m), hold[static_cast<std::size_t>(k.rng.index(6))], at + out * 0.02f);
        }
        for (int n = 0; n < 40; ++n) {
            const Vec3f at = Vec3f{(static_cast<float>(n % 8) - 3.5f) * s.x / 8.4f, a.x, a.y} +
                             up * ((static_cast<float>(n / 8) + 0.5f) / 5 * length_m);
            k.add(shapes::ball(at + out * 0.002f, {0.008f, 0.008f, 0.008f}, 6), bolt);
        }
    }
    k.board(panel, {0, 0, -s.z / 2 + 0.01f}, {s.x, s.y, 0.02f}, 0.002f);
    const float top = s.z / 2 - 0.05f;
    k.rod(rope, {0.3f * s.x, s.y - 0.1f, top}, {0.3f * s.x, 0.05f, top + 0.04f}, 0.008f, -1, 6),
        k.rod(rope, {0.27f * s.x, s.y - 0.1f, top}, {0.27f * s.x, 0.05f, top + 0.02f}, 0.008f, -1, 6);
    k.piece.against_wall = true, k.piece.clearance_front_m = 1.2f;
}

// A lathe of a factory: a long bed, headstock, chuck, its guard and panel.
void build_factory_machine(Kit& k) {
    const Vec3f s = k.wanted({2.8f, 1.6f, 1.0f});
    const int green = k.main(plain("machine paint", {0.1f, 0.26f, 0.22f}, 0.4f)), metal = k.material(steel()),
              dark = color(k, "machine foot", {0.05f, 0.055f, 0.06f}, 0.5f),
              yellow = color(k, "warning paint", {0.7f, 0.48f, 0.02f}, 0.5f),
              red = color(k, "stop button", {0.6f, 0.03f, 0.02f}, 0.3f);
    const int shown = lit(k, "machine display", {0.2f, 0.8f, 1.3f});
    for (const float side : {-1.f, 1.f})
        k.board(dark, {side * (s.x / 2 - 0.35f), 0, 0}, {0.6f, 0.6f, s.z - 0.2f}, 0.02f);
    k.board(green, {0, 0.6f, 0}, {s.x, 0.2f, s.z - 0.25f}, 0.02f);
    for (const float z : {-0.18f, 0.18f}) k.board(metal, {0.2f, 0.8f, z}, {s.x - 0.9f, 0.06f, 0.08f}, 0.006f);
    k.board(green, {-s.x / 2 + 0.42f, 0.8f, -0.02f}, {0.84f, 0.72f, s.z - 0.3f}, 0.04f);
    const float x0 = -s.x / 2 + 0.84f, y = 1.15f;
    k.rod(metal, {x0, y, 0}, {x0 + 0.16f, y, 0}, 0.2f, -1, 30),
        k.rod(dark, {x0 + 0.16f, y, 0}, {x0 + 0.2f, y, 0}, 0.13f, -1, 24),
        k.rod(metal, {x0 + 0.18f, y, 0}, {s.x / 2 - 0.6f, y, 0}, 0.06f, -1, 18);
    k.board(green, {s.x / 2 - 0.35f, 0.84f, 0}, {0.4f, 0.44f, 0.34f}, 0.04f),
        k.rod(metal, {s.x / 2 - 0.6f, y, 0}, {s.x / 2 - 0.5f, y, 0}, 0.012f, 0.06f, 14);
    Mesh wheel = shapes::ring(0.13f, 0.022f, 24);
    shapes::turn(wheel, {0, 0, 1}, 90);
    k.add(std::move(wheel), metal, {s.x / 2 - 0.1f, y, 0}),
        k.rod(metal, {s.x / 2 - 0.2f, y, 0}, {s.x / 2 - 0.09f, y, 0}, 0.025f, -1, 10);
    k.board(green, {0.25f, 0.86f, 0.05f}, {0.44f, 0.14f, s.z - 0.4f}, 0.02f),
        k.board(metal, {0.25f, 1.0f, 0.16f}, {0.16f, 0.1f, 0.16f}, 0.01f);
    k.board(yellow, {0, 0.62f, s.z / 2 - 0.115f}, {s.x - 0.1f, 0.06f, 0.012f}, 0.003f);
    k.board(shown, {-s.x / 2 + 0.35f, 1.22f, s.z / 2 - 0.168f}, {0.3f, 0.2f, 0.012f}, 0.003f);
    Mesh stop = shapes::prism(shapes::circle(0.045f, 18), 0, 0.03f, 0.008f);
    shapes::turn(stop, {1, 0, 0}, 90);
    k.add(std::move(stop), red, {-s.x / 2 + 0.65f, 1.3f, s.z / 2 - 0.17f});
    k.piece.clearance_front_m = 0.8f;
}

// A light aeroplane with a propeller; its nose looks along +z.
void build_aeroplane(Kit& k) {
    const Vec3f s = k.wanted({8.4f, 2.4f, 6.6f});
    const float scale = std::min({s.x / 8.4f, s.y / 2.4f, s.z / 6.6f});
    const int white = k.main(plain("aeroplane paint", {0.68f, 0.68f, 0.66f}, 0.2f)),
              red = color(k, "stripe", {0.55f, 0.04f, 0.03f}, 0.2f),
              pane = color(k, "canopy", {0.02f, 0.025f, 0.03f}, 0.05f), metal = k.material(steel()),
              tire = color(k, "tire", {0.02f, 0.02f, 0.02f}, 0.8f),
              dark = color(k, "propeller", {0.03f, 0.03f, 0.03f}, 0.4f);
    struct Section {
        float z, half, y, high;
    };
    const std::array<Section, 9> body{{{-3.2f, 0.05f, 1.28f, 0.1f},
                                       {-2.4f, 0.16f, 1.22f, 0.2f},
                                       {-1.2f, 0.36f, 1.14f, 0.4f},
                                       {-0.2f, 0.53f, 1.12f, 0.6f},
                                       {0.8f, 0.55f, 1.1f, 0.62f},
                                       {1.6f, 0.5f, 1.06f, 0.5f},
                                       {2.4f, 0.42f, 1.04f, 0.4f},
                                       {2.95f, 0.28f, 1.03f, 0.28f},
                                       {3.1f, 0.12f, 1.03f, 0.12f}}};
    const auto at = [&](float v) {
        const float t = v * static_cast<float>(body.size() - 1);
        const auto i = static_cast<std::size_t>(std::min(static_cast<int>(t), static_cast<int>(body.size()) - 2));
        const float f = t - static_cast<float>(i);
        const Section &a = body[i], &b = body[i + 1];
        return Section{std::lerp(a.z, b.z, f), std::lerp(a.half, b.half, f), std::lerp(a.y, b.y, f),
                       std::lerp(a.high, b.high, f)};
    };
    const auto put = [&](Mesh m, int material) {
        for (Vec3f& p : m.positions) p = p * scale;
        k.add(std::move(m), material);
    };
    put(shapes::sheet(32, 48,
                      [&](float u, float v) {
                          const Section c = at(v);
                          const float a = kTau * u;
                          return Vec3f{-c.half * std::cos(a), c.y + c.high * std::sin(a), c.z};
                      }),
        white);
    put(shapes::ball({0, 1.62f, 0.55f}, {0.46f, 0.36f, 0.95f}, 24), pane);
    for (const float side : {-1.f, 1.f}) {
        Mesh wing = shapes::box({3.7f, 0.1f, 1.25f}, 0.05f);
        shapes::turn(wing, {0, 0, 1}, side * 3);
        put(std::move(shapes::move(wing, {side * 2.3f, 0.98f, 0.5f})), white);
        Mesh tip = shapes::box({0.4f, 0.11f, 1.26f}, 0.05f);
        put(std::move(shapes::move(tip, {side * 3.98f, 1.075f, 0.5f})), red);
        Mesh tail = shapes::box({1.1f, 0.07f, 0.6f}, 0.03f);
        put(std::move(shapes::move(tail, {side * 0.62f, 1.34f, -2.85f})), white);
        Mesh stripe = shapes::box({0.02f, 0.12f, 3.6f}, 0.004f);
        shapes::turn(stripe, {0, 1, 0}, side * -3.f);
        put(std::move(shapes::move(stripe, {side * 0.52f, 1.12f, 0.7f})), red);
        put(shapes::rod({side * 0.4f, 0.8f, 0.6f}, {side * 1.05f, 0.3f, 0.55f}, 0.05f, 0.04f), metal);
        Mesh wheel = shapes::ring(0.2f, 0.13f, 24);
        shapes::turn(wheel, {0, 0, 1}, 90);
        put(std::move(shapes::move(wheel, {side * 1.08f, 0.265f, 0.55f})), tire);
    }
    Mesh fin = shapes::box({0.07f, 0.95f, 0.75f}, 0.03f);
    shapes::turn(fin, {1, 0, 0}, -18);
    put(std::move(shapes::move(fin, {0, 1.85f, -2.95f})), red);
    put(shapes::rod({0, 0.8f, 2.4f}, {0, 0.3f, 2.45f}, 0.045f, 0.035f), metal);
    Mesh nose_wheel = shapes::ring(0.17f, 0.11f, 22);
    shapes::turn(nose_wheel, {0, 0, 1}, 90);
    put(std::move(shapes::move(nose_wheel, {0, 0.225f, 2.45f})), tire);
    put(shapes::rod({0, 1.03f, 3.08f}, {0, 1.03f, 3.34f}, 0.15f, 0.03f, 20), red);
    Mesh blade = shapes::box({1.75f, 0.14f, 0.035f}, 0.015f);
    shapes::turn(blade, {0, 0, 1}, 35);
    put(std::move(shapes::move(blade, {0, 1.03f, 3.2f})), dark);
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture
