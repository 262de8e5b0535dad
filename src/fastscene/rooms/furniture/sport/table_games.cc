// Games at tables: table tennis, table football, air hockey, pinball, chess.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

void build_table_tennis(Kit& k) {
    const Vec3f s = k.wanted({2.74f, 0.76f, 1.525f});
    const int top = k.main(plain("table tennis top", {0.03f, 0.11f, 0.3f}, 0.55f)),
              white = color(k, "lines", {0.76f, 0.76f, 0.74f}, 0.6f),
              metal = color(k, "frame", {0.05f, 0.05f, 0.055f}, 0.4f),
              net = color(k, "net", {0.06f, 0.06f, 0.06f}, 0.9f), red = color(k, "bat", {0.5f, 0.03f, 0.03f}, 0.6f),
              wood = k.material(materials::timber("natural", 0.5f));
    for (const float sx : {-1.f, 1.f}) {
        k.board(top, {sx * 0.25f * s.x, s.y - 0.03f, 0}, {0.5f * s.x - 0.006f, 0.03f, s.z}, 0.004f);
        k.board(metal, {sx * 0.25f * s.x, s.y - 0.08f, 0}, {0.5f * s.x - 0.06f, 0.05f, s.z - 0.06f}, 0.004f);
        for (const float sz : {-1.f, 1.f}) {
            k.board(metal, {sx * 0.4f * s.x, 0, sz * 0.38f * s.z}, {0.05f, s.y - 0.07f, 0.05f}, 0.006f),
                k.board(metal, {sx * 0.07f * s.x, 0, sz * 0.38f * s.z}, {0.05f, s.y - 0.07f, 0.05f}, 0.006f);
            k.board(metal, {sx * 0.235f * s.x, 0.2f, sz * 0.38f * s.z}, {0.33f * s.x, 0.035f, 0.03f}, 0.004f);
        }
        block(k, white, {sx * (0.5f * s.x - 0.01f), s.y, 0}, {0.02f, 0.001f, s.z}),
            block(k, white, {0, s.y, sx * (0.5f * s.z - 0.01f)}, {s.x, 0.001f, 0.02f});
    }
    block(k, white, {0, s.y, 0}, {s.x, 0.001f, 0.006f});
    const float hz = 0.5f * s.z + 0.12f;
    for (const float sz : {-1.f, 1.f})
        k.board(metal, {0, s.y - 0.05f, sz * (hz - 0.01f)}, {0.03f, 0.21f, 0.02f}, 0.004f),
            k.board(metal, {0, s.y - 0.05f, sz * (hz - 0.07f)}, {0.04f, 0.03f, 0.14f}, 0.004f);
    block(k, white, {0, s.y + 0.145f, 0}, {0.008f, 0.012f, 2 * hz});
    for (int i = 0; i < 5; ++i)
        block(k, net, {0, s.y + 0.005f + 0.03f * static_cast<float>(i), 0}, {0.002f, 0.003f, 2 * hz});
    for (int i = 0; i <= 44; ++i)
        block(k, net, {0, s.y, -hz + 2 * hz * static_cast<float>(i) / 44}, {0.002f, 0.146f, 0.003f});
    for (const float sx : {-1.f, 1.f}) {
        const Vec3f at{sx * 0.36f * s.x, s.y + 0.002f, sx * 0.2f * s.z};
        k.add(shapes::prism(shapes::circle(0.077f, 20), 0, 0.012f, 0.002f), sx > 0 ? red : net, at),
            k.board(wood, at + Vec3f{sx * 0.11f, 0, 0}, {0.1f, 0.018f, 0.028f}, 0.006f);
    }
    k.add(shapes::ball({0.2f * s.x, s.y + 0.02f, 0.1f}, {0.02f, 0.02f, 0.02f}, 12), white);
    k.piece.clearance_front_m = 0.4f, k.piece.clearance_side_m = 0.7f;
}

