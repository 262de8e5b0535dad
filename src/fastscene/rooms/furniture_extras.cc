// What stands or hangs in a room only when asked for, and is more than a wish of a day: tall clocks, plants that hang,
// cacti, lanterns, a bowl of fish, a cart of bottles, a child's tent, a ball of mirrors.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture_kit.h"

namespace fastscene::furniture {
namespace {

// A tall case: plinth, trunk with a glass door before the pendulum, hood with the dial; its top is arched, stepped or
// plain as the style has it.
void grandfather_clock(Kit& k) {
    const Vec3f s = k.wanted({0.5f, 2.02f, 0.28f});
    const int wood = k.main(k.style.mouldings == Mouldings::rich || k.style.name == "rustic" ? k.style.wood2
                                                                                             : k.style.wood),
              brass = k.material(*material_named("brass")),
              face = k.material(plain("dial", {0.72f, 0.68f, 0.57f}, 0.5f)),
              dark = k.material(plain("clock hands", {0.035f, 0.035f, 0.035f}, 0.5f)),
              shade = k.material(plain("clock case", {0.06f, 0.04f, 0.028f}, 0.8f)), pane = k.material(glass());
    const bool formal = k.style.mouldings != Mouldings::none || k.style.name == "rustic" || k.style.name == "boho";
    const float h = s.y, w = s.x, d = s.z, plinth = 0.19f * h, hood = 0.72f * h, top = 0.945f * h, trunk = 0.76f * w,
                deep = 0.8f * d;
    const auto moulding = [&](float y, float width, float depth, float high) {
        k.board(wood, {0, y, 0}, {width, high, depth}, 0.35f * high);
    };
    // Plinth.
    k.board(wood, {0, 0, 0}, {w, 0.05f, d}, 0.006f);
    k.board(wood, {0, 0.05f, 0}, {0.92f * w, plinth - 0.05f, 0.93f * d}, 0.004f);
    if (formal) k.board(wood, {0, 0.09f, 0.465f * d}, {0.66f * w, plinth - 0.14f, 0.012f}, 0.005f);
    moulding(plinth, 0.9f * w, 0.92f * d, 0.03f);
    if (formal) moulding(plinth + 0.03f, 0.83f * w, 0.86f * d, 0.02f);
    // Trunk: its back and sides, a door with a pane, the pendulum and the weights behind it.
    const float t0 = plinth + (formal ? 0.05f : 0.03f), t1 = hood - 0.05f, front = 0.5f * deep, stile = 0.055f;
    k.board(shade, {0, t0, -0.5f * deep + 0.01f}, {trunk, t1 - t0, 0.02f}, 0.002f);
    for (const float sx : {-1.f, 1.f}) {
        k.board(wood, {sx * (0.5f * trunk - 0.01f), t0, 0}, {0.02f, t1 - t0, deep}, 0.003f);
        k.board(wood, {sx * (0.5f * trunk - 0.5f * stile), t0, front}, {stile, t1 - t0, 0.022f}, 0.004f);
    }
    k.board(wood, {0, t0, front}, {trunk - 2 * stile, 0.07f, 0.022f}, 0.004f);
    k.board(wood, {0, t1 - 0.07f, front}, {trunk - 2 * stile, 0.07f, 0.022f}, 0.004f);
    k.board(pane, {0, t0 + 0.07f, front - 0.003f}, {trunk - 2 * stile, t1 - t0 - 0.14f, 0.003f}, 0.0008f);
    k.add(shapes::ball({0.5f * trunk - 0.5f * stile, 0.5f * (t0 + t1), front + 0.018f}, {0.009f, 0.009f, 0.009f}, 10),
          brass);
    const float bob = t0 + 0.25f;
    k.rod(brass, {0.02f, bob, 0}, {0, t1, 0}, 0.005f, -1, 8);
    Mesh disc = shapes::prism(shapes::circle(0.065f, 36), -0.011f, 0.011f, 0.009f);
    shapes::turn(disc, {1, 0, 0}, 90);
    k.add(std::move(disc), brass, {0.02f, bob, 0.004f});
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * 0.075f, y = t1 - (sx > 0 ? 0.42f : 0.56f);
        k.rod(brass, {x, y, -0.03f}, {x, y + 0.19f, -0.03f}, 0.021f, -1, 18);
        k.rod(brass, {x, y + 0.19f, -0.03f}, {x, t1, -0.03f}, 0.0022f, -1, 6);
    }
    moulding(t1, 0.84f * w, 0.88f * d, 0.02f);
    moulding(t1 + 0.02f, 0.94f * w, 0.95f * d, 0.03f);
    // Hood: a box with the dial, columns at its corners.
    const float hw = 0.88f * w, hd = 0.9f * d, hz = 0.5f * hd, dial = 0.185f * h * 0.9f * 0.5f + 0.03f,
                cy = 0.5f * (hood + top);
    k.board(wood, {0, hood, -0.01f}, {hw, top - hood, hd - 0.03f}, 0.004f);
    Mesh ring = shapes::ring(dial, 0.022f, 48), plate = shapes::prism(shapes::circle(dial, 48), 0.f, 0.006f, 0.001f);
    shapes::turn(ring, {1, 0, 0}, 90), shapes::turn(plate, {1, 0, 0}, 90);
    const float fz = hz - 0.024f;
    k.board(brass, {0, cy - dial - 0.02f, fz}, {2 * dial + 0.04f, 2 * dial + 0.04f, 0.006f}, 0.001f);
    k.add(std::move(plate), face, {0, cy, fz});
    k.add(std::move(ring), brass, {0, cy, fz + 0.008f});
    const auto hand = [&](float from, float to, float wide, float degrees, float z, int material) {
        Mesh m = shapes::box({wide, to - from, 0.002f}, 0.0005f);
        shapes::move(m, {0, 0.5f * (from + to), 0});
        shapes::turn(m, {0, 0, 1}, degrees);
        k.add(std::move(m), material, {0, cy, z});
    };
    for (int i = 0; i < 12; ++i)
        hand(0.72f * dial, 0.88f * dial, i % 3 == 0 ? 0.011f : 0.006f, 30.f * static_cast<float>(i), fz + 0.0068f,
             dark);
    hand(-0.02f, 0.5f * dial, 0.011f, k.dice.uniform(0, 360), fz + 0.0095f, dark);
    hand(-0.025f, 0.76f * dial, 0.008f, k.dice.uniform(0, 360), fz + 0.0125f, dark);
    if (formal)
        for (const float sx : {-1.f, 1.f}) {
            k.rod(wood, {sx * (0.5f * hw - 0.012f), hood + 0.03f, hz - 0.014f},
                  {sx * (0.5f * hw - 0.012f), top - 0.02f, hz - 0.014f}, 0.015f, 0.012f, 14);
            for (const float y : {hood, top - 0.03f})
                k.board(brass, {sx * (0.5f * hw - 0.012f), y, hz - 0.014f}, {0.036f, 0.03f, 0.036f}, 0.004f);
        }
    moulding(top, 0.96f * w, 0.97f * d, 0.025f);
    moulding(top + 0.02f, w, d, 0.022f);
    if (formal) {
        // An arch over the hood, a brass ball on it.
        std::vector<Vec2f> arch;
        const float rise = h - top - 0.075f;
        for (int i = 0; i <= 20; ++i) {
            const float t = static_cast<float>(i) / 10.f - 1.f;
            arch.push_back(
                {0.46f * w * t, -(0.25f * rise + 0.75f * rise * std::cos(0.5f * kPi * t) * std::cos(0.5f * kPi * t))});
        }
        arch.push_back({0.46f * w, 0}), arch.push_back({-0.46f * w, 0});
        Mesh m = shapes::prism(arch, -0.4f * d, 0.46f * d, 0.006f);
        shapes::turn(m, {1, 0, 0}, 90);
        k.add(std::move(m), wood, {0, top + 0.042f, 0});
        k.rod(brass, {0, h - 0.05f, 0}, {0, h - 0.028f, 0}, 0.008f, -1, 10);
        k.add(shapes::ball({0, h - 0.017f, 0}, {0.017f, 0.017f, 0.017f}, 16), brass);
    } else {
        k.board(wood, {0, top + 0.042f, 0}, {0.8f * w, h - top - 0.042f, 0.8f * d}, 0.004f);
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.4f;
}

// A pot in a net of cords under the ceiling: vines with leaves hang from it, or fronds arch out.
void hanging_plant(Kit& k) {
    const float size = k.request.size_factor,
                drop = (k.request.size_m.y > 0.5f ? 0.62f * k.request.size_m.y : 0.82f * size);
    k.sized = true;
    const bool trailing = k.request.pattern == "trailing" || (k.request.pattern != "fern" && k.dice.chance(0.7f));
    const int green = k.main(foliage(k, trailing ? Vec3f{0.08f, 0.19f, 0.055f} : Vec3f{0.1f, 0.23f, 0.07f}, 0.05f)),
              stem = k.material(plain("stem", {0.09f, 0.15f, 0.05f}, 0.8f)),
              soil = k.material(plain("soil", {0.06f, 0.042f, 0.03f}, 0.95f)),
              cord = k.material(plain("cotton cord", {0.66f, 0.6f, 0.47f}, 0.95f)), metal = k.material(k.style.metal);
    Material clay = plain("plant pot", k.dice.chance(0.5f) ? Vec3f{0.7f, 0.68f, 0.63f} : Vec3f{0.46f, 0.21f, 0.12f},
                          0.6f);
    if (k.style.plants > 0.8f && k.dice.chance(0.4f)) clay = *material_named("wicker");
    const float r = 0.115f * size, high = 0.15f * size, base = -drop - high, rim = -drop;
    const std::array<Vec2f, 6> p{Vec2f{0.5f * r, 0}, {0.62f * r, 0.006f},      {0.88f * r, 0.3f * high},
                                 {r, 0.65f * high},  {0.99f * r, 0.9f * high}, {0.96f * r, high}};
    k.add(shapes::vessel(shapes::curve(p, 2), 0.007f, 32), k.material(clay), {0, base, 0});
    k.add(shapes::prism(shapes::circle(0.86f * r, 24), -0.03f, -0.018f), soil, {0, rim, 0});
    k.add(shapes::prism(shapes::circle(0.025f, 20), -0.012f, 0.f, 0.003f), metal);
    k.rod(metal, {0, -0.05f, 0}, {0, -0.008f, 0}, 0.003f, -1, 6);
    // Four cords from a knot, apart about the pot, together below it.
    const Vec3f knot{0, -drop + 0.42f * drop + 0.06f, 0};
    k.rod(cord, knot, {0, -0.04f, 0}, 0.006f, -1, 8);
    k.add(shapes::ball(knot, {0.013f, 0.017f, 0.013f}, 12), cord);
    for (int i = 0; i < 4; ++i) {
        const Vec3f out = around(1.5708f * static_cast<float>(i) + 0.4f);
        const std::array<Vec3f, 6> path{knot,
                                        out * (0.7f * r) + Vec3f{0, 0.5f * (knot.y + rim), 0},
                                        out * (1.03f * r) + Vec3f{0, rim, 0},
                                        out * (1.05f * r) + Vec3f{0, base + 0.62f * high, 0},
                                        out * (0.7f * r) + Vec3f{0, base - 0.002f, 0},
                                        Vec3f{0, base - 0.03f, 0}};
        k.add(shapes::tube(path, 0.0035f, 6), cord);
        k.add(shapes::ball(path[3], {0.009f, 0.011f, 0.009f}, 8), cord);
    }
    k.add(shapes::ball({0, base - 0.032f, 0}, {0.013f, 0.016f, 0.013f}, 12), cord);
    for (int i = 0; i < 7; ++i) {
        const float a = 0.9f * static_cast<float>(i), x = 0.008f * std::cos(a), z = 0.008f * std::sin(a);
        k.rod(cord, {x, base - 0.04f, z}, {2.2f * x, base - 0.12f, 2.2f * z}, 0.0026f, -1, 5);
    }
    if (!trailing) {
        for (int i = 0; i < 46; ++i) {
            const float a = 2.39996f * static_cast<float>(i), t = static_cast<float>(i) / 46.f;
            k.add(blade(around(a) * (0.3f * r) + Vec3f{0, rim - 0.02f, 0}, around(a), size * (0.36f - 0.14f * t),
                        0.03f * size, 0.75f + 1.5f * t, 1.65f - 0.3f * t, 0.7f),
                  green);
        }
        k.piece.mount = Mount::ceiling;
        return;
    }
    Mesh stems;
    const int vines = 11;
    for (int i = 0; i < vines; ++i) {
        const float a = 2.39996f * static_cast<float>(i), length = size * k.dice.uniform(0.22f, 0.62f),
                    swing = k.dice.uniform(0.6f, 1.f);
        const Vec3f out = around(a), side{-out.z, 0, out.x};
        // Over the rim, then straight down, a little wavy.
        const float phase = k.dice.uniform(0, kTau);
        const auto vine = [&](float t) {
            const float over = std::min(1.f, t / 0.18f), down = std::max(0.f, t - 0.12f) / 0.88f;
            return out * (r * (0.45f + (0.62f + 0.12f * swing) * over) + 0.012f * std::sin(6.f * t + phase)) +
                   side * (0.018f * std::sin(5.f * t + 2.f * phase)) +
                   Vec3f{0, rim - 0.015f + 0.05f * std::sin(kPi * std::min(1.f, t / 0.26f)) - length * down, 0};
        };
        std::vector<Vec3f> path;
        for (int j = 0; j <= 14; ++j) path.push_back(vine(static_cast<float>(j) / 14.f));
        shapes::append(stems, shapes::tube(path, 0.0022f, 5));
        const int leaves = 4 + static_cast<int>(length / 0.036f);
        for (int j = 0; j < leaves; ++j) {
            const float t = (static_cast<float>(j) + 0.4f) / static_cast<float>(leaves),
                        la = a + (j % 2 ? 1.1f : -1.1f) + k.dice.uniform(-0.5f, 0.5f),
                        l = size * k.dice.uniform(0.04f, 0.062f) * (1.15f - 0.45f * t);
            k.add(blade(vine(t), around(la), l, 0.8f * l, k.dice.uniform(-0.1f, 0.35f), 0.9f, 0.62f), green);
        }
    }
    // A tuft where they come from.
    for (int i = 0; i < 16; ++i) {
        const float a = 2.39996f * static_cast<float>(i) + 0.3f;
        k.add(blade(around(a) * (0.2f * r) + Vec3f{0, rim - 0.015f, 0}, around(a), size * k.dice.uniform(0.07f, 0.11f),
                    0.055f * size, k.dice.uniform(0.6f, 1.6f), 0.8f, 0.62f),
              green);
    }
    k.add(std::move(stems), stem);
    k.piece.mount = Mount::ceiling;
}

// A thorn of four triangles.
void thorn(Mesh& into, Vec3f base, Vec3f tip, float wide) {
    const Vec3f along = normalize(tip - base),
                side = normalize(cross(along, std::abs(along.y) < 0.9f ? Vec3f{0, 1, 0} : Vec3f{1, 0, 0})),
                up = cross(along, side);
    const auto first = static_cast<std::uint32_t>(into.positions.size());
    for (int i = 0; i < 3; ++i) {
        const float a = kTau * static_cast<float>(i) / 3.f;
        const Vec3f out = side * std::cos(a) + up * std::sin(a);
        into.positions.push_back(base + out * wide);
        into.normals.push_back(out);
    }
    into.positions.push_back(tip);
    into.normals.push_back(along);
    for (const std::array<std::uint32_t, 3>& t : {std::array<std::uint32_t, 3>{0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
        into.triangles.insert(into.triangles.end(), {first + t[0], first + t[1], first + t[2]});
}
// A ribbed column of a cactus from a to b, its end rounded; spines on the ribs.
void ribbed(Kit& k, int green, Mesh& spines, Vec3f a, Vec3f b, float r, int ribs, bool flat_foot) {
    const Vec3f along = normalize(b - a),
                side = normalize(std::abs(along.y) < 0.9f ? cross(along, Vec3f{0, 1, 0})
                                                          : cross(along, Vec3f{1, 0, 0})),
                other = cross(along, side);
    const float l = length(b - a), round = std::min(r, 0.5f * l);
    const auto point = [&](float u, float v) {
        // The ends are round.
        const float t = v * l,
                    foot = flat_foot ? 1.f
                                     : std::sqrt(std::max(0.f, 1.f - std::pow(std::max(0.f, 1.f - t / round), 2.f))),
                    head = std::sqrt(std::max(0.f, 1.f - std::pow(std::max(0.f, 1.f - (l - t) / round), 2.f)));
        const float rib = 1.f + 0.11f * std::cos(static_cast<float>(ribs) * kTau * u),
                    out = r * std::max(0.015f, foot * head) * rib;
        return a + along * t + (side * std::cos(kTau * u) + other * std::sin(kTau * u)) * out;
    };
    const int rows = std::max(10, static_cast<int>(l / r * 4.f));
    k.add(shapes::sheet(ribs * 4, rows, [&](float u, float v) { return point(1.f - u, v * v * (3 - 2 * v)); }), green);
    for (int i = 0; i < ribs; ++i)
        for (float v = 0.12f; v < 0.97f; v += 0.6f * r / l) {
            const Vec3f p = point(static_cast<float>(i) / static_cast<float>(ribs), v), axis = a + along * (v * l),
                        out = normalize(p - axis);
            for (const float way : {-1.f, 0.f, 1.f})
                thorn(spines, p - out * 0.001f,
                      p + normalize(out + along * (0.7f * way) + other * (0.25f * way)) * (0.16f * r + 0.004f),
                      0.0006f + 0.006f * r);
        }
}
// In a clay pot: a column with arms, a ball with a flower, paddles. A large one stands on the floor.
void cactus(Kit& k) {
    const bool tall = k.request.size_factor > 1.05f || k.request.size_m.y > 0.7f || k.request.pattern == "tall";
    const float high = k.request.size_m.y > 0 ? k.request.size_m.y : tall ? 1.35f : 0.28f * k.request.size_factor;
    k.sized = true;
    Material skin = plain("cactus", {0.09f, 0.19f, 0.085f}, 0.7f);
    const int green = k.main(skin), spine = k.material(plain("spines", {0.66f, 0.6f, 0.42f}, 0.7f)),
              clay = k.material(plain("terracotta pot",
                                      k.style.name == "modern" || k.style.name == "art deco"
                                          ? Vec3f{0.68f, 0.66f, 0.62f}
                                          : Vec3f{0.46f, 0.2f, 0.11f},
                                      0.8f)),
              soil = k.material(plain("gravel", {0.3f, 0.25f, 0.19f}, 0.95f));
    const float pot_high = tall ? 0.26f * high : 0.32f * high, r = tall ? 0.155f : 0.27f * high;
    const std::array<Vec2f, 6> p{Vec2f{0.68f * r, 0},           {0.7f * r, 0.01f * high}, {0.92f * r, 0.76f * pot_high},
                                 {1.04f * r, 0.78f * pot_high}, {1.06f * r, pot_high},    {1.05f * r, pot_high}};
    k.add(shapes::vessel(std::span(p).first(5), 0.06f * r, 32), clay);
    k.add(shapes::prism(shapes::circle(0.88f * r, 24), 0.6f * pot_high, 0.87f * pot_high), soil);
    const float y = 0.85f * pot_high, rise = high - y;
    Mesh spines;
    const int kind = tall ? 0 : k.dice.index(3);
    if (kind == 0) {
        const float c = tall ? 0.082f : 0.38f * r;
        ribbed(k, green, spines, {0, y, 0}, {0, high, 0}, c, 11, true);
        // Arms go out and then up.
        for (const auto& [sx, from, to] : {std::tuple{-1.f, 0.36f, 0.72f}, {1.f, 0.5f, 0.84f}}) {
            const float ax = sx * 2.55f * c, ay = y + from * rise;
            ribbed(k, green, spines, {sx * 0.5f * c, ay - 0.2f * c, 0}, {ax + sx * 0.3f * c, ay + 0.35f * c, 0},
                   0.6f * c, 9, false);
            ribbed(k, green, spines, {ax, ay + 0.05f * c, 0}, {ax, y + to * rise, 0}, 0.62f * c, 9, false);
        }
    } else if (kind == 1) {
        const float c = std::min(0.5f * rise, 0.95f * r);
        ribbed(k, green, spines, {0, y - 0.3f * c, 0}, {0, high - 0.16f * rise, 0}, c, 15, false);
        const int bloom = k.material(plain("cactus flower", {0.6f, 0.12f, 0.26f}, 0.6f));
        for (int i = 0; i < 9; ++i) {
            const float a = kTau * static_cast<float>(i) / 9.f;
            k.add(blade({0, high - 0.17f * rise, 0}, around(a), 0.14f * rise, 0.06f * rise, 1.5f, 0.7f, 0.8f), bloom);
        }
    } else {
        // Paddles grow on paddles.
        const auto paddle = [&](Vec3f foot, float lean, float yaw, float size) {
            Mesh m = shapes::ball({0, 0.5f * size, 0}, {0.34f * size, 0.52f * size, 0.1f * size}, 22);
            shapes::turn(m, {0, 0, 1}, lean);
            shapes::turn(m, {0, 1, 0}, yaw);
            k.add(std::move(m), green, foot);
            for (int i = 0; i < 26; ++i) {
                const float a = 2.39996f * static_cast<float>(i),
                            q = std::sqrt((static_cast<float>(i) + 0.5f) / 26.f) * 0.9f, side = i % 2 ? 1.f : -1.f;
                Mesh s;
                thorn(s, {0, 0, 0}, {0, 0, side * 0.035f * size}, 0.006f * size);
                shapes::lay_grain(s);
                shapes::move(s, {0.34f * size * q * std::cos(a), 0.5f * size + 0.5f * size * q * std::sin(a),
                                 side * 0.1f * size * std::sqrt(1 - q * q)});
                shapes::turn(s, {0, 0, 1}, lean);
                shapes::turn(s, {0, 1, 0}, yaw);
                shapes::append(spines, shapes::move(s, foot));
            }
        };
        const float size = 0.56f * rise;
        paddle({0, y - 0.03f * rise, 0}, 0.f, 20.f, size);
        paddle({-0.1f * size, y + 0.78f * size, 0.02f * size}, 32.f, 5.f, 0.72f * size);
        paddle({0.14f * size, y + 0.8f * size, 0}, -28.f, 40.f, 0.78f * size);
    }
    shapes::lay_grain(spines);
    k.add(std::move(spines), spine);
    k.piece.mount = tall ? Mount::floor : Mount::surface;
}

// Poles tied near their tops, canvas about them with its flaps drawn aside, a cushion within.
void play_tent(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 1.65f, 1.2f});
    Material canvas = plain("canvas", {0.7f, 0.66f, 0.57f}, 0.95f);
    canvas.pattern = Pattern::fabric;
    canvas.scale_m = 0.004f;
    canvas.color_b = canvas.color_a * 0.88f;
    canvas.transmission = 0.12f;
    canvas.specular = 0.02f;
    const int cloth = k.main(canvas), wood = k.material(*material_named("pine")),
              cord = k.material(plain("cord", {0.5f, 0.42f, 0.3f}, 0.9f)),
              mat = k.material(tinted(k.style.fabric2, lerp(k.accent(), {0.6f, 0.56f, 0.5f}, 0.35f))),
              band = k.material(tinted(k.style.fabric2, k.accent()));
    const float hx = 0.46f * s.x, hz = 0.46f * s.z, tie = 0.82f * s.y, neck = 0.045f;
    // Corner i: at the floor, where the poles meet, and on beyond.
    const auto corner = [&](int i, float y) {
        const float sx = i == 0 || i == 3 ? -1.f : 1.f, sz = i < 2 ? 1.f : -1.f, t = y / tie;
        return Vec3f{sx * std::lerp(hx, 0.f, t), y, sz * std::lerp(hz, 0.f, t)};
    };
    for (int i = 0; i < 4; ++i) k.rod(wood, corner(i, 0.f), corner(i, s.y), 0.014f, 0.011f, 10);
    for (const float y : {tie - 0.03f, tie - 0.015f, tie}) k.add(shapes::ring(0.03f, 0.012f, 20), cord, {0, y, 0});
    const float top = tie * (1.f - neck / hx);
    const auto wall = [&](Vec3f a0, Vec3f a1, Vec3f b0, Vec3f b1, int columns,
                          float sag) {  // from a to b, foot to head; sagging inward
        const Vec3f in = normalize(Vec3f{-(a0.x + b0.x), 0, -(a0.z + b0.z)});
        const std::uint32_t seed = k.seed();
        k.add(shapes::slab(columns, 10, 0.003f,
                           [&](float u, float v) {
                               const Vec3f low = lerp(a0, b0, u), high = lerp(a1, b1, u);
                               return lerp(low, high, v) +
                                      in * (sag * std::sin(kPi * u) * std::sin(kPi * std::min(1.f, v + 0.2f)) +
                                            0.006f * shapes::wobble({u * 4, v * 4, 0}, seed)) +
                                      Vec3f{0, 0.006f, 0};
                           }),
              cloth);
    };
    for (const int i : {1, 2, 3})
        wall(corner(i, 0), corner(i, top), corner((i + 1) % 4, 0), corner((i + 1) % 4, top), 12, 0.03f);
    // The front: closed above, below two flaps drawn to the poles.
    const float eave = 0.6f * tie;
    wall(corner(0, eave), corner(0, top), corner(1, eave), corner(1, top), 10, 0.008f);
    for (const int i : {0, 1}) {
        const int j = 1 - i;
        const Vec3f a0 = corner(i, 0), a1 = corner(i, eave), to = corner(j, eave);
        const std::uint32_t seed = k.seed();
        k.add(shapes::slab(10, 16, 0.003f,
                           [&](float u, float v) {
                               // Wide under the eave, gathered by a tie at a third of the height, falling in folds
                               // below.
                               const float across = i == 0 ? u : 1.f - u, waist = 0.34f,
                                           t = v < waist ? (waist - v) / waist : (v - waist) / (1 - waist);
                               const float wide = v < waist ? 0.13f + 0.13f * t : 0.13f + 0.37f * t * t,
                                           fold = 0.013f * std::sin(16.f * across) * (1.f - 0.7f * t * (v > waist));
                               const Vec3f edge = lerp(a0, a1, v), dir = normalize(Vec3f{to.x - a1.x, 0, 0});
                               const float reach = wide * (v < waist ? 2.f * hx * 0.62f : 2.f * hx * 0.4f + 0.02f);
                               return edge + dir * (across * reach) +
                                      Vec3f{0, 0.006f,
                                            0.012f + fold + 0.005f * shapes::wobble({across * 5, v * 5, 0}, seed)};
                           }),
              cloth);
        const Vec3f at = corner(i, 0.34f * eave);
        k.add(shapes::ring(0.055f, 0.014f, 20), band, at + Vec3f{i == 0 ? 0.04f : -0.04f, 0, 0.012f});
    }
    // Within: a mat and cushions; pennants over the door.
    k.soft(mat, {0, 0, -0.02f}, {1.7f * hx, 0.06f, 1.7f * hz}, {0.028f, 0.012f, 0.003f, 10});
    for (const float sx : {-1.f, 1.f}) {
        Mesh cushion = shapes::pillow({0.36f, 0.34f, 0.12f}, k.seed(), 10);
        shapes::turn(cushion, {1, 0, 0}, -24);
        shapes::turn(cushion, {0, 1, 0}, -sx * 14);
        k.add(std::move(cushion), sx > 0 ? band : k.material(tinted(k.style.fabric2, k.accent())),
              {sx * 0.17f, 0.062f, -0.5f * hz});
    }
    for (int i = 0; i < 5; ++i) {
        const float t = (static_cast<float>(i) + 0.5f) / 5.f;
        const Vec3f at = lerp(corner(0, eave), corner(1, eave), t) + Vec3f{0, 0.045f - 0.04f * 4 * t * (1 - t), 0.012f};
        const float half = 0.32f * (corner(1, eave).x - corner(0, eave).x) / 5.f * 1.2f;
        k.add(
            shapes::slab(2, 3, 0.002f,
                         [&](float u, float v) {
                             return at + Vec3f{(u - 0.5f) * 2.f * half * std::max(v, 0.03f), -0.085f * (1 - v), 0.004f};
                         }),
            k.material(plain("pennant", k.style.palette[static_cast<std::size_t>(i) % k.style.palette.size()], 0.9f)));
    }
    k.piece.clearance_front_m = 0.5f;
}

// A bowl of clear glass with water, gravel, a weed and two goldfish.
void fish_bowl(Kit& k) {
    const float size = k.request.size_factor * (k.request.size_m.x > 0 ? k.request.size_m.x / 0.26f : 1.f);
    k.sized = true;
    const float r = 0.13f * size;
    const int fish = k.main(plain("goldfish", {0.7f, 0.22f, 0.02f}, 0.3f)), clear = k.material(glass()),
              gravel = k.material(plain("gravel", {0.52f, 0.46f, 0.36f}, 0.9f)),
              weed = k.material(foliage(k, {0.06f, 0.2f, 0.06f}, 0.08f)),
              eye = k.material(plain("eye", {0.02f, 0.02f, 0.02f}, 0.2f));
    Material water = glass();
    water.name = "water";
    water.color_a = water.color_b = water.color_c = {0.66f, 0.78f, 0.8f};
    std::vector<Vec2f> wall, inside;
    for (int i = 0; i <= 16; ++i) {
        const float a = -1.25f + 2.05f * static_cast<float>(i) / 16.f;
        wall.push_back({r * std::cos(a), r * (std::sin(a) + std::sin(1.25f))});
    }
    wall.push_back({wall.back().x * 1.04f, wall.back().y + 0.012f * size});
    k.add(shapes::vessel(wall, 0.004f * size, 40), clear);
    const float level = 1.38f * r, floor = 0.012f * size;
    k.add(shapes::shade(
              std::array<Vec2f, 2>{
                  Vec2f{std::sqrt(std::max(0.f, r * r - (level - 0.949f * r) * (level - 0.949f * r))) - 0.008f * size,
                        level},
                  Vec2f{0.001f, level}},
              36),
          k.material(water));
    const std::array<Vec2f, 4> bed{Vec2f{0.3f * r, floor},
                                   {0.52f * r, floor + 0.06f * r},
                                   {0.56f * r, floor + 0.13f * r},
                                   {0.1f * r, floor + 0.2f * r}};
    k.add(shapes::lathe(bed, 24, true), gravel);
    for (int i = 0; i < 9; ++i)
        k.add(blade({0.25f * r + 0.05f * r * std::cos(2.4f * static_cast<float>(i)), floor + 0.15f * r, -0.2f * r},
                    around(2.4f * static_cast<float>(i)), 0.22f * r, 0.07f * r, k.dice.uniform(2.2f, 4.2f), 0.4f, 1.1f),
              weed);
    for (const auto& [at, yaw] :
         {std::pair{Vec3f{-0.28f * r, 0.95f * r, 0.25f * r}, 25.f}, {Vec3f{0.2f * r, 0.66f * r, 0.3f * r}, 200.f}}) {
        const float l = 0.3f * r;
        const auto put = [&](Mesh m, int material, const Vec3f& p = Vec3f{}, float turn_deg = 0.f) {
            shapes::turn(m, {0, 1, 0}, turn_deg);
            k.add(std::move(m), material, p);
        };
        put(shapes::ball({0, 0, 0}, {l, 0.5f * l, 0.3f * l}, 16), fish, at, yaw);
        put(shapes::slab(3, 4, 0.0015f,
                         [&](float u, float v) {
                             return Vec3f{-0.8f * l - 0.75f * l * u, (v - 0.5f) * l * (0.2f + 1.1f * u),
                                          0.12f * l * std::sin(3 * u)};
                         }),
            fish, at, yaw);
        put(shapes::slab(
                3, 2, 0.001f,
                [&](float u, float v) {
                    return Vec3f{0.4f * l - 0.8f * l * u, 0.4f * l + 0.32f * l * v * std::sin(0.3f + 2.6f * u), 0};
                }),
            fish, at, yaw);
        for (const float sz : {-1.f, 1.f})
            put(shapes::ball({0.68f * l, 0.1f * l, sz * 0.2f * l}, {0.07f * l, 0.07f * l, 0.05f * l}, 8), eye, at, yaw);
    }
    k.piece.mount = Mount::surface;
}

// Two shelves in a frame of tubes on wheels, with bottles and glasses.
void bar_cart(Kit& k) {
    const Vec3f s = k.wanted({0.78f, 0.86f, 0.42f});
    const bool brassy = is_one_of(k.style.name, {"art deco", "mid-century", "classic", "boho", "modern"});
    const int frame = k.main(brassy ? *material_named("brass") : k.style.metal);
    const bool wooden = is_one_of(k.style.name,
                                  {"rustic", "industrial", "boho", "mid-century", "scandinavian", "japandi"});
    const int shelf = k.material(wooden ? k.style.wood : plain("smoked glass", {0.05f, 0.05f, 0.05f}, 0.08f)),
              tire = k.material(plain("tire", {0.04f, 0.04f, 0.04f}, 0.7f)), clear = k.material(glass());
    const float hx = 0.5f * s.x - 0.05f, hz = 0.5f * s.z - 0.025f, wheel = 0.055f, low = 0.22f, high = 0.72f * s.y;
    for (const float sx : {-1.f, 1.f}) {
        for (const float sz : {-1.f, 1.f}) {
            k.rod(frame, {sx * hx, wheel + 0.015f, sz * hz}, {sx * hx, s.y - 0.035f, sz * hz}, 0.0105f, -1, 12);
            Mesh tread = shapes::prism(shapes::circle(wheel, 28), -0.011f, 0.011f, 0.004f),
                 hub = shapes::prism(shapes::circle(0.4f * wheel, 20), -0.013f, 0.013f, 0.003f);
            for (Mesh* m : {&tread, &hub}) shapes::turn(*m, {1, 0, 0}, 90), shapes::move(*m, {sx * hx, wheel, sz * hz});
            k.add(std::move(tread), tire);
            k.add(std::move(hub), frame);
        }
        // Bows that one pushes it by.
        std::vector<Vec3f> bow_path;
        for (int i = 0; i <= 14; ++i) {
            const float a = kPi * static_cast<float>(i) / 14.f;
            bow_path.push_back(
                {sx * (hx + 0.04f * std::sin(a)), s.y - 0.035f + 0.025f * std::sin(a), hz * std::cos(a)});
        }
        k.add(shapes::tube(bow_path, 0.0105f, 12), frame);
    }
    for (const float y : {low, high}) {
        k.board(shelf, {0, y, 0}, {2 * hx - 0.01f, 0.014f, 2 * hz - 0.01f}, 0.003f);
        for (const float sz : {-1.f, 1.f})
            for (const float dy : {0.f, 0.06f})
                k.rod(frame, {-hx, y + dy, sz * hz}, {hx, y + dy, sz * hz}, 0.006f, -1, 10);
        for (const float sx : {-1.f, 1.f})
            for (const float dy : {0.f, 0.06f})
                k.rod(frame, {sx * hx, y + dy, -hz}, {sx * hx, y + dy, hz}, 0.006f, -1, 10);
    }
    static constexpr std::array<Vec3f, 5> kDrinks{Vec3f{0.3f, 0.13f, 0.03f},
                                                  {0.04f, 0.12f, 0.05f},
                                                  {0.62f, 0.6f, 0.52f},
                                                  {0.2f, 0.03f, 0.03f},
                                                  {0.42f, 0.27f, 0.08f}};
    const int label = k.material(plain("label", {0.68f, 0.64f, 0.54f}, 0.7f)),
              cap = k.material(plain("cap", {0.05f, 0.045f, 0.04f}, 0.4f));
    const auto bottle = [&](float x, float y, float z, std::size_t kind) {
        const float h = k.dice.uniform(0.24f, 0.31f), r = k.dice.uniform(0.033f, 0.042f);
        const std::array<Vec2f, 6> p{
            Vec2f{r, 0},          {r, 0.58f * h}, {0.9f * r, 0.65f * h}, {0.36f * r, 0.76f * h}, {0.34f * r, 0.93f * h},
            {0.3f * r, 0.93f * h}};
        k.add(shapes::lathe(p, 22, false), k.material(plain("bottle", kDrinks[kind % 5], 0.08f)), {x, y, z});
        k.rod(cap, {x, y + 0.92f * h, z}, {x, y + h, z}, 0.38f * r, -1, 12);
        k.rod(label, {x, y + 0.16f * h, z}, {x, y + 0.46f * h, z}, 1.015f * r, -1, 22);
    };
    for (int i = 0; i < 4; ++i)
        bottle(-hx + 0.09f + 0.105f * static_cast<float>(i), high + 0.014f,
               -0.45f * hz + 0.05f * static_cast<float>(i % 2), static_cast<std::size_t>(i));
    for (int i = 0; i < 3; ++i)
        bottle(-hx + 0.12f + 0.13f * static_cast<float>(i), low + 0.014f, 0.1f * hz * static_cast<float>(i % 2),
               static_cast<std::size_t>(i + 2));
    const std::array<Vec2f, 3> tumbler{Vec2f{0.03f, 0}, {0.034f, 0.045f}, {0.036f, 0.09f}};
    for (int i = 0; i < 4; ++i)
        k.add(shapes::vessel(tumbler, 0.002f, 20), clear,
              {hx - 0.07f - 0.085f * static_cast<float>(i % 2), high + 0.014f, (i < 2 ? 0.5f : -0.05f) * hz});
    // A bucket of ice below.
    const std::array<Vec2f, 4> bucket{Vec2f{0.06f, 0}, {0.068f, 0.01f}, {0.085f, 0.15f}, {0.09f, 0.16f}};
    k.add(shapes::vessel(bucket, 0.004f, 28), frame, {hx - 0.14f, low + 0.014f, 0});
    k.piece.clearance_front_m = 0.3f;
    k.piece.against_wall = true;
}

// A cage of metal with panes about a candle; a ring to carry it by.
void lantern(Kit& k) {
    const float size = k.request.size_factor, half = 0.085f * size,
                high = (k.request.size_m.y > 0 ? k.request.size_m.y : 0.36f * size), body = 0.66f * high;
    k.sized = true;
    const int metal = k.main(is_one_of(k.style.name, {"scandinavian", "mediterranean"})
                                 ? plain("lantern paint", {0.7f, 0.69f, 0.66f}, 0.5f)
                                 : k.style.metal),
              pane = k.material(glass());
    k.board(metal, {0, 0, 0}, {2.25f * half, 0.016f, 2.25f * half}, 0.003f);
    k.board(metal, {0, 0.016f, 0}, {2 * half, 0.012f, 2 * half}, 0.003f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.board(metal, {sx * 0.93f * half, 0.02f, sz * 0.93f * half}, {0.012f, body - 0.02f, 0.012f}, 0.002f);
    for (const float s : {-1.f, 1.f}) {
        k.board(pane, {0, 0.028f, s * 0.93f * half}, {1.8f * half, body - 0.034f, 0.002f}, 0.0005f);
        k.board(pane, {s * 0.93f * half, 0.028f, 0}, {0.002f, body - 0.034f, 1.8f * half}, 0.0005f);
        k.board(metal, {0, 0.5f * body, s * 0.95f * half}, {1.8f * half, 0.006f, 0.006f}, 0.001f);
        k.board(metal, {s * 0.95f * half, 0.5f * body, 0}, {0.006f, 0.006f, 1.8f * half}, 0.001f);
    }
    k.board(metal, {0, body - 0.008f, 0}, {2.2f * half, 0.014f, 2.2f * half}, 0.003f);
    // A roof of four sides, a small chimney, the ring.
    std::vector<Vec2f> roof{{1.45f * half, body},
                            {0.55f * half, body + 0.17f * high},
                            {0.42f * half, body + 0.17f * high},
                            {0.42f * half, body + 0.21f * high},
                            {0.5f * half, body + 0.22f * high},
                            {0.02f * half, body + 0.25f * high}};
    Mesh cap = shapes::lathe(roof, 4);
    shapes::turn(cap, {0, 1, 0}, 45);
    k.add(std::move(cap), metal);
    Mesh loop = shapes::ring(0.045f * high / 0.36f, 0.006f, 24);
    shapes::turn(loop, {1, 0, 0}, 90);
    k.add(std::move(loop), metal, {0, high - 0.05f * high / 0.36f, 0});
    PieceRequest flame_of;
    flame_of.klass = "candle", flame_of.style = &k.style, flame_of.seed = k.dice.next_u64(),
    flame_of.size_m = {0.06f, 0, 0};
    k.merge(make_piece(flame_of), {0, 0.028f, 0});
    k.piece.mount = Mount::surface;
}

// Small mirrors on a ball, on a rod from the ceiling.
void disco_ball(Kit& k) {
    const float r = 0.19f * k.request.size_factor,
                drop = k.request.size_m.y > 0.4f ? k.request.size_m.y : 0.75f * k.request.size_factor;
    k.sized = true;
    Material silvered = plain("mirror tiles", {0.82f, 0.83f, 0.85f}, 0.05f);
    silvered.mirror = 0.92f;
    const int mirror = k.main(silvered), metal = k.material(steel()),
              joint = k.material(plain("grout", {0.12f, 0.12f, 0.13f}, 0.6f));
    const Vec3f center{0, -drop + r, 0};
    k.add(shapes::ball(center, {0.985f * r, 0.985f * r, 0.985f * r}, 32), joint);
    k.rod(metal, center + Vec3f{0, 0.97f * r, 0}, center + Vec3f{0, r + 0.03f, 0}, 0.02f, -1, 16);
    k.rod(metal, center + Vec3f{0, r, 0}, {0, -0.02f, 0}, 0.004f, -1, 8);
    k.add(shapes::prism(shapes::circle(0.045f, 24), -0.03f, 0.f, 0.004f), metal);
    // Flat tiles in rings, each turned a hair off the ball's own slope as tiles are.
    Mesh tiles;
    constexpr int kRows = 26;
    const float tile = kPi * r / kRows;
    for (int row = 0; row < kRows; ++row) {
        const float lat = kPi * ((static_cast<float>(row) + 0.5f) / kRows - 0.5f);
        const int count = std::max(3, static_cast<int>(std::round(kTau * r * std::cos(lat) / tile)));
        for (int i = 0; i < count; ++i) {
            const float lon = kTau * (static_cast<float>(i) + 0.5f * static_cast<float>(row % 2)) /
                              static_cast<float>(count);
            const Vec3f n{std::cos(lat) * std::cos(lon), std::sin(lat), std::cos(lat) * std::sin(lon)},
                east{-std::sin(lon), 0, std::cos(lon)}, north = cross(east, n);
            const Vec3f up = dot(north, Vec3f{0, 1, 0}) < 0 ? -north : north;
            const float wide = 0.46f * std::min(tile, kTau * r * std::cos(lat) / static_cast<float>(count)),
                        high = 0.46f * tile;
            const Vec3f lean = normalize(n + east * k.dice.uniform(-0.025f, 0.025f) +
                                         up * k.dice.uniform(-0.025f, 0.025f));
            const auto first = static_cast<std::uint32_t>(tiles.positions.size());
            for (const Vec2f c : {Vec2f{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
                const Vec3f p = n * r + east * (c.x * wide) + up * (c.y * high);
                tiles.positions.push_back(center + p - n * dot(p - n * r, lean));
                tiles.normals.push_back(lean);
            }
            const bool turned = dot(cross(east, up), n) < 0;
            tiles.triangles.insert(tiles.triangles.end(),
                                   {first, first + (turned ? 2u : 1u), first + (turned ? 1u : 2u), first,
                                    first + (turned ? 3u : 2u), first + (turned ? 2u : 3u)});
        }
    }
    shapes::lay_grain(tiles);
    k.add(std::move(tiles), mirror);
    k.piece.mount = Mount::ceiling;
}

constexpr Entry kExtras[] = {{"grandfather_clock", grandfather_clock},
                             {"hanging_plant", hanging_plant},
                             {"cactus", cactus},
                             {"play_tent", play_tent},
                             {"fish_bowl", fish_bowl},
                             {"bar_cart", bar_cart},
                             {"lantern", lantern},
                             {"disco_ball", disco_ball}};

}  // namespace

std::span<const Entry> extras() { return kExtras; }

}  // namespace fastscene::furniture
