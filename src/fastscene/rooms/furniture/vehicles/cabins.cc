// What the cabins of buses and trains have: seats, benches, the driver's place, poles, straps, maps, racks.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

constexpr Vec3f kSafetyYellow{0.72f, 0.47f, 0.02f};

// The cloth of seats in buses and trains: a small pattern that hides stains.
Material moquette(Vec3f ground, Vec3f second, Vec3f third) {
    Material m = plain("moquette", ground, 0.95f);
    m.pattern = Pattern::geometric;
    m.color_b = second, m.color_c = third;
    m.scale_m = 0.07f, m.sheen = 0.2f;
    return m;
}

// A bent tube through the points, its corners rounded.
void bent(Kit& k, int material, std::initializer_list<Vec3f> corners, float radius, float bend) {
    const std::vector<Vec3f> p(corners);
    std::vector<Vec3f> path{p.front()};
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        const Vec3f a = p[i] + normalize(p[i - 1] - p[i]) * bend, b = p[i] + normalize(p[i + 1] - p[i]) * bend;
        for (int j = 0; j <= 5; ++j) {
            const float t = static_cast<float>(j) / 5;
            path.push_back(lerp(lerp(a, p[i], t), lerp(p[i], b, t), t));
        }
    }
    path.push_back(p.back());
    k.add(shapes::tube(path, radius, 8), material);
}

}  // namespace

// A pair of seats of a city bus: shells of plastic, cloth with a loud pattern, a yellow bar along their backs.
void build_bus_seat(Kit& k) {
    const int cloth = k.main(moquette({0.02f, 0.05f, 0.2f}, {0.45f, 0.06f, 0.05f}, {0.55f, 0.4f, 0.05f})),
              shell = color(k, "seat shell", {0.2f, 0.21f, 0.23f}, 0.35f), metal = k.material(steel()),
              bar = color(k, "safety yellow", kSafetyYellow, 0.3f);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.212f;
        k.soft(cloth, {x, 0.39f, 0.05f}, {0.41f, 0.09f, 0.42f}, {0.035f, 0.012f, 0.001f, 8});
        Mesh back = shapes::soft_box({0.39f, 0.58f, 0.07f}, {0.03f, 0.012f, 0.001f, 9, k.seed()}),
             rear = shapes::soft_box({0.425f, 0.66f, 0.05f}, {0.024f, 0.004f, 0, 8, k.seed()});
        for (Mesh* m : {&back, &rear}) shapes::turn(*m, {1, 0, 0}, -11);
        k.add(std::move(back), cloth, {x, 0.76f, -0.195f}), k.add(std::move(rear), shell, {x, 0.75f, -0.232f});
        k.board(shell, {x, 0.35f, 0.03f}, {0.42f, 0.05f, 0.46f}, 0.02f);
    }
    k.board(metal, {0, 0, 0.02f}, {0.09f, 0.35f, 0.3f}, 0.02f), k.board(metal, {0, 0, 0.02f}, {0.5f, 0.02f, 0.34f});
    bent(k, bar, {{-0.38f, 0.92f, -0.275f}, {-0.38f, 1.13f, -0.315f}, {0.38f, 1.13f, -0.315f}, {0.38f, 0.92f, -0.275f}},
         0.016f, 0.07f);
    k.piece.clearance_front_m = 0.25f;
}