void build_football_table(Kit& k) {
    const int wood = k.main(k.style.wood), field = color(k, "pitch", {0.04f, 0.22f, 0.06f}, 0.6f),
              white = color(k, "lines", {0.74f, 0.74f, 0.72f}, 0.6f), metal = k.material(steel()),
              red = color(k, "red players", {0.55f, 0.03f, 0.03f}, 0.4f),
              blue = color(k, "blue players", {0.03f, 0.1f, 0.45f}, 0.4f),
              dark = color(k, "handle", {0.02f, 0.02f, 0.02f}, 0.5f);
    const float w = 1.4f, d = 0.76f, top = 0.9f, pitch = 0.76f;
    for (const float sz : {-1.f, 1.f})
        k.board(wood, {0, 0.62f, sz * (0.5f * d - 0.02f)}, {w, top - 0.62f, 0.04f}, 0.008f);
    for (const float sx : {-1.f, 1.f}) {
        k.board(wood, {sx * (0.5f * w - 0.02f), 0.62f, 0}, {0.04f, top - 0.62f, d - 0.08f}, 0.008f),
            block(k, dark, {sx * (0.5f * w - 0.041f), pitch + 0.005f, 0}, {0.003f, 0.09f, 0.2f});
        for (const float sz : {-1.f, 1.f})
            k.board(wood, {sx * (0.5f * w - 0.08f), 0, sz * (0.5f * d - 0.07f)}, {0.1f, 0.63f, 0.1f}, 0.01f);
        block(k, white, {sx * 0.45f, pitch, 0}, {0.008f, 0.001f, 0.36f});
    }
    k.board(field, {0, pitch - 0.03f, 0}, {w - 0.08f, 0.03f, d - 0.08f}, 0.002f),
        block(k, white, {0, pitch, 0}, {0.008f, 0.001f, d - 0.08f});
    Mesh ring = shapes::ring(0.1f, 0.003f, 28);
    k.add(std::move(ring), white, {0, pitch, 0}),
        k.add(shapes::ball({0.06f, pitch + 0.018f, 0.05f}, {0.018f, 0.018f, 0.018f}, 10), white);
    static constexpr std::array<int, 8> kMen{1, 2, 3, 5, 5, 3, 2, 1};
    static constexpr std::array<bool, 8> kRed{true, true, false, true, false, true, false, false};
    for (std::size_t r = 0; r < 8; ++r) {
        const float x = (static_cast<float>(r) - 3.5f) * 0.155f, y = top - 0.05f, out = kRed[r] ? 1.f : -1.f;
        k.rod(metal, {x, y, -0.5f * d - (out < 0 ? 0.22f : 0.12f)}, {x, y, 0.5f * d + (out > 0 ? 0.22f : 0.12f)},
              0.008f, -1, 8);
        k.rod(dark, {x, y, out * (0.5f * d + 0.12f)}, {x, y, out * (0.5f * d + 0.24f)}, 0.017f, -1, 10);
        const float pitch_z = (d - 0.2f) / static_cast<float>(kMen[r]);
        for (int i = 0; i < kMen[r]; ++i) {
            const float z = pitch_z * (static_cast<float>(i) + 0.5f - 0.5f * static_cast<float>(kMen[r]));
            const int shirt = kRed[r] ? red : blue;
            block(k, shirt, {x, y - 0.065f, z}, {0.02f, 0.095f, 0.034f}),
                block(k, dark, {x, y - 0.08f, z}, {0.026f, 0.022f, 0.03f});
            k.add(shapes::ball({x, y + 0.045f, z}, {0.014f, 0.016f, 0.014f}, 8), white);
        }
    }
    k.piece.clearance_front_m = 0.5f;
}

