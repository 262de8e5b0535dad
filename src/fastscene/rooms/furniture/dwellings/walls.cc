// What makes walls of a box those of another building: rounded corners, lattice, windows onto water and stars.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// Fills a corner whose walls are at +x and -z: a quarter of a hollow cylinder, on which the two walls end smoothly.
void hollow_corner(Kit& k, Vec3f s, int material, float rough, std::uint32_t seed) {
    const float r = std::min(s.x, s.z);
    const int across = rough > 0 ? 26 : 14, up = rough > 0 ? 28 : 1;
    Mesh m = shapes::sheet(across, up, [&](float u, float v) {
        const float a = 0.5f * kPi * u, even = std::min(1.f, 5.f * std::min(u, 1 - u));
        const Vec3f p{-s.x / 2 + r * std::cos(a), s.y * (1 - v), s.z / 2 - r * std::sin(a)};
        const float out = rough * even * std::clamp(0.5f + 0.8f * shapes::wobble(p * 1.6f, seed), 0.f, 1.f);
        return p + Vec3f{std::cos(a), 0, -std::sin(a)} * out * 0.7f;
    });
    for (std::size_t i = 0; i < m.coords.size(); ++i) {
        const Vec3f p = m.positions[i];
        m.coords[i] = {std::atan2(s.z / 2 - p.z, p.x + s.x / 2) * r, p.y, 0};
    }
    k.add(std::move(m), material);
    // Its outline on the floor, behind the face.
    k.board(material, {s.x / 2 - 0.005f, 0, 0}, {0.01f, s.y, s.z}, 0.001f);
    k.board(material, {0, 0, -s.z / 2 + 0.005f}, {s.x, s.y, 0.01f}, 0.001f);
}

// Sums of finer and fainter wobbles, about 0 to 1: clouds, mist, the face of a planet.
float clouds(Vec3f p, std::uint32_t seed, int octaves = 5) {
    float sum = 0, weight = 0.5f;
    for (int i = 0; i < octaves; ++i, p = p * 2.1f, weight *= 0.55f)
        sum += weight * shapes::wobble(p, seed + static_cast<std::uint32_t>(i));
    return std::clamp(0.5f + 0.62f * sum, 0.f, 1.f);
}