// The place of a bus's driver, built along the wall behind its back: it drives to +x, the aisle is at +z.
void build_driver_cab(Kit& k) {
    const int panel = k.main(plain("cab panel", {0.33f, 0.34f, 0.36f}, 0.45f)),
              dark = color(k, "dashboard", {0.022f, 0.023f, 0.025f}, 0.5f),
              grip = color(k, "steering wheel", {0.012f, 0.012f, 0.013f}, 0.45f),
              cloth = color(k, "driver's seat", {0.03f, 0.034f, 0.045f}, 0.9f), pane = k.material(glass()),
              bar = color(k, "safety yellow", kSafetyYellow, 0.3f), metal = k.material(steel()),
              dial = lit(k, "dial", {1.6f, 1.7f, 1.8f}), screen = lit(k, "ticket screen", {0.5f, 1.1f, 1.9f}),
              red = lit(k, "warning lamp", {2.f, 0.2f, 0.1f}), needle = color(k, "needle", {0.4f, 0.02f, 0.01f}, 0.4f);
    // The floor is a step higher; the cab reaches from its partition at x = -1 to the windscreen at 1.
    k.board(panel, {-0.05f, 0, -0.09f}, {1.9f, 0.16f, 1.0f}, 0.01f);
    // Below the windscreen, wider than the cab: the dashboard.
    Mesh slope = shapes::box({0.5f, 0.16f, 1.26f}, 0.03f);
    shapes::turn(slope, {0, 0, 1}, -9);
    k.board(panel, {0.83f, 0, 0.02f}, {0.32f, 0.66f, 1.26f}, 0.02f),
        k.add(std::move(slope), dark, {0.73f, 0.73f, 0.02f});
    // Before the wheel: dials under a hood.
    Mesh hood = shapes::box({0.2f, 0.2f, 0.56f}, 0.04f);
    shapes::turn(hood, {0, 0, 1}, 24);
    k.add(std::move(hood), dark, {0.6f, 0.86f, -0.1f});
    for (const float z : {-0.24f, 0.04f}) {
        Mesh disc = shapes::prism(shapes::circle(0.07f, 22), 0, 0.006f, 0.001f);
        shapes::turn(disc, {0, 0, 1}, 114);
        k.add(std::move(disc), dial, {0.505f, 0.89f, z});
        Mesh hand = shapes::box({0.008f, 0.1f, 0.01f}, 0.001f);
        shapes::turn(hand, {1, 0, 0}, 40), shapes::turn(hand, {0, 0, 1}, 24);
        k.add(std::move(hand), needle, {0.492f, 0.885f, z});
    }
    for (int i = 0; i < 9; ++i)
        k.board(i % 4 == 1   ? red
                : i % 3 == 0 ? dial
                             : panel,
                {0.56f, 0.8f, 0.26f + 0.035f * static_cast<float>(i)}, {0.02f, 0.025f, 0.02f}, 0.003f);
    // The wheel of a bus is large and lies flat.
    constexpr float kWheel = 0.235f, kTilt = 28;
    const Vec3f hub{0.34f, 0.93f, -0.1f};
    Mesh rim = shapes::ring(kWheel, 0.032f, 40), boss = shapes::prism(shapes::circle(0.06f, 20), -0.03f, 0.02f, 0.01f);
    for (Mesh* m : {&rim, &boss}) shapes::turn(*m, {0, 0, 1}, kTilt);
    k.add(std::move(rim), grip, hub), k.add(std::move(boss), grip, hub);
    for (const float a : {0.5f, 2.6f, 4.71f}) {
        const Vec3f out{std::cos(a) * std::cos(kTilt * kPi / 180), std::cos(a) * std::sin(kTilt * kPi / 180),
                        std::sin(a)};
        k.rod(grip, hub, hub + out * kWheel, 0.014f, 0.011f, 8);
    }
    k.rod(dark, hub - Vec3f{-0.02f, 0.03f, 0}, {0.62f, 0.2f, -0.1f}, 0.035f, 0.05f, 12);
    // The seat on its spring.
    k.board(dark, {-0.3f, 0.16f, -0.1f}, {0.34f, 0.24f, 0.34f}, 0.03f);
    k.soft(cloth, {-0.28f, 0.52f, -0.1f}, {0.5f, 0.13f, 0.5f}, {0.05f, 0.02f, 0.001f, 10});
    Mesh back = shapes::soft_box({0.13f, 0.68f, 0.48f}, {0.05f, 0.02f, 0.001f, 10, k.seed()}),
         head = shapes::soft_box({0.1f, 0.22f, 0.28f}, {0.04f, 0.015f, 0, 8, k.seed()});
    for (Mesh* m : {&back, &head}) shapes::turn(*m, {0, 0, 1}, 8);
    k.add(std::move(back), cloth, {-0.57f, 0.95f, -0.1f}), k.add(std::move(head), cloth, {-0.66f, 1.4f, -0.1f});
    for (const float z : {-0.36f, 0.16f}) k.board(dark, {-0.34f, 0.78f, z}, {0.36f, 0.05f, 0.05f}, 0.02f);
    // Behind it a partition, glazed above; beside it a low door with a ledge, where tickets are sold.
    k.board(panel, {-0.96f, 0, -0.09f}, {0.05f, 1.15f, 1.0f}, 0.01f);
    k.board(pane, {-0.96f, 1.15f, -0.09f}, {0.01f, 0.72f, 0.94f}, 0.002f);
    bent(k, metal, {{-0.96f, 1.1f, -0.57f}, {-0.96f, 1.9f, -0.57f}, {-0.96f, 1.9f, 0.4f}, {-0.96f, 1.1f, 0.4f}}, 0.016f,
         0.06f);
    k.board(panel, {-0.42f, 0, 0.4f}, {1.06f, 1.02f, 0.045f}, 0.012f);
    k.board(dark, {-0.42f, 1.02f, 0.4f}, {1.06f, 0.03f, 0.09f}, 0.01f);
    k.rod(metal, {0.46f, 0.1f, 0.46f}, {0.46f, 0.95f, 0.46f}, 0.03f, -1, 12);
    k.board(bar, {0.46f, 0.95f, 0.46f}, {0.16f, 0.26f, 0.16f}, 0.03f);
    k.board(dark, {0.44f, 1.0f, 0.544f}, {0.11f, 0.17f, 0.012f}, 0.004f);
    k.board(screen, {0.44f, 1.07f, 0.552f}, {0.085f, 0.08f, 0.004f}, 0.001f);
    bent(k, bar, {{0.1f, 0.16f, 0.5f}, {0.1f, 1.35f, 0.5f}, {-0.9f, 1.35f, 0.5f}, {-0.9f, 0.2f, 0.5f}}, 0.017f, 0.1f);
    k.piece.clearance_front_m = 0.4f;
}

// A bench along the side of a subway carriage: moulded seats side by side, a screen with a bar at each end.
void build_subway_bench(Kit& k) {
    const Vec3f s = k.wanted({2.9f, 1.5f, 0.5f});
    const int seat = k.main(plain("seat plastic", {0.62f, 0.17f, 0.015f}, 0.3f)), metal = k.material(steel()),
              base = color(k, "bench base", {0.24f, 0.245f, 0.25f}, 0.4f), pane = k.material(glass());
    const float half = 0.5f * s.x - 0.05f, back = -0.5f * s.z;
    const int seats = std::max(1, static_cast<int>(2 * half / 0.44f));
    const float wide = (2 * half - 0.04f) / static_cast<float>(seats);
    k.board(base, {0, 0.06f, back + 0.17f}, {2 * half, 0.3f, 0.3f}, 0.01f);
    for (int i = 0; i < seats; ++i) {
        const float x = -half + 0.02f + wide * (static_cast<float>(i) + 0.5f);
        // The cross-section of a shell that one sinks into: from its front edge over the seat and up its back.
        const std::array<Vec2f, 9> line{{{0.485f, 0.36f},
                                         {0.49f, 0.42f},
                                         {0.45f, 0.445f},
                                         {0.3f, 0.425f},
                                         {0.16f, 0.42f},
                                         {0.1f, 0.46f},
                                         {0.075f, 0.6f},
                                         {0.05f, 0.8f},
                                         {0.03f, 0.86f}}};
        const std::vector<Vec2f> smooth = shapes::curve(line, 3);
        const int last = static_cast<int>(smooth.size()) - 1;
        k.add(shapes::slab(
                  8, last, 0.022f,
                  [&](float u, float v) {
                      const Vec2f p = smooth[static_cast<std::size_t>(std::lround(v * static_cast<float>(last)))];
                      const float across = 2 * u - 1, rim = std::pow(std::abs(across), 3.f);
                      return Vec3f{x + across * (0.5f * wide - 0.012f), p.y + (v < 0.6f ? 0.022f * rim : 0.f),
                                   back + p.x + (v < 0.6f ? 0.f : 0.022f * rim)};
                  }),
              seat);
    }
    for (const float side : {-1.f, 1.f}) {
        const float x = side * (half + 0.02f);
        k.board(pane, {x, 0.52f, 0}, {0.012f, 0.9f, s.z - 0.1f}, 0.003f);
        bent(k, metal,
             {{x, 0.02f, 0.5f * s.z - 0.03f}, {x, s.y - 0.02f, 0.5f * s.z - 0.03f}, {x, s.y - 0.02f, back + 0.03f}},
             0.017f, 0.12f);
        k.rod(metal, {x, 0.5f, 0.5f * s.z - 0.03f}, {x, 0.5f, back + 0.03f}, 0.012f, -1, 8);
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.3f;
}

// Of steel, up to the ceiling; from the height of the hips to that of the head it is three.
void build_subway_pole(Kit& k) {
    const Vec3f s = k.wanted({0.16f, 2.36f, 0.16f});
    const int metal = k.main(steel());
    for (const auto& [y0, y1] : {std::pair{0.f, 0.85f}, {1.72f, s.y}})
        k.rod(metal, {0, y0, 0}, {0, y1, 0}, 0.019f, -1, 12);
    for (int i = 0; i < 3; ++i) {
        const Vec3f out = around(kTau * static_cast<float>(i) / 3) * 0.06f;
        bent(k, metal, {{0, 0.8f, 0}, out + Vec3f{0, 0.95f, 0}, out + Vec3f{0, 1.62f, 0}, {0, 1.77f, 0}}, 0.015f,
             0.08f);
    }
    for (const float y : {0.f, s.y - 0.025f})
        k.add(shapes::prism(shapes::circle(0.055f, 18), y, y + 0.025f, 0.004f), metal);
}

// A rail below the ceiling, along the carriage, with loops to hold on to.
void build_strap_rail(Kit& k) {
    const Vec3f s = k.wanted({0.16f, 0.6f, 1.2f});
    const int rail = k.main(steel()), strap = color(k, "strap", {0.025f, 0.026f, 0.028f}, 0.8f),
              grip = color(k, "strap grip", kSafetyYellow, 0.35f);
    constexpr float kDown = 0.24f, kPitch = 0.34f;
    k.rod(rail, {0, -kDown, -0.5f * s.z}, {0, -kDown, 0.5f * s.z}, 0.017f, -1, 12);
    for (const float end : {-1.f, 1.f})
        k.rod(rail, {0, -kDown, end * 0.36f * s.z}, {0, 0, end * 0.36f * s.z}, 0.012f, -1, 8);
    const int straps = std::max(1, static_cast<int>(s.z / kPitch));
    for (int i = 0; i < straps; ++i) {
        const float z = s.z * ((static_cast<float>(i) + 0.5f) / static_cast<float>(straps) - 0.5f);
        k.board(strap, {0, -kDown - 0.19f, z}, {0.006f, 0.21f, 0.032f}, 0.001f);
        // A triangle with rounded corners.
        bent(k, grip,
             {{0, -kDown - 0.18f, z},
              {0, -s.y + 0.012f, z - 0.075f},
              {0, -s.y + 0.012f, z + 0.075f},
              {0, -kDown - 0.18f, z}},
             0.0105f, 0.03f);
    }
    k.piece.mount = Mount::ceiling;
}

// A strip of light along a ceiling.
void build_strip_lights(Kit& k) {
    const Vec3f s = k.wanted({0.16f, 0.03f, 1.2f});
    constexpr float kWide = 0.16f;  // however wide its cell is
    const int frame = k.main(plain("light frame", {0.6f, 0.6f, 0.6f}, 0.4f)),
              lamp = k.material(glow("strip light", {8.f, 8.1f, 7.9f}));
    k.board(frame, {0, -s.y, 0}, {kWide, s.y, s.z}, 0.006f),
        k.board(lamp, {0, -s.y - 0.004f, 0}, {kWide - 0.04f, 0.012f, s.z - 0.02f}, 0.002f);
    k.piece.mount = Mount::ceiling;
}

// A strip of advertisements as they hang above the windows of carriages.
void build_ad_strip(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 0.26f, 0.02f});
    const int frame = k.main(steel());
    constexpr std::array kPrints{Print::offers, Print::travel_posters, Print::film_posters, Print::food_posters,
                                 Print::concert_posters};
    const PrintSheet sheet = print_sheet(k, kPrints[static_cast<std::size_t>(k.rng.index(5))]);
    const int grounds = 3;
    const Vec3f tone = k.accent();
    const int card = color(k, "card", lerp(tone, {0.7f, 0.7f, 0.68f}, 0.35f), 0.5f),
              ink = color(k, "ink", {0.03f, 0.03f, 0.04f}, 0.5f);
    const float wide = (s.x - 0.02f) / grounds, high = s.y - 0.04f;
    for (int i = 0; i < grounds; ++i) {
        const float x0 = -0.5f * s.x + 0.01f + wide * static_cast<float>(i);
        block(k, card, {x0 + 0.5f * wide, 0.02f, 0.004f}, {wide - 0.012f, high, 0.008f});
        // A picture at the left, lines of text beside it.
        const float picture = std::min(0.72f * high, 0.45f * wide);
        k.add(printed_face(sheet[k.rng.index(sheet.cells)], {picture, high - 0.03f}), sheet.material,
              {x0 + 0.02f, 0.035f, 0.009f});
        for (int line = 0; line < 3; ++line)
            block(k, ink,
                  {x0 + picture + 0.04f + 0.5f * (wide - picture - 0.08f), 0.06f + 0.055f * static_cast<float>(line),
                   0.009f},
                  {(wide - picture - 0.08f) * (line == 2 ? 0.95f : 0.7f), line == 2 ? 0.03f : 0.014f, 0.002f});
    }
    for (const float y : {0.f, s.y - 0.02f}) k.board(frame, {0, y, 0.5f * s.z}, {s.x, 0.02f, s.z}, 0.004f);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.86f;
}

// The map of a line as it hangs above a carriage's doors: stations along a coloured line.
void build_line_map(Kit& k) {
    const Vec3f s = k.wanted({1.3f, 0.16f, 0.016f});
    const int card = k.main(plain("line map", {0.74f, 0.74f, 0.72f}, 0.35f)), line = color(k, "line", k.accent(), 0.4f),
              ink = color(k, "station ink", {0.02f, 0.02f, 0.025f}, 0.5f),
              white = color(k, "station", {0.78f, 0.78f, 0.78f}, 0.4f);
    k.board(card, {0, 0, 0.5f * s.z}, s, 0.004f);
    const float y = 0.36f * s.y, half = 0.5f * s.x - 0.07f;
    block(k, line, {0, y - 0.011f, s.z}, {2 * half, 0.022f, 0.002f});
    const int stations = 11;
    for (int i = 0; i < stations; ++i) {
        const float x = half * (2.f * static_cast<float>(i) / (stations - 1) - 1);
        const bool change = k.rng.chance(0.3f);
        for (const auto& [r, deep, material] :
             {std::tuple{change ? 0.021f : 0.014f, 0.003f, ink}, {change ? 0.014f : 0.009f, 0.004f, white}}) {
            Mesh disc = shapes::prism(shapes::circle(r, 14), 0, deep, 0.0005f);
            shapes::turn(disc, {1, 0, 0}, 90);
            k.add(std::move(disc), material, {x, y, s.z + 0.002f});
        }
        // Its name, slanting upwards.
        const float name = k.rng.uniform(0.045f, 0.085f);
        slat(k, ink, {x + 0.004f, y + 0.032f, s.z + 0.001f},
             {x + 0.004f + 0.6f * name, y + 0.032f + 0.8f * name, s.z + 0.001f}, 0.009f, 0.002f);
    }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 2.0f;
}

// The door from one carriage to the next: steel, with a pane through which it is dark.
void build_carriage_door(Kit& k) {
    const Vec3f s = k.wanted({0.86f, 2.0f, 0.06f});
    const int frame = k.main(plain("door frame", {0.3f, 0.305f, 0.31f}, 0.4f)),
              leaf = color(k, "carriage door", {0.52f, 0.53f, 0.54f}, 0.32f),
              night = color(k, "dark pane", {0.012f, 0.014f, 0.018f}, 0.06f),
              seal = color(k, "seal", {0.018f, 0.018f, 0.019f}, 0.5f), metal = k.material(steel()),
              yellow = color(k, "safety yellow", kSafetyYellow, 0.35f),
              red = color(k, "handle", {0.5f, 0.02f, 0.015f}, 0.35f);
    constexpr float kFrame = 0.07f;
    for (const float side : {-1.f, 1.f})
        k.board(frame, {side * 0.5f * (s.x - kFrame), 0, 0.5f * s.z}, {kFrame, s.y, s.z}, 0.012f);
    k.board(frame, {0, s.y - kFrame, 0.5f * s.z}, {s.x - 2 * kFrame, kFrame, s.z}, 0.012f);
    const float wide = s.x - 2 * kFrame;
    k.board(leaf, {0, 0.01f, 0.018f}, {wide, s.y - kFrame - 0.01f, 0.035f}, 0.004f);
    for (const auto& [grow, z, material] : {std::tuple{0.022f, 0.038f, seal}, {0.f, 0.041f, night}}) {
        Mesh pane = shapes::prism(shapes::rounded_rectangle(0.62f * wide + grow, 0.74f + grow, 0.09f), 0, 0.006f,
                                  0.001f);
        shapes::turn(pane, {1, 0, 0}, 90);
        k.add(std::move(pane), material, {0, 1.36f, z});
    }
    k.rod(metal, {0.36f * wide, 0.85f, 0.075f}, {0.36f * wide, 1.15f, 0.075f}, 0.013f, -1, 10);
    for (const float y : {0.86f, 1.13f})
        k.rod(metal, {0.36f * wide, y, 0.03f}, {0.36f * wide, y, 0.075f}, 0.009f, -1, 8);
    k.board(yellow, {-0.2f * wide, 0.62f, 0.037f}, {0.2f, 0.12f, 0.004f}, 0.001f);
    k.board(red, {-0.36f * wide, 1.0f, 0.05f}, {0.05f, 0.09f, 0.03f}, 0.01f);
    k.piece.mount = Mount::wall;
}

// A rack for luggage above the seats of a train, with a bag or two.
void build_luggage_rack(Kit& k) {
    const Vec3f s = k.wanted({1.6f, 0.3f, 0.38f});
    const int metal = k.main(steel()), pane = k.material(glass());
    k.board(pane, {0, 0.035f, 0.5f * s.z}, {s.x - 0.02f, 0.012f, s.z - 0.05f}, 0.002f);
    for (const float z : {0.03f, 0.34f * s.z, 0.67f * s.z, s.z - 0.02f})
        k.rod(metal, {-0.5f * s.x, 0.03f, z}, {0.5f * s.x, 0.03f, z}, 0.013f, -1, 8);
    for (const float x : {-0.42f * s.x, 0.42f * s.x})
        bent(k, metal, {{x, 0.22f, 0.006f}, {x, 0.014f, 0.01f}, {x, 0.014f, s.z - 0.02f}, {x, 0.07f, s.z - 0.015f}},
             0.011f, 0.03f);
    for (float x = -0.32f * s.x; x < 0.3f * s.x; x += 0.55f) {
        if (!k.rng.chance(0.55f)) continue;
        const int bag = color(k, "luggage", lerp(k.accent(), {0.04f, 0.04f, 0.05f}, 0.5f), 0.7f);
        const Vec3f size{k.rng.uniform(0.36f, 0.5f), k.rng.uniform(0.16f, 0.22f), 0.27f};
        k.soft(bag, {x, 0.047f, 0.5f * s.z}, size, {0.04f, 0.015f, 0.003f, 8});
        bent(k, bag,
             {{x - 0.08f, 0.06f + 0.6f * size.y, 0.5f * s.z + 0.13f},
              {x - 0.07f, 0.02f + 0.4f * size.y, 0.5f * s.z + 0.15f},
              {x + 0.07f, 0.02f + 0.4f * size.y, 0.5f * s.z + 0.15f},
              {x + 0.08f, 0.06f + 0.6f * size.y, 0.5f * s.z + 0.13f}},
             0.009f, 0.02f);
    }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.86f;
}

}  // namespace fastscene::furniture
