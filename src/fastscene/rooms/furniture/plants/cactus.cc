// Cactus.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/plants/foliage.h"

namespace fastscene::furniture {
namespace {

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

}  // namespace

// In a clay pot: a column with arms, a ball with a flower, paddles. A large one stands on the floor.
void build_cactus(Kit& k) {
    const bool tall = k.request.size_factor > 1.05f || k.request.size_m.y > 0.7f || k.request.pattern == "tall";
    const float high = k.request.size_m.y > 0 ? k.request.size_m.y : tall ? 1.35f : 0.28f * k.request.size_factor;
    k.sized = true;
    Material skin = plain("cactus", {0.09f, 0.19f, 0.085f}, 0.7f);
    const int green = k.main(skin), spine = k.material(plain("spines", {0.66f, 0.6f, 0.42f}, 0.7f)),
              clay = k.material(k.style.of(k.style.made_of.cactus_pot)),
              soil = k.material(plain("gravel", {0.3f, 0.25f, 0.19f}, 0.95f));
    const float pot_high = tall ? 0.26f * high : 0.32f * high, r = tall ? 0.155f : 0.27f * high;
    const std::array<Vec2f, 6> p{Vec2f{0.68f * r, 0},           {0.7f * r, 0.01f * high}, {0.92f * r, 0.76f * pot_high},
                                 {1.04f * r, 0.78f * pot_high}, {1.06f * r, pot_high},    {1.05f * r, pot_high}};
    k.add(shapes::vessel(std::span(p).first(5), 0.06f * r, 32), clay);
    k.add(shapes::prism(shapes::circle(0.88f * r, 24), 0.6f * pot_high, 0.87f * pot_high), soil);
    const float y = 0.85f * pot_high, rise = high - y;
    Mesh spines;
    const int kind = tall ? 0 : k.rng.index(3);
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

}  // namespace fastscene::furniture
