// Balls, what they are kept in, and the hoop they fly through.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// A thin line about y.
Mesh ball_seam(float r, float thick) {
    std::vector<Vec3f> path;
    for (int i = 0; i <= 28; ++i) path.push_back(around(kTau * static_cast<float>(i) / 28) * r);
    return shapes::tube(path, thick, 3);
}
// A basketball, its seams three great circles.
void basketball_at(Kit& k, int leather, int seam, Vec3f c, float r) {
    k.add(shapes::ball(c, {r, r, r}, 18), leather);
    for (int i = 0; i < 3; ++i) {
        Mesh m = ball_seam(r, 0.025f * r);
        if (i > 0) shapes::turn(m, i == 1 ? Vec3f{1, 0, 0} : Vec3f{0, 0, 1}, 90);
        shapes::turn(m, {1, 0, 0}, 20), shapes::turn(m, {0, 1, 0}, 25);
        k.add(std::move(m), seam, c);
    }
}
void soccer_ball_at(Kit& k, int white, int black, Vec3f c, float r) {
    k.add(shapes::ball(c, {r, r, r}, 20), white);
    const float g = 0.5f * (1 + std::sqrt(5.f));
    for (const float a : {-1.f, 1.f})
        for (const float b : {-g, g})
            for (const Vec3f& d : {Vec3f{0, a, b}, Vec3f{a, b, 0}, Vec3f{b, 0, a}}) {
                const Vec3f n = normalize(d),
                            s = normalize(cross(n, std::abs(n.y) < 0.9f ? Vec3f{0, 1, 0} : Vec3f{1, 0, 0})),
                            t = cross(n, s);
                k.add(shapes::sheet(5, 2,
                                    [&](float u, float v) {
                                        const float w = kTau * u, rad = 0.37f * (0.04f + 0.96f * v);
                                        return c +
                                               normalize(n + (s * std::cos(w) + t * std::sin(w)) * rad) * (1.008f * r);
                                    }),
                      black);
            }
}

}  // namespace

void build_basketball(Kit& k) {
    const int leather = k.main(plain("basketball", {0.5f, 0.16f, 0.035f}, 0.7f));
    basketball_at(k, leather, color(k, "seam", {0.02f, 0.018f, 0.016f}, 0.8f), {0, 0.12f, 0}, 0.12f);
}

void build_soccer_ball(Kit& k) {
    const int white = k.main(plain("football", {0.76f, 0.75f, 0.73f}, 0.35f));
    soccer_ball_at(k, white, color(k, "patches", {0.025f, 0.025f, 0.028f}, 0.35f), {0, 0.11f, 0}, 0.11f);
}

// A cage on castors full of balls.
void build_ball_bin(Kit& k) {
    const Vec3f s = k.wanted({0.95f, 0.85f, 0.65f});
    const int wire = k.main(plain("cage lacquer", {0.05f, 0.12f, 0.35f}, 0.4f)),
              seam = color(k, "seam", {0.02f, 0.018f, 0.016f}, 0.8f),
              orange = color(k, "basketball", {0.5f, 0.16f, 0.035f}, 0.7f),
              white = color(k, "football", {0.76f, 0.75f, 0.73f}, 0.4f),
              yellow = color(k, "volleyball", {0.7f, 0.55f, 0.08f}, 0.5f),
              blue = color(k, "blue ball", {0.05f, 0.14f, 0.5f}, 0.5f),
              red = color(k, "red ball", {0.55f, 0.05f, 0.04f}, 0.5f),
              dark = color(k, "castors", {0.02f, 0.02f, 0.02f}, 0.6f);
    const float low = 0.14f, hx = 0.5f * s.x - 0.015f, hz = 0.5f * s.z - 0.015f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(wire, {sx * hx, 0.1f, sz * hz}, {sx * hx, s.y, sz * hz}, 0.014f, -1, 8),
                k.add(shapes::ball({sx * hx, 0.05f, sz * hz}, {0.03f, 0.05f, 0.05f}, 10), dark);
    for (int i = 0; i < 6; ++i) {
        const float y = low + (s.y - low - 0.01f) * static_cast<float>(i) / 5, r = i == 0 || i == 5 ? 0.012f : 0.005f;
        for (const float e : {-1.f, 1.f})
            k.rod(wire, {-hx, y, e * hz}, {hx, y, e * hz}, r, -1, 6),
                k.rod(wire, {e * hx, y, -hz}, {e * hx, y, hz}, r, -1, 6);
    }
    block(k, wire, {0, low - 0.005f, 0}, {2 * hx, 0.01f, 2 * hz});
    for (int row = 0; row < 3; ++row)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 2; ++j) {
                const float r = k.rng.uniform(0.105f, 0.122f);
                const Vec3f c{(2 * hx - 0.26f) * (static_cast<float>(i) / 2 - 0.5f) + k.rng.uniform(-0.015f, 0.015f),
                              low + 0.12f + 0.22f * static_cast<float>(row),
                              (hz - 0.13f) * (j ? 1.f : -1.f) + k.rng.uniform(-0.015f, 0.015f)};
                switch (k.rng.index(5)) {
                    case 0: basketball_at(k, orange, seam, c, r); break;
                    case 1: soccer_ball_at(k, white, seam, c, r); break;
                    case 2: k.add(shapes::ball(c, {r, r, r}, 18), yellow); break;
                    case 3: k.add(shapes::ball(c, {r, r, r}, 18), blue); break;
                    default: k.add(shapes::ball(c, {r, r, r}, 18), red);
                }
            }
    k.piece.clearance_front_m = 0.4f;
}