// A sky of mist in two colors with dark lanes through it, faint stars, and with `planet` a planet, lit from one side.
ImageColor space_picture(Kit& k, Vec2f half, bool planet) {
    constexpr int kHigh = 288;
    const int wide = std::min(1024, static_cast<int>(static_cast<float>(kHigh) * half.x / half.y));
    ImageColor out(wide, kHigh);
    const std::uint32_t seed = k.seed();
    const float slope = k.rng.uniform(-0.5f, 0.5f), off = k.rng.uniform(-0.25f, 0.25f);
    const float r = 0.52f, px = 0.42f * half.x / half.y, py = 0.05f;  // in half heights, from the middle
    for (int y = 0; y < kHigh; ++y)
        for (int x = 0; x < wide; ++x) {
            const float v = 1 - 2 * (static_cast<float>(y) + 0.5f) / kHigh,
                        u = (2 * (static_cast<float>(x) + 0.5f) / static_cast<float>(wide) - 1) * half.x / half.y;
            const Vec3f at{0.9f * u, 0.9f * v, 0.37f};
            const float warp = clouds(at * 1.3f + Vec3f{5, 1, 2}, seed + 40, 4),
                        band = std::exp(-2.2f * std::pow(v - slope * u - off + 0.9f * (warp - 0.5f), 2.f)),
                        mist = std::pow(clouds(at * 1.6f + Vec3f{warp, 0, 0}, seed), 2.2f) * band,
                        lanes = std::pow(clouds(at * 2.4f + Vec3f{0, warp, 3}, seed + 20), 2.f),
                        warm = clouds(at * 0.9f + Vec3f{7, 0, 0}, seed + 60, 3);
            Vec3f c = Vec3f{0.0025f, 0.0035f, 0.008f} + lerp(Vec3f{0.05f, 0.12f, 0.3f}, Vec3f{0.34f, 0.09f, 0.16f},
                                                             std::clamp(2.2f * warm - 0.6f, 0.f, 1.f)) *
                                                            (1.5f * mist) * (1 - 0.75f * lanes);
            c += Vec3f{0.4f, 0.36f, 0.32f} * (0.55f * mist * mist);
            if (k.rng.chance(0.012f)) c += Vec3f{0.3f, 0.32f, 0.36f} * std::pow(k.rng.uniform(), 2.f);
            if (const float dx = (u - px) / r, dy = (v - py) / r, d = std::hypot(dx, dy); planet && d < 1.06f) {
                const Vec3f n{dx, dy, std::sqrt(std::max(0.f, 1 - d * d))};
                const float sun = std::max(0.f, dot(n, normalize(Vec3f{0.75f, 0.35f, 0.45f}))),
                            swirl = clouds(
                                {1.2f * n.x + 2.f, 4.5f * n.y + 1.2f * clouds(n * 2.f, seed + 80, 3), 1.2f * n.z},
                                seed + 90);
                const Vec3f face = lerp(Vec3f{0.12f, 0.2f, 0.34f}, Vec3f{0.62f, 0.54f, 0.42f},
                                        std::clamp(2.6f * swirl - 0.8f, 0.f, 1.f));
                const float cover = std::clamp((1 - d) * 0.52f * kHigh * 0.5f + 0.5f, 0.f, 1.f),
                            halo = d > 1 ? (1.06f - d) / 0.06f : 0.f;
                const Vec3f air = Vec3f{0.16f, 0.32f, 0.6f} * (std::pow(d, 6.f) * std::sqrt(sun));
                c = lerp(c, face * (0.9f * sun) + air, cover);
                if (d > 1) c += Vec3f{0.1f, 0.22f, 0.45f} * (0.5f * halo * halo * std::max(0.f, 0.3f + 0.8f * dx));
            }
            out.at(x, y) = c;
        }
    return out;
}

// Stars and, with `planet`, a planet: within |x| < half.x, y from y0 to y0 + 2 half.y, at the depth z.
void starfield(Kit& k, Vec2f half, float y0, float z, int stars, bool planet) {
    Material star_light = lit("star", {4.5f, 4.8f, 5.5f});
    star_light.color_a = star_light.color_b = star_light.color_c = {}, star_light.specular = 0,
    star_light.roughness = 1;
    const int star = k.material(star_light);
    Material space = picture_material("space", space_picture(k, half, planet), 2 * half.x, 1);
    space.specular = 0;  // no lamp of the room is mirrored in it
    k.add(printed_face({{0, 0}, {1, 1}}, {2 * half.x, 2 * half.y}), k.material(space), {-half.x, y0, z});
    const float r = 0.54f * half.y;
    for (int i = 0; i < stars; ++i) {
        const float wide = k.rng.chance(0.06f) ? 0.008f : k.rng.uniform(0.002f, 0.0045f);
        const Vec2f at{k.rng.uniform(-0.96f, 0.96f) * half.x, half.y * k.rng.uniform(-0.95f, 0.95f)};
        if (planet && std::hypot(at.x - 0.42f * half.x, at.y - 0.05f * half.y) < r) continue;
        block(k, star, {at.x, y0 + half.y + at.y, z + 0.001f}, {wide, wide, 0.002f});
    }
}

}  // namespace

