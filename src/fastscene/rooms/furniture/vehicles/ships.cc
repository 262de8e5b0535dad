// Of ships, submarines and spaceships: a helm, consoles, a periscope, torpedo tubes, berths.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// A gauge on the plane z: rim, dial, needle.
void gauge(Kit& k, int rim, int dial, int needle, Vec3f at, float r) {
    Mesh plate = shapes::prism(shapes::circle(r, 20), 0, 0.012f, 0.002f), ring = shapes::ring(r, 0.014f, 20);
    for (Mesh* m : {&plate, &ring}) shapes::turn(*m, {1, 0, 0}, 90);
    k.add(std::move(plate), dial, at), k.add(std::move(ring), rim, at + Vec3f{0, 0, 0.012f});
    const float a = k.rng.uniform(0.3f, 2.8f);
    k.rod(needle, at + Vec3f{0, 0, 0.016f}, at + Vec3f{0.8f * r * std::cos(a), 0.8f * r * std::sin(a), 0.016f}, 0.004f,
          0.002f, 6);
}

// A hand wheel whose axis is z.
void hand_wheel(Kit& k, int material, int stem, Vec3f at, float r) {
    Mesh ring = shapes::ring(r, 0.024f, 22);
    shapes::turn(ring, {1, 0, 0}, 90);
    k.add(std::move(ring), material, at);
    for (int i = 0; i < 2; ++i) {
        const float a = 0.5f * kPi * static_cast<float>(i) + 0.6f;
        const Vec3f out{r * std::cos(a), r * std::sin(a), 0};
        k.rod(material, at - out, at + out, 0.008f, -1, 6);
    }
    k.rod(stem, at - Vec3f{0, 0, 0.08f}, at, 0.014f, -1, 8);
}

// Keys in rows on a plane that slopes up to the back: some lit.
void keys(Kit& k, std::span<const int> lamps, int dark, Vec3f from, Vec3f right, Vec3f up, int columns, int rows,
          float lit_share) {
    const Vec3f normal = normalize(cross(right, up));
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const Vec3f at = from + right * ((static_cast<float>(i) + 0.5f) / static_cast<float>(columns)) +
                             up * ((static_cast<float>(j) + 0.5f) / static_cast<float>(rows));
            const int material = k.rng.chance(lit_share)
                                     ? lamps[static_cast<std::size_t>(k.rng.index(static_cast<int>(lamps.size())))]
                                     : dark;
            const float w = 0.62f * length(right) / static_cast<float>(columns),
                        h = 0.6f * length(up) / static_cast<float>(rows);
            Mesh key = shapes::box({w, 0.016f, h}, 0.003f);
            const float tilt = std::atan2(up.y, -up.z) * 180.f / kPi;
            shapes::turn(key, {1, 0, 0}, tilt);
            k.add(std::move(key), material, at + normal * 0.006f);
        }
}

}  // namespace

// A ship's wheel on its stand, a binnacle before it.
void build_ship_wheel(Kit& k) {
    const int wood = k.main(k.style.wood), brass = k.material(*material_named("brass")), pane = k.material(glass());
    k.board(wood, {0, 0, 0}, {0.6f, 0.06f, 0.5f}, 0.01f);
    for (const float side : {-1.f, 1.f}) k.board(wood, {0, 0.06f, side * 0.1f}, {0.26f, 0.9f, 0.05f}, 0.01f);
    k.rod(brass, {0, 0.98f, -0.2f}, {0, 0.98f, 0.26f}, 0.035f, -1, 16);
    constexpr float r = 0.42f, z = 0.22f;
    for (const auto& [radius, thick, material] :
         {std::tuple{r, 0.055f, wood}, {r - 0.02f, 0.06f, brass}, {0.1f, 0.06f, wood}}) {
        if (material == brass) continue;
        Mesh ring = shapes::ring(radius, thick, 32);
        shapes::turn(ring, {1, 0, 0}, 90);
        k.add(std::move(ring), material, {0, 0.98f, z});
    }
    Mesh band = shapes::ring(r, 0.02f, 32);
    shapes::turn(band, {1, 0, 0}, 90);
    k.add(std::move(band), brass, {0, 0.98f, z + 0.024f});
    for (int i = 0; i < 8; ++i) {
        const float a = kTau * static_cast<float>(i) / 8;
        const Vec3f out{std::cos(a), std::sin(a), 0}, mid{0, 0.98f, z};
        k.rod(wood, mid + out * 0.06f, mid + out * (r + 0.02f), 0.016f, 0.02f, 8);
        k.rod(wood, mid + out * (r + 0.02f), mid + out * (r + 0.16f), 0.014f, 0.022f, 8);
    }
    k.rod(brass, {0, 0.98f, z}, {0, 0.98f, z + 0.06f}, 0.07f, 0.05f, 16);
    const std::array<Vec2f, 5> binnacle{Vec2f{0.14f, 0}, {0.1f, 0.1f}, {0.09f, 0.75f}, {0.15f, 0.85f}, {0.15f, 0.95f}};
    k.add(shapes::lathe(binnacle, 8), wood, {0, 0, -0.4f});
    k.add(shapes::ball({0, 0.95f, -0.4f}, {0.13f, 0.1f, 0.13f}, 16), brass);
    k.add(shapes::ball({0, 0.99f, -0.38f}, {0.08f, 0.08f, 0.12f}, 14), pane);
    for (const float side : {-1.f, 1.f})
        k.add(shapes::ball({side * 0.21f, 0.88f, -0.4f}, {0.07f, 0.07f, 0.07f}, 14),
              side > 0 ? color(k, "green ball", {0.02f, 0.25f, 0.06f}, 0.3f)
                       : color(k, "red ball", {0.4f, 0.02f, 0.02f}, 0.3f));
    k.piece.clearance_front_m = 0.7f;
}

// A built-in berth with a board at its edge, drawers below and a shelf above.
void build_ship_berth(Kit& k) {
    const Vec3f s = k.wanted({2.0f, 1.0f, 0.95f});
    const int wood = k.main(k.style.wood), brass = k.material(*material_named("brass")),
              sheet = color(k, "sheet", {0.72f, 0.7f, 0.66f}, 0.9f),
              blanket = color(k, "blanket", {0.03f, 0.06f, 0.16f}, 0.95f),
              stripe = color(k, "stripe", {0.6f, 0.06f, 0.05f}, 0.95f);
    k.board(wood, {0, 0, 0}, {s.x, 0.48f, s.z - 0.02f}, 0.01f);
    for (int i = 0; i < 3; ++i) {
        const float x = s.x * ((static_cast<float>(i) + 0.5f) / 3 - 0.5f);
        k.board(wood, {x, 0.08f, s.z / 2 - 0.01f}, {s.x / 3 - 0.06f, 0.3f, 0.025f}, 0.008f);
        k.rod(brass, {x - 0.05f, 0.24f, s.z / 2 + 0.012f}, {x + 0.05f, 0.24f, s.z / 2 + 0.012f}, 0.009f, -1, 8);
    }
    k.board(wood, {0, 0.48f, s.z / 2 - 0.03f}, {s.x, 0.18f, 0.035f}, 0.012f);
    for (const float side : {-1.f, 1.f})
        k.board(wood, {side * (s.x / 2 - 0.02f), 0.48f, 0}, {0.04f, s.y - 0.48f, s.z - 0.02f}, 0.012f);
    k.soft(sheet, {0, 0.48f, -0.02f}, {s.x - 0.1f, 0.15f, s.z - 0.1f}, {0.05f, 0.02f, 0.004f, 16});
    k.soft(blanket, {-0.22f, 0.56f, -0.02f}, {s.x - 0.58f, 0.1f, s.z - 0.08f}, {0.04f, 0.015f, 0.006f, 16});
    k.soft(stripe, {0.42f, 0.565f, -0.02f}, {0.08f, 0.1f, s.z - 0.075f}, {0.03f, 0.01f, 0.004f, 10});
    k.soft(sheet, {s.x / 2 - 0.32f, 0.6f, -0.02f}, {0.4f, 0.13f, 0.6f}, {0.06f, 0.03f, 0.004f, 12});
    k.top(0.67f, -0.2f, 0, 0.5f, 0.2f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

// Eyepiece and handles at the foot of a column that goes up through the hull.
void build_periscope(Kit& k) {
    const Vec3f s = k.wanted({0.7f, 2.2f, 0.6f});
    const int tube = k.main(steel()), black = color(k, "eyepiece", {0.02f, 0.02f, 0.02f}, 0.6f),
              brass = k.material(*material_named("brass")), deck = color(k, "deck ring", {0.14f, 0.15f, 0.15f}, 0.5f),
              yellow = color(k, "grip", {0.55f, 0.36f, 0.03f}, 0.5f);
    k.add(shapes::prism(shapes::circle(0.3f, 28), 0, 0.03f, 0.005f), deck);
    k.rod(tube, {0, 0.03f, 0}, {0, s.y, 0}, 0.085f, -1, 22);
    for (const float y : {0.12f, 0.8f, 1.72f, 2.0f}) k.rod(brass, {0, y, 0}, {0, y + 0.05f, 0}, 0.1f, -1, 22);
    k.board(deck, {0, 1.22f, 0.02f}, {0.26f, 0.42f, 0.26f}, 0.03f);
    for (const float side : {-1.f, 1.f}) {
        k.rod(black, {side * 0.04f, 1.5f, 0.14f}, {side * 0.04f, 1.5f, 0.25f}, 0.034f, 0.04f, 14);
        k.rod(tube, {side * 0.12f, 1.3f, 0}, {side * 0.22f, 1.3f, 0.02f}, 0.018f, -1, 10);
        k.rod(yellow, {side * 0.2f, 1.3f, 0.02f}, {side * 0.34f, 1.28f, 0.05f}, 0.024f, -1, 12);
        k.rod(brass, {side * 0.1f, 1.2f, 0.1f}, {side * 0.1f, 1.2f, 0.18f}, 0.02f, -1, 10);
    }
    k.board(black, {0, 1.56f, 0.14f}, {0.22f, 0.07f, 0.06f}, 0.02f);
    k.piece.clearance_front_m = 0.6f;
}

// A wall of gauges, valves and lit lamps over a sloping desk.
void build_dive_console(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 1.75f, 0.62f});
    const int body = k.main(plain("console paint", {0.27f, 0.31f, 0.28f}, 0.4f)),
              rim = k.material(*material_named("brass")), dial = color(k, "dial", {0.72f, 0.7f, 0.62f}, 0.5f),
              black = color(k, "black", {0.015f, 0.015f, 0.015f}, 0.5f),
              red = color(k, "valve wheel", {0.5f, 0.04f, 0.03f}, 0.35f), metal = k.material(steel());
    const std::array<int, 3> lamps{lit(k, "red key", {2.6f, 0.12f, 0.06f}), lit(k, "amber key", {2.4f, 1.1f, 0.1f}),
                                   lit(k, "green key", {0.15f, 1.9f, 0.4f})};
    const int sonar = lit(k, "sonar", {0.03f, 0.34f, 0.1f}), trace = lit(k, "sonar trace", {0.3f, 3.2f, 0.8f});
    k.board(body, {0, 0, -0.06f}, {s.x, 0.8f, s.z - 0.12f}, 0.015f);
    k.board(body, {0, 0.8f, -s.z / 2 + 0.15f}, {s.x, s.y - 0.8f, 0.3f}, 0.02f);
    const float face = -s.z / 2 + 0.3f;
    const int columns = std::max(3, static_cast<int>(s.x / 0.28f));
    for (int i = 0; i < columns; ++i) {
        const float x = (s.x - 0.2f) * ((static_cast<float>(i) + 0.5f) / static_cast<float>(columns) - 0.5f);
        gauge(k, rim, dial, black, {x, s.y - 0.18f, face}, 0.085f);
        if (i % 2 == 0) hand_wheel(k, red, metal, {x, 1.05f, face + 0.09f}, 0.1f);
        else gauge(k, rim, dial, black, {x, 1.06f, face}, 0.11f);
    }
    // A round screen in the middle.
    Mesh screen = shapes::prism(shapes::circle(0.15f, 28), 0, 0.01f, 0.002f), ring = shapes::ring(0.16f, 0.03f, 28);
    for (Mesh* m : {&screen, &ring}) shapes::turn(*m, {1, 0, 0}, 90);
    k.add(std::move(screen), sonar, {0, 1.36f, face + 0.006f}),
        k.add(std::move(ring), metal, {0, 1.36f, face + 0.012f});
    k.rod(trace, {0, 1.36f, face + 0.02f}, {0.1f, 1.46f, face + 0.02f}, 0.004f, -1, 6);
    for (const float r : {0.05f, 0.1f}) {
        Mesh circle = shapes::ring(r, 0.004f, 24);
        shapes::turn(circle, {1, 0, 0}, 90);
        k.add(std::move(circle), trace, {0, 1.36f, face + 0.018f});
    }
    // The desk's keys.
    Mesh slope = shapes::box({s.x - 0.04f, 0.03f, 0.34f}, 0.01f);
    shapes::turn(slope, {1, 0, 0}, 14);
    k.add(std::move(slope), metal, {0, 0.84f, s.z / 2 - 0.2f});
    keys(k, lamps, black, {-s.x / 2 + 0.08f, 0.82f, s.z / 2 - 0.06f}, {s.x - 0.16f, 0, 0}, {0, 0.07f, -0.28f},
         columns * 3, 4, 0.45f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

// Doors of four tubes in a bulkhead.
void build_torpedo_tubes(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 1.75f, 0.4f});
    const int plate = k.main(plain("bulkhead paint", {0.31f, 0.35f, 0.32f}, 0.45f)),
              brass = k.material(*material_named("brass")), metal = k.material(steel()),
              red = color(k, "valve wheel", {0.5f, 0.04f, 0.03f}, 0.35f),
              dark = color(k, "number", {0.6f, 0.58f, 0.5f}, 0.6f);
    k.board(plate, {0, 0, -s.z / 2 + 0.03f}, {s.x, s.y, 0.06f}, 0.01f);
    for (int i = 0; i < 4; ++i) {
        const Vec3f at{(i % 2 == 0 ? -1.f : 1.f) * 0.42f, i < 2 ? 0.45f : 1.25f, -s.z / 2 + 0.06f};
        k.rod(metal, at, at + Vec3f{0, 0, 0.16f}, 0.3f, -1, 30);
        k.rod(brass, at + Vec3f{0, 0, 0.15f}, at + Vec3f{0, 0, 0.2f}, 0.33f, -1, 30);
        k.rod(brass, at + Vec3f{0, 0, 0.2f}, at + Vec3f{0, 0, 0.25f}, 0.26f, 0.2f, 26);
        for (int j = 0; j < 10; ++j) {
            const Vec3f out{0.3f * std::cos(kTau * static_cast<float>(j) / 10),
                            0.3f * std::sin(kTau * static_cast<float>(j) / 10), 0.2f};
            k.add(shapes::ball(at + out, {0.024f, 0.024f, 0.018f}, 8), metal);
        }
        hand_wheel(k, red, metal, at + Vec3f{0, 0, 0.31f}, 0.12f);
        k.board(dark, at + Vec3f{0, 0.335f, 0.02f}, {0.12f, 0.07f, 0.01f}, 0.002f);
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.7f;
}

// The seat of a captain: on a turning foot, with keys in its arms.
void build_captains_chair(Kit& k) {
    const int hide = k.main(tinted(k.style.leather, {0.05f, 0.055f, 0.065f})),
              shell = color(k, "shell", {0.5f, 0.52f, 0.55f}, 0.3f),
              dark = color(k, "dark", {0.03f, 0.032f, 0.036f}, 0.4f), trim = lit(k, "edge light", {0.3f, 1.1f, 3.2f});
    const std::array<int, 3> lamps{lit(k, "blue key", {0.3f, 1.2f, 3.0f}), lit(k, "amber key", {2.6f, 1.3f, 0.2f}),
                                   lit(k, "red key", {2.4f, 0.2f, 0.15f})};
    k.add(shapes::prism(shapes::circle(0.42f, 32), 0, 0.09f, 0.02f), dark);
    k.add(shapes::ring(0.4f, 0.02f, 32), trim, {0, 0.09f, 0});
    k.rod(shell, {0, 0.09f, 0}, {0, 0.4f, 0}, 0.11f, 0.08f, 18);
    k.board(shell, {0, 0.38f, 0}, {0.68f, 0.1f, 0.66f}, 0.04f);
    k.soft(hide, {0, 0.44f, 0.04f}, {0.56f, 0.16f, 0.58f}, {0.06f, 0.03f, 0.002f, 14});
    Mesh back = shapes::soft_box({0.58f, 0.85f, 0.16f}, {0.07f, 0.03f, 0.002f, 16, k.seed()}),
         cover = shapes::box({0.64f, 0.9f, 0.06f}, 0.02f);
    for (Mesh* m : {&back, &cover}) shapes::turn(*m, {1, 0, 0}, -10);
    k.add_soft(std::move(back), hide, kUpholsteryCrease, {0, 0.95f, -0.26f}),
        k.add(std::move(cover), shell, {0, 0.95f, -0.36f});
    Mesh head = shapes::soft_box({0.34f, 0.18f, 0.12f}, {0.05f, 0.02f, 0.002f, 10, k.seed()});
    k.add_soft(std::move(head), hide, kUpholsteryCrease, {0, 1.45f, -0.36f});
    for (const float side : {-1.f, 1.f}) {
        k.board(shell, {side * 0.38f, 0.4f, 0}, {0.1f, 0.28f, 0.5f}, 0.03f);
        k.board(shell, {side * 0.38f, 0.66f, 0.04f}, {0.16f, 0.06f, 0.62f}, 0.02f);
        keys(k, lamps, dark, {side * 0.38f - 0.06f, 0.725f, 0.33f}, {0.12f, 0, 0}, {0, 0.002f, -0.3f}, 3, 6, 0.6f);
    }
    k.piece.clearance_front_m = 0.6f;
}

// A desk of lit keys and small screens, one sits behind it and looks over it.
void build_bridge_console(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 1.05f, 0.75f});
    const int body = k.main(plain("console shell", {0.45f, 0.47f, 0.5f}, 0.3f)),
              dark = color(k, "panel", {0.02f, 0.022f, 0.027f}, 0.35f), trim = lit(k, "edge light", {0.3f, 1.1f, 3.2f});
    const std::array<int, 5> lamps{lit(k, "blue key", {0.3f, 1.2f, 3.0f}), lit(k, "amber key", {2.6f, 1.3f, 0.2f}),
                                   lit(k, "red key", {2.4f, 0.2f, 0.15f}), lit(k, "green key", {0.2f, 2.2f, 0.7f}),
                                   lit(k, "white key", {2, 2.1f, 2.2f})};
    const int blue = lit(k, "display", {0.04f, 0.16f, 0.36f}), line = lit(k, "display line", {0.5f, 1.9f, 3.0f}),
              orange = lit(k, "display bar", {2.3f, 0.9f, 0.12f});
    // The body leans in at its foot.
    Mesh foot = shapes::box({s.x - 0.3f, 0.7f, 0.34f}, 0.03f);
    k.add(std::move(foot), body, {0, 0.35f, -0.06f});
    k.board(trim, {0, 0.1f, -0.06f}, {s.x - 0.28f, 0.02f, 0.36f}, 0.004f);
    Mesh slope = shapes::box({s.x, 0.06f, 0.62f}, 0.02f), inlay = shapes::box({s.x - 0.1f, 0.01f, 0.54f}, 0.003f);
    for (Mesh* m : {&slope, &inlay}) shapes::turn(*m, {1, 0, 0}, 18);
    k.add(std::move(slope), body, {0, 0.8f, 0.03f}), k.add(std::move(inlay), dark, {0, 0.834f, 0.03f});
    keys(k, lamps, dark, {-s.x / 2 + 0.1f, 0.78f, 0.24f}, {s.x - 0.2f, 0, 0}, {0, 0.075f, -0.23f},
         std::max(8, static_cast<int>(s.x / 0.07f)), 5, 0.62f);
    // Displays at the back.
    const int screens = std::max(2, static_cast<int>(s.x / 0.5f));
    k.board(body, {0, 0.8f, -s.z / 2 + 0.09f}, {s.x, s.y - 0.8f, 0.07f}, 0.02f);
    for (int i = 0; i < screens; ++i) {
        const float w = (s.x - 0.12f) / static_cast<float>(screens),
                    x = -s.x / 2 + 0.06f + w * (static_cast<float>(i) + 0.5f), z = -s.z / 2 + 0.128f;
        block(k, blue, {x, 0.9f, z}, {w - 0.06f, s.y - 0.95f, 0.006f});
        for (int j = 0; j < 5; ++j)
            block(k, j % 3 == 0 ? orange : line, {x - 0.3f * w + 0.14f * w * static_cast<float>(j), 0.91f, z + 0.004f},
                  {0.05f * w, k.rng.uniform(0.02f, s.y - 0.98f), 0.003f});
    }
    k.piece.clearance_front_m = 0.7f;
}