void build_air_hockey(Kit& k) {
    const int body = k.main(plain("air hockey case", {0.03f, 0.08f, 0.3f}, 0.3f)),
              ice = color(k, "playfield", {0.72f, 0.75f, 0.77f}, 0.12f),
              dark = color(k, "rails", {0.03f, 0.03f, 0.033f}, 0.4f),
              red = color(k, "red", {0.6f, 0.03f, 0.03f}, 0.35f),
              blue = color(k, "blue line", {0.03f, 0.15f, 0.55f}, 0.4f), show = lit(k, "score", {1.4f, 0.15f, 0.08f});
    const float w = 2.1f, d = 1.15f, top = 0.8f;
    for (const float sx : {-1.f, 1.f}) k.board(body, {sx * 0.72f, 0, 0}, {0.3f, 0.58f, 0.7f}, 0.03f);
    k.board(body, {0, 0.56f, 0}, {w, 0.19f, d}, 0.03f),
        k.board(ice, {0, 0.745f, 0}, {w - 0.1f, 0.012f, d - 0.1f}, 0.003f);
    for (const float e : {-1.f, 1.f}) {
        k.board(dark, {0, 0.75f, e * (0.5f * d - 0.045f)}, {w, top - 0.75f, 0.09f}, 0.012f);
        for (const float sz : {-1.f, 1.f})
            k.board(dark, {e * (0.5f * w - 0.045f), 0.75f, sz * 0.35f}, {0.09f, top - 0.75f, 0.34f}, 0.012f);
        block(k, blue, {e * 0.4f, 0.7575f, 0}, {0.03f, 0.001f, d - 0.18f});
        const std::array<Vec2f, 6> mallet{Vec2f{0.05f, 0},  {0.05f, 0.02f},  {0.035f, 0.03f},
                                          {0.018f, 0.035f}, {0.018f, 0.06f}, {0.012f, 0.07f}};
        k.add(shapes::lathe(mallet, 18), red, {e * 0.68f, 0.757f, e * 0.12f});
        Mesh ring = shapes::ring(0.2f, 0.006f, 24);
        k.add(std::move(ring), red, {e * 0.5f * w - e * 0.3f, 0.754f, 0});
    }
    block(k, red, {0, 0.7575f, 0}, {0.03f, 0.001f, d - 0.18f});
    k.add(shapes::ring(0.14f, 0.006f, 24), red, {0, 0.754f, 0}),
        k.add(shapes::prism(shapes::circle(0.04f, 18), 0, 0.008f, 0.002f), red, {0.2f, 0.757f, -0.15f});
    for (const float sz : {-1.f, 1.f}) k.board(dark, {0, top, sz * (0.5f * d - 0.045f)}, {0.05f, 0.5f, 0.04f}, 0.008f);
    k.board(dark, {0, top + 0.46f, 0}, {0.09f, 0.16f, d - 0.04f}, 0.02f);
    for (const float sx : {-1.f, 1.f})
        for (const float z : {-0.25f, 0.25f}) block(k, show, {sx * 0.046f, top + 0.5f, z}, {0.002f, 0.08f, 0.12f});
    k.piece.clearance_front_m = 0.5f;
}

// A sloping playfield under glass with bumpers, and a lit box with the score behind.
void build_pinball(Kit& k) {
    const int body = k.main(plain("pinball case",
                                  k.rng.chance(0.5f) ? Vec3f{0.3f, 0.02f, 0.03f} : Vec3f{0.03f, 0.05f, 0.25f}, 0.3f)),
              metal = k.material(steel()), field = color(k, "playfield", {0.45f, 0.3f, 0.1f}, 0.25f),
              red = color(k, "bumper", {0.6f, 0.04f, 0.03f}, 0.3f),
              white = color(k, "flipper", {0.74f, 0.72f, 0.66f}, 0.3f),
              blue = color(k, "targets", {0.03f, 0.2f, 0.55f}, 0.3f);
    const int art = lit(k, "backglass", {0.9f, 0.45f, 0.12f}), star_lit = lit(k, "backglass star", {1.4f, 1.2f, 0.4f}),
              score = lit(k, "score", {1.2f, 0.2f, 0.05f}), bulb = lit(k, "lamps", {1.6f, 1.1f, 0.4f});
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(metal, {sx * 0.3f, 0, sz * 0.62f}, {sx * 0.26f, 0.8f, sz * 0.58f}, 0.025f, -1, 8);
    constexpr float kSlope = 6.5f;
    const auto sloped = [&](Mesh m, int mat, Vec3f at) {
        shapes::move(m, at), shapes::turn(m, {1, 0, 0}, kSlope), k.add(std::move(m), mat, {0, 0.78f, 0});
    };
    sloped(shapes::box({0.58f, 0.28f, 1.32f}, 0.015f), body, {0, 0, 0}),
        sloped(shapes::box({0.5f, 0.006f, 1.2f}, 0.001f), field, {0, 0.144f, 0});
    for (const float sx : {-1.f, 1.f}) {
        sloped(shapes::box({0.035f, 0.06f, 1.32f}, 0.008f), metal, {sx * 0.275f, 0.16f, 0});
        Mesh flip = shapes::box({0.13f, 0.025f, 0.03f}, 0.01f);
        shapes::turn(flip, {0, 1, 0}, sx * 28);
        sloped(std::move(flip), white, {sx * 0.1f, 0.16f, 0.43f}),
            sloped(shapes::box({0.02f, 0.03f, 0.25f}, 0.004f), blue, {sx * 0.19f, 0.16f, 0.25f});
        k.rod(red, {sx * 0.29f, 0.76f, 0.5f}, {sx * 0.305f, 0.76f, 0.5f}, 0.018f, -1, 10);
    }
    for (const auto& [x, z] : {std::pair{-0.1f, -0.25f}, {0.1f, -0.3f}, {0.0f, -0.1f}}) {
        sloped(shapes::rod({x, 0.145f, z}, {x, 0.18f, z}, 0.03f, 0.03f, 14), white, {}),
            sloped(shapes::rod({x, 0.18f, z}, {x, 0.195f, z}, 0.05f, 0.045f, 16), red, {}),
            sloped(shapes::ball({x, 0.196f, z}, {0.02f, 0.01f, 0.02f}, 10), bulb, {});
    }
    for (int i = 0; i < 9; ++i)
        sloped(shapes::box({0.03f, 0.004f, 0.03f}, 0.001f), i % 2 ? bulb : blue,
               {-0.16f + 0.04f * static_cast<float>(i), 0.149f, 0.05f + 0.1f * std::sin(static_cast<float>(i) * 0.8f)});
    sloped(shapes::box({0.46f, 0.05f, 0.02f}, 0.004f), red, {0, 0.17f, -0.5f});
    k.rod(metal, {0.22f, 0.62f, 0.66f}, {0.22f, 0.62f, 0.76f}, 0.012f, -1, 8),
        k.add(shapes::ball({0.22f, 0.62f, 0.77f}, {0.022f, 0.022f, 0.02f}, 10), metal),
        k.board(metal, {0, 0.5f, 0.665f}, {0.22f, 0.18f, 0.01f}, 0.004f);
    k.board(body, {0, 0.9f, -0.58f}, {0.62f, 0.16f, 0.24f}, 0.01f),
        k.board(body, {0, 1.05f, -0.6f}, {0.7f, 0.75f, 0.22f}, 0.015f);
    block(k, art, {0, 1.27f, -0.489f}, {0.6f, 0.48f, 0.002f}),
        block(k, score, {0, 1.13f, -0.489f}, {0.5f, 0.09f, 0.002f});
    Mesh st = shapes::prism(star(0.2f, 0.09f), 0, 0.004f, 0.001f);
    shapes::turn(st, {1, 0, 0}, 90);
    k.add(std::move(st), star_lit, {0, 1.5f, -0.487f});
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.7f;
}

// A board with the pieces of an opening.
void build_chess(Kit& k) {
    const int frame = k.main(k.style.wood2), light = k.material(materials::timber("natural", 0.35f)),
              dark = k.material(materials::timber("walnut", 0.35f)),
              white = color(k, "white pieces", {0.62f, 0.5f, 0.32f}, 0.3f),
              black = color(k, "black pieces", {0.03f, 0.025f, 0.022f}, 0.3f);
    constexpr float kSquare = 0.047f;
    k.board(frame, {0, 0, 0}, {8 * kSquare + 0.05f, 0.02f, 8 * kSquare + 0.05f}, 0.004f);
    const auto at = [&](int file, int rank) {
        return Vec3f{kSquare * (static_cast<float>(file) - 3.5f), 0.02f, kSquare * (3.5f - static_cast<float>(rank))};
    };
    for (int f = 0; f < 8; ++f)
        for (int r = 0; r < 8; ++r) {
            const Vec3f c = at(f, r);
            k.add(shapes::sheet(1, 1,
                                [&](float u, float v) {
                                    return c + Vec3f{kSquare * (u - 0.5f), 0.0006f, kSquare * (0.5f - v)};
                                }),
                  (f + r) % 2 ? light : dark);
        }
    const auto man = [&](int file, int rank, float tall, bool is_white) {
        const float r = 0.014f + 0.05f * (tall - 0.04f);
        const std::array<Vec2f, 6> p{Vec2f{r, 0},
                                     {0.9f * r, 0.15f * tall},
                                     {0.4f * r, 0.3f * tall},
                                     {0.42f * r, 0.66f * tall},
                                     {0.66f * r, 0.72f * tall},
                                     {0.25f * r, 0.78f * tall}};
        k.add(shapes::lathe(p, 7, true), is_white ? white : black, at(file, rank));
        k.add(shapes::ball(at(file, rank) + Vec3f{0, 0.87f * tall, 0}, {0.55f * r, 0.13f * tall, 0.55f * r}, 5),
              is_white ? white : black);
    };
    static constexpr std::array<float, 8> kTall{0.05f, 0.062f, 0.068f, 0.082f, 0.09f, 0.068f, 0.062f, 0.05f};
    const int e = 2 + k.rng.index(4), d = 2 + k.rng.index(4);
    for (int f = 0; f < 8; ++f) {
        man(f, 0, kTall[static_cast<std::size_t>(f)], true), man(f, 7, kTall[static_cast<std::size_t>(f)], false);
        man(f, f == e ? 3 : 1, 0.045f, true), man(f, f == d ? 4 : 6, 0.045f, false);
    }
    on_surface(k);
}

}  // namespace fastscene::furniture
