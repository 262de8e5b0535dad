// Wall lamp.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/lamps/lamp_parts.h"

namespace fastscene::furniture {
namespace {

// A disc on the wall, its middle at height y.
void wall_rose(Kit& k, int m, float y, float r) {
    Mesh disc = shapes::prism(shapes::circle(r, 32), 0.f, 0.018f, 0.005f);
    shapes::turn(disc, {1, 0, 0}, 90);
    k.add(std::move(disc), m, {0, y, 0});
}

// What `build` adds about the y axis stands at this distance before the wall, and to the side.
template <class Build>
void before_wall(Kit& k, float x, float z, const Build& build) {
    const std::size_t first = k.piece.meshes.size();
    build();
    for (std::size_t i = first; i < k.piece.meshes.size(); ++i) shapes::move(k.piece.meshes[i], {x, 0, z});
}

}  // namespace

// Sconces: the shade of the style's lamps on an arm; two candles where rooms are grand, a box of paper, a barn lamp.
void build_wall_lamp(Kit& k) {
    const int metal = lamp_metal(k);
    const Vec3f light = k.style.lamp_light;
    const auto arm = [&](std::initializer_list<Vec3f> points, float r) {
        // Through the points, smoothly.
        std::vector<Vec3f> path;
        const std::vector<Vec3f> p(points);
        for (std::size_t i = 0; i + 1 < p.size(); ++i)
            for (int j = 0; j < 6; ++j) {
                const float t = static_cast<float>(j) / 6.f;
                const Vec3f a = p[i > 0 ? i - 1 : 0], b = p[i], c = p[i + 1], d = p[std::min(i + 2, p.size() - 1)];
                path.push_back((b * 2.f + (c - a) * t + (a * 2.f - b * 5.f + c * 4.f - d) * (t * t) +
                                (b * 3.f - a - c * 3.f + d) * (t * t * t)) *
                               0.5f);
            }
        path.push_back(p.back());
        k.add(shapes::tube(path, r, 10), metal);
    };
    const auto cup = [&](Vec3f at, float r) {
        const std::array<Vec2f, 5> p{
            Vec2f{0.3f * r, -0.02f}, {0.55f * r, -0.012f}, {r, 0.004f}, {r, 0.01f}, {0.6f * r, 0.012f}};
        k.add(shapes::lathe(p, 24), metal, at);
    };
    switch (k.style.lamp) {
        case LampFamily::drum:
            wall_rose(k, metal, 0.06f, 0.055f);
            arm({{0, 0.06f, 0.01f}, {0, 0.05f, 0.07f}, {0, 0.045f, 0.115f}, {0, 0.07f, 0.13f}, {0, 0.13f, 0.13f}},
                0.007f);
            before_wall(k, 0, 0.13f, [&] { lamp_head(k, 0.12f, 0.095f, false); });
            break;
        case LampFamily::globe:
            wall_rose(k, metal, 0.07f, 0.05f);
            arm({{0, 0.07f, 0.01f}, {0, 0.07f, 0.06f}, {0, 0.075f, 0.105f}, {0, 0.1f, 0.12f}}, 0.008f);
            cup({0, 0.105f, 0.12f}, 0.042f);
            before_wall(k, 0, 0.12f, [&] { lamp_head(k, 0.1f, 0.1f, false); });
            break;
        case LampFamily::paper: {
            // Paper in a frame of wood: light washes the wall above and below.
            const int wood = k.material(k.style.wood);
            Material rice = plain("rice paper", {0.75f, 0.68f, 0.55f}, 0.9f);
            rice.transmission = 0.55f;
            rice.emission = light * 0.3f;
            const int paper = k.material(rice);
            const float w = 0.15f, d = 0.115f, h = 0.3f, bar = 0.014f;
            k.board(metal, {0, 0.08f, 0.005f}, {0.08f, 0.14f, 0.01f}, 0.002f);
            k.board(metal, {0, 0.14f, 0.02f}, {0.03f, 0.02f, 0.03f}, 0.002f);
            const float z0 = 0.03f, z1 = z0 + d;
            for (const float sx : {-1.f, 1.f})
                for (const float z : {z0, z1}) k.board(wood, {sx * 0.5f * w, 0, z}, {bar, h, bar}, 0.002f);
            for (const float y : {0.f, 0.34f * h, 0.67f * h, h - bar}) {
                for (const float z : {z0, z1}) k.board(wood, {0, y, z}, {w, 0.7f * bar, 0.8f * bar}, 0.002f);
                for (const float sx : {-1.f, 1.f})
                    k.board(wood, {sx * 0.5f * w, y, 0.5f * (z0 + z1)}, {0.8f * bar, 0.7f * bar, d}, 0.002f);
            }
            for (const float sx : {-1.f, 1.f})
                k.add(shapes::sheet(
                          1, 1,
                          [&](float u, float v) {
                              return Vec3f{sx * 0.49f * w, h * v, sx > 0 ? std::lerp(z1, z0, u) : std::lerp(z0, z1, u)};
                          }),
                      paper);
            k.add(shapes::sheet(1, 1,
                                [&](float u, float v) {
                                    return Vec3f{w * (u - 0.5f), h * v, z1 - 0.002f};
                                }),
                  paper);
            k.add(shapes::ball({0, 0.5f * h, 0.5f * (z0 + z1)}, {0.022f, 0.05f, 0.022f}, 14),
                  k.material(glow("bulb", light * 1.6f)));
            break;
        }
        case LampFamily::cage:
        case LampFamily::dome: {
            // An arm that bows out from above, and a dome over the bulb.
            const bool barn = k.style.lamp == LampFamily::cage;
            const float out = barn ? 0.2f : 0.16f, r = barn ? 0.115f : 0.085f, high = barn ? 0.2f : 0.15f;
            wall_rose(k, metal, high, 0.05f);
            arm({{0, high, 0.01f},
                 {0, high + 0.01f, 0.05f},
                 {0, high + 0.1f, 0.5f * out},
                 {0, high + 0.07f, 0.95f * out},
                 {0, high - 0.03f, out}},
                0.008f);
            const std::array<Vec2f, 7> p{Vec2f{r, 0},
                                         {0.97f * r, 0.2f * r},
                                         {0.85f * r, 0.45f * r},
                                         {0.62f * r, 0.68f * r},
                                         {0.34f * r, 0.86f * r},
                                         {0.2f * r, 1.f * r},
                                         {0.17f * r, 1.35f * r}};
            k.add(shapes::shade(p, 36), metal, {0, high - 0.03f - 1.3f * r, out});
            k.add(shapes::ball({0, high - 0.03f - 0.95f * r, out}, {0.032f, 0.038f, 0.032f}, 16),
                  k.material(glow("bulb", light * 1.8f)));
            break;
        }
        case LampFamily::candelabra: {
            const int wax = k.material(plain("candle sleeve", {0.75f, 0.72f, 0.64f}, 0.6f)),
                      flame_bulb = k.material(glow("bulb", light * 1.7f));
            // A tall plate with a drop below and a ball above, an arm to each side.
            std::vector<Vec2f> plate;
            for (int i = 0; i < 40; ++i) {
                const float a = kTau * static_cast<float>(i) / 40.f;
                plate.push_back({0.048f * std::cos(a), 0.12f * std::sin(a)});
            }
            Mesh back = shapes::prism(plate, 0.f, 0.016f, 0.006f);
            shapes::turn(back, {1, 0, 0}, 90);
            k.add(std::move(back), metal, {0, 0.15f, 0});
            k.add(shapes::ball({0, 0.285f, 0.012f}, {0.017f, 0.022f, 0.012f}, 14), metal);
            k.add(shapes::ball({0, 0.018f, 0.012f}, {0.014f, 0.022f, 0.011f}, 14), metal);
            k.add(shapes::ball({0, 0.11f, 0.022f}, {0.022f, 0.022f, 0.02f}, 16), metal);
            for (const float sx : {-1.f, 1.f}) {
                arm({{0, 0.11f, 0.022f},
                     {sx * 0.035f, 0.075f, 0.055f},
                     {sx * 0.085f, 0.065f, 0.09f},
                     {sx * 0.115f, 0.105f, 0.1f},
                     {sx * 0.115f, 0.14f, 0.1f}},
                    0.006f);
                const Vec3f tip{sx * 0.115f, 0.145f, 0.1f};
                cup(tip, 0.032f);
                k.rod(wax, tip + Vec3f{0, 0.008f, 0}, tip + Vec3f{0, 0.085f, 0}, 0.011f);
                k.add(shapes::ball(tip + Vec3f{0, 0.112f, 0}, {0.013f, 0.03f, 0.013f}, 12), flame_bulb);
            }
            break;
        }
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.45f;
}

}  // namespace fastscene::furniture