// Laths that cross, of the wall of a yurt; felt is behind them.
void build_lattice_wall(Kit& k) {
    const Vec3f s = k.wanted({1.4f, 1.6f, 0.03f});
    const int lath = k.main(plain("lath", {0.44f, 0.13f, 0.04f}, 0.5f)),
              knot = color(k, "knot", {0.6f, 0.5f, 0.32f}, 0.8f);
    // Panels side by side, with a joint between them, look like one.
    constexpr float kUsually = 0.19f, kWide = 0.028f, kJoint = 0.024f;
    const float every = (s.x + kJoint) / std::max(1.f, std::round((s.x + kJoint) / kUsually)), hx = s.x / 2 - 0.006f;
    // Lines x + y = c and x - y = c, cut off at the panel's edges.
    for (const float way : {-1.f, 1.f})
        for (float c = -(s.x + kJoint) / 2 - every * std::ceil(s.y / every); c < hx + s.y; c += every) {
            float y0 = 0.02f, y1 = s.y - 0.02f;
            const auto x = [&](float y) { return c + way * (y - s.y / 2); };
            const float at_left = s.y / 2 + way * (-hx - c), at_right = s.y / 2 + way * (hx - c);
            y0 = std::max(y0, std::min(at_left, at_right)), y1 = std::min(y1, std::max(at_left, at_right));
            if (y1 - y0 < 0.08f) continue;
            const float z = way > 0 ? 0.023f : 0.012f;
            slat(k, lath, {x(y0), y0, z}, {x(y1), y1, z}, kWide, 0.01f);
        }
    for (const float y : {0.012f, s.y - 0.012f}) k.rod(knot, {-hx, y, 0.018f}, {hx, y, 0.018f}, 0.01f, -1, 6);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.04f;
}

// Rock fills the corner of a cave.
void build_rock_corner(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 2.2f, 1.2f});
    hollow_corner(k, s, k.main(k.style.wall), 0.22f, k.seed());
}

// A round window of a submarine, the green of the sea behind thick glass, fish before it.
void build_ship_porthole(Kit& k) {
    const Vec3f s = k.wanted({0.62f, 0.62f, 0.09f});
    const float r = 0.5f * std::min(s.x, s.y);
    const int rim = k.main(*material_named("brass")), bolt = k.material(steel()), pane = k.material(glass());
    const auto disc = [&](float radius, float z0, float z1, int material, Vec2f at = {}) {
        Mesh m = shapes::prism(shapes::circle(radius, 36), z0, z1, 0.002f);
        shapes::turn(m, {1, 0, 0}, 90);
        k.add(std::move(m), material, {at.x, r + at.y, 0});
    };
    disc(r, 0, 0.02f, rim);
    for (int i = 0; i < 5; ++i)  // lighter towards the middle
        disc((0.78f - 0.13f * static_cast<float>(i)) * r, 0.02f + 0.002f * static_cast<float>(i),
             0.022f + 0.002f * static_cast<float>(i),
             k.material(lit("sea", Vec3f{0.02f, 0.3f, 0.34f} * (0.45f + 0.3f * static_cast<float>(i)))),
             {0, 0.02f * static_cast<float>(i)});
    const int fish = color(k, "fish", {0.02f, 0.05f, 0.06f}, 0.6f);
    for (int i = 0; i < 3; ++i) {
        const Vec3f at{k.rng.uniform(-0.3f, 0.3f) * r, r * (1 + k.rng.uniform(-0.35f, 0.3f)), 0.036f};
        k.add(shapes::ball(at, {0.16f * r, 0.06f * r, 0.004f}, 10), fish);
        k.add(shapes::ball(at + Vec3f{-0.17f * r, 0, 0}, {0.05f * r, 0.07f * r, 0.003f}, 8), fish);
    }
    Mesh ring = shapes::ring(0.86f * r, 0.13f * r, 40), inner = shapes::ring(0.76f * r, 0.06f * r, 40);
    for (Mesh* m : {&ring, &inner}) shapes::turn(*m, {1, 0, 0}, 90);
    k.add(std::move(ring), rim, {0, r, 0.04f}), k.add(std::move(inner), rim, {0, r, 0.07f});
    disc(0.76f * r, 0.05f, 0.054f, pane);
    for (int i = 0; i < 12; ++i) {
        const float a = kTau * static_cast<float>(i) / 12;
        k.add(shapes::ball({0.9f * r * std::cos(a), r + 0.9f * r * std::sin(a), 0.075f}, {0.018f, 0.018f, 0.012f}, 8),
              bolt);
    }
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.15f;
}

// A frame of boards around a window, `rim` wide, with a line of light along its upper and lower edge.
int window_frame(Kit& k, Vec3f s, const char* name, Vec3f color, float rim) {
    const int frame = k.main(plain(name, color, 0.35f)), edge = k.material(lit("edge light", {0.3f, 1.1f, 3.2f}));
    for (const float side : {-1.f, 1.f}) {
        k.board(frame, {side * (s.x / 2 - rim / 2), 0, s.z / 2}, {rim, s.y, s.z}, 0.027f);
        k.board(frame, {0, side > 0 ? s.y - rim : 0, s.z / 2}, {s.x, rim, s.z}, 0.027f);
        k.board(edge, {0, side > 0 ? s.y - rim - 0.012f : rim, s.z - 0.035f}, {s.x - 2 * rim, 0.013f, 0.013f}, 0.002f);
    }
    return frame;
}

// A window onto the stars.
void build_space_window(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 0.9f, 0.12f});
    constexpr float kRim = 0.09f;
    window_frame(k, s, "window frame", {0.1f, 0.105f, 0.115f}, kRim);
    starfield(k, {s.x / 2 - kRim, s.y / 2 - kRim}, kRim, 0.012f, 160, k.rng.chance(0.5f));
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.1f;
}

// The window at the front of a bridge: stars and a planet, across the whole wall.
void build_view_screen(Kit& k) {
    const Vec3f s = k.wanted({4.4f, 1.5f, 0.16f});
    constexpr float kRim = 0.11f;
    const int frame = window_frame(k, s, "screen frame", {0.07f, 0.075f, 0.085f}, kRim);
    for (const float side : {-1.f, 1.f})  // mullions, leaning as those of a cockpit do
        slat(k, frame, {side * 0.27f * s.x, 0.05f, s.z / 2}, {side * 0.19f * s.x, s.y - 0.05f, s.z / 2}, 0.07f, 0.1f);
    starfield(k, {s.x / 2 - kRim, s.y / 2 - kRim}, kRim, 0.012f, 420, true);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.95f;
}

// A hatch between compartments: rounded, with a wheel and dogs.
void build_hatch_door(Kit& k) {
    const Vec3f s = k.wanted({0.95f, 1.75f, 0.14f});
    const int door = k.main(plain("hatch paint", {0.34f, 0.37f, 0.33f}, 0.4f)),
              dark = color(k, "hatch rim", {0.16f, 0.18f, 0.165f}, 0.45f),
              wheel = color(k, "wheel", {0.5f, 0.05f, 0.03f}, 0.35f), metal = k.material(steel());
    const auto plate = [&](float w, float h, float z0, float z1, float r, int material) {
        Mesh m = shapes::prism(shapes::rounded_rectangle(w, h, r, 10), z0, z1, 0.006f);
        shapes::turn(m, {1, 0, 0}, 90);
        k.add(std::move(m), material, {0, s.y / 2, 0});
    };
    plate(s.x, s.y, 0, 0.05f, 0.36f, dark);
    plate(s.x - 0.2f, s.y - 0.2f, 0.05f, 0.085f, 0.3f, door);
    Mesh ring = shapes::ring(0.16f, 0.03f, 28);
    shapes::turn(ring, {1, 0, 0}, 90);
    k.add(std::move(ring), wheel, {0, s.y / 2, s.z - 0.02f});
    for (int i = 0; i < 3; ++i) {
        const float a = kPi * static_cast<float>(i) / 3;
        const Vec3f out{0.16f * std::cos(a), 0.16f * std::sin(a), 0}, mid{0, s.y / 2, s.z - 0.02f};
        k.rod(wheel, mid - out, mid + out, 0.011f, -1, 8);
    }
    k.rod(metal, {0, s.y / 2, 0.08f}, {0, s.y / 2, s.z - 0.01f}, 0.03f, -1, 12);
    for (const float side : {-1.f, 1.f})
        for (const float y : {0.3f, 0.5f, 0.7f})
            slat(k, metal, {side * (s.x / 2 - 0.22f), y * s.y, 0.1f},
                 {side * (s.x / 2 - 0.05f), (y + 0.02f) * s.y, 0.08f}, 0.03f, 0.03f);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 0.1f;
}

}  // namespace fastscene::furniture