// A berth in a wall of a spaceship: a rounded pod, lit, with a mattress; two of them, one above the other.
void build_sleeping_pod(Kit& k) {
    const Vec3f s = k.wanted({2.2f, 2.0f, 1.05f});
    const int shell = k.main(plain("pod shell", {0.6f, 0.61f, 0.62f}, 0.3f)),
              dark = color(k, "pod wall", {0.3f, 0.31f, 0.33f}, 0.5f),
              cloth = color(k, "mattress", {0.66f, 0.65f, 0.62f}, 0.9f), cover = k.material(k.style.fabric2),
              light = lit(k, "pod light", {3.0f, 3.2f, 3.4f}), trim = lit(k, "edge light", {0.3f, 1.1f, 3.2f}),
              panel = lit(k, "pod panel", {0.1f, 0.5f, 0.9f});
    const float hz = s.z / 2, storey = s.y / 2;
    k.board(dark, {0, 0, -hz + 0.02f}, {s.x, s.y, 0.04f}, 0.004f);
    for (const float side : {-1.f, 1.f}) k.board(shell, {side * (s.x / 2 - 0.05f), 0, 0}, {0.1f, s.y, s.z}, 0.02f);
    for (int level = 0; level < 2; ++level) {
        const float y = storey * static_cast<float>(level);
        k.board(shell, {0, y, 0}, {s.x, 0.16f, s.z}, 0.02f);
        k.soft(cloth, {0, y + 0.16f, 0}, {s.x - 0.24f, 0.14f, s.z - 0.12f}, {0.05f, 0.02f, 0.003f, 14});
        k.soft(cover, {-0.25f, y + 0.23f, 0.02f}, {s.x - 0.85f, 0.11f, s.z - 0.12f}, {0.05f, 0.02f, 0.006f, 14});
        k.soft(cloth, {s.x / 2 - 0.42f, y + 0.28f, 0}, {0.36f, 0.12f, 0.62f}, {0.05f, 0.03f, 0.003f, 12});
        k.board(light, {0, y + storey - 0.05f, -hz + 0.1f}, {s.x - 0.4f, 0.025f, 0.05f}, 0.004f);
        block(k, panel, {s.x / 2 - 0.75f, y + 0.5f, -hz + 0.042f}, {0.32f, 0.2f, 0.006f});
        k.board(trim, {0, y + 0.07f, hz - 0.004f}, {s.x - 0.3f, 0.018f, 0.012f}, 0.003f);
        // The rounded corners of its mouth.
        for (const float side : {-1.f, 1.f})
            for (const float up : {0.f, 1.f}) {
                const Vec3f at{side * (s.x / 2 - 0.1f), up > 0 ? y + storey : y + 0.16f, hz - 0.03f};
                slat(k, shell, at, at + Vec3f{-side * 0.2f, 0, 0} + Vec3f{0, (up > 0 ? -1.f : 1.f) * 0.2f, 0}, 0.06f,
                     0.05f);
            }
    }
    k.board(shell, {0, s.y - 0.05f, 0}, {s.x, 0.05f, s.z}, 0.015f);
    k.rod(trim, {-s.x / 2 + 0.3f, 0.16f, hz - 0.01f}, {-s.x / 2 + 0.3f, storey, hz - 0.01f}, 0.012f, -1, 8);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

// A table over which a lit globe with rings floats.
void build_holo_table(Kit& k) {
    const int body = k.main(plain("table shell", {0.4f, 0.42f, 0.45f}, 0.3f)),
              dark = color(k, "panel", {0.02f, 0.022f, 0.027f}, 0.3f), trim = lit(k, "edge light", {0.3f, 1.1f, 3.2f}),
              holo = lit(k, "hologram", {0.25f, 1.6f, 2.6f});
    const std::array<Vec2f, 6> p{Vec2f{0.5f, 0}, {0.5f, 0.06f}, {0.3f, 0.14f},
                                 {0.28f, 0.6f},  {0.62f, 0.8f}, {0.62f, 0.86f}};
    k.add(shapes::lathe(p, 12), body);
    k.add(shapes::prism(shapes::circle(0.56f, 12), 0.86f, 0.87f, 0.002f), dark);
    k.add(shapes::ring(0.52f, 0.02f, 36), trim, {0, 0.875f, 0});
    for (const float a : {0.f, 60.f, 120.f}) {
        Mesh ring = shapes::ring(0.28f, 0.008f, 40);
        shapes::turn(ring, {1, 0, 0}, 90), shapes::turn(ring, {0, 1, 0}, a);
        k.add(std::move(ring), holo, {0, 1.25f, 0});
    }
    for (const float y : {-0.16f, 0.f, 0.16f})
        k.add(shapes::ring(std::sqrt(0.28f * 0.28f - y * y), 0.008f, 40), holo, {0, 1.25f + y, 0});
    Mesh orbit = shapes::ring(0.42f, 0.006f, 48);
    shapes::turn(orbit, {1, 0, 0}, 18);
    k.add(std::move(orbit), holo, {0, 1.25f, 0});
    k.add(shapes::ball({0.4f, 1.25f, 0.1f}, {0.035f, 0.035f, 0.035f}, 10), holo);
    k.piece.clearance_front_m = 0.6f;
}

}  // namespace fastscene::furniture