// A board on brackets with its ring and net.
void build_basketball_hoop(Kit& k) {
    const int white = k.main(plain("backboard", {0.75f, 0.75f, 0.73f}, 0.25f)),
              orange = color(k, "ring", {0.65f, 0.13f, 0.02f}, 0.4f),
              cord = color(k, "net", {0.74f, 0.73f, 0.7f}, 0.9f),
              metal = color(k, "bracket", {0.2f, 0.2f, 0.21f}, 0.4f);
    const float z = 0.35f;
    k.board(white, {0, 0.3f, z}, {1.4f, 0.95f, 0.03f}, 0.01f);
    const auto frame = [&](float w, float h, float y, float t) {
        for (const float e : {-1.f, 1.f})
            block(k, orange, {e * 0.5f * (w - t), y, z + 0.016f}, {t, h, 0.002f}),
                block(k, orange, {0, e < 0 ? y : y + h - t, z + 0.016f}, {w, t, 0.002f});
    };
    frame(1.38f, 0.93f, 0.31f, 0.05f), frame(0.59f, 0.45f, 0.45f, 0.045f);
    for (const float sx : {-1.f, 1.f}) {
        for (const float y : {0.5f, 1.0f}) k.rod(metal, {sx * 0.4f, y, 0}, {sx * 0.4f, y, z}, 0.022f, -1, 8);
        k.rod(metal, {sx * 0.4f, 0.42f, 0.02f}, {sx * 0.4f, 1.08f, 0.02f}, 0.022f, -1, 8);
        k.rod(metal, {sx * 0.4f, 0.5f, 0.03f}, {sx * 0.4f, 1.0f, z}, 0.014f, -1, 8);
    }
    const Vec3f c{0, 0.42f, z + 0.4f};
    k.add(shapes::ring(0.23f, 0.011f, 28), orange, c),
        k.board(orange, {0, 0.36f, z + 0.09f}, {0.16f, 0.06f, 0.18f}, 0.01f);
    constexpr int kCords = 12;
    for (int i = 0; i < kCords; ++i)
        for (const float lean : {-1.f, 1.f}) {
            std::vector<Vec3f> path;
            for (int j = 0; j <= 4; ++j) {
                const float t = static_cast<float>(j) / 4;
                path.push_back(c +
                               around(kTau * (static_cast<float>(i) + lean * 2 * t) / kCords) * (0.225f - 0.1f * t) +
                               Vec3f{0, -0.42f * t, 0});
            }
            k.add(shapes::tube(path, 0.004f, 4), cord);
        }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.9f;
}

// Three shelves of bowling balls.
void build_bowling_ball_rack(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 0.95f, 0.5f});
    const int frame = k.main(plain("rack lacquer", {0.06f, 0.06f, 0.065f}, 0.35f)),
              hole = color(k, "holes", {0.01f, 0.01f, 0.01f}, 0.9f);
    static constexpr std::array<Vec3f, 6> kBalls{Vec3f{0.45f, 0.03f, 0.04f}, {0.03f, 0.1f, 0.42f},
                                                 {0.03f, 0.28f, 0.12f},      {0.6f, 0.3f, 0.02f},
                                                 {0.25f, 0.05f, 0.35f},      {0.03f, 0.03f, 0.035f}};
    std::array<int, 6> balls{};
    for (std::size_t i = 0; i < balls.size(); ++i) balls[i] = color(k, "bowling ball", kBalls[i], 0.08f);
    for (const float sx : {-1.f, 1.f}) {
        k.board(frame, {sx * (0.5f * s.x - 0.03f), 0, 0}, {0.05f, s.y - 0.12f, 0.08f}, 0.008f);
        k.board(frame, {sx * (0.5f * s.x - 0.03f), 0, 0}, {0.06f, 0.05f, s.z}, 0.01f);
    }
    for (int row = 0; row < 3; ++row) {
        const float y = 0.16f + 0.29f * static_cast<float>(row);
        for (const float dz : {-0.07f, 0.07f})
            k.rod(frame, {-0.5f * s.x + 0.02f, y, dz}, {0.5f * s.x - 0.02f, y, dz}, 0.016f, -1, 8);
        const int count = std::max(2, static_cast<int>((s.x - 0.1f) / 0.235f));
        for (int i = 0; i < count; ++i) {
            const Vec3f c{
                -0.5f * s.x + 0.05f + (s.x - 0.1f) * (static_cast<float>(i) + 0.5f) / static_cast<float>(count),
                y + 0.1f, 0};
            k.add(shapes::ball(c, {0.108f, 0.108f, 0.108f}, 15), balls[static_cast<std::size_t>(k.rng.index(6))]);
            for (const float a : {0.2f, 1.f, 3.4f}) {
                const Vec3f d = normalize(Vec3f{0.25f * std::cos(a), 0.55f + 0.25f * std::sin(a), 0.75f});
                k.rod(hole, c + d * 0.1f, c + d * 0.1085f, 0.014f, -1, 8);
            }
        }
    }
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture
