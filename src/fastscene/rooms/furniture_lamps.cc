// Lamps: what shines has an emissive bulb inside and a glowing shade.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture_forms.h"

namespace fastscene::furniture {
namespace {

// A shade of the style's family whose lower rim is at y, radius r; the light of the bulb inside. `paper`: what a paper
// shade is made of.
void lamp_head(Kit& k, float y, float r, bool hanging, LampFamily family, int paper = -1) {
    const Vec3f light = k.style.lamp_light;
    const auto bulb = [&](float by, float br) {
        k.add(shapes::ball({0, by, 0}, {br, br, br}, 14), k.material(glow("bulb", light * 1.6f)));
    };
    Material cloth = plain("lamp shade", {0.75f, 0.68f, 0.55f}, 0.9f);
    cloth.transmission = 0.55f;
    cloth.emission = light * 0.16f;
    switch (family) {
        case LampFamily::drum:
        case LampFamily::candelabra: {
            const float top = family == LampFamily::drum ? 0.86f : 0.6f;
            const std::array<Vec2f, 2> p{Vec2f{r, y}, {top * r, y + 1.25f * r}};
            k.add(shapes::shade(p, 36), k.material(cloth));
            bulb(y + 0.55f * r, 0.04f);
            const int metal = k.material(k.style.metal);
            k.rod(metal, {-top * r, y + 1.2f * r, 0}, {top * r, y + 1.2f * r, 0}, 0.003f, -1, 6);
            k.rod(metal, {0, y - (hanging ? -0.3f : 0.05f) * r, 0}, {0, y + 1.25f * r, 0}, 0.006f, -1, 8);
            break;
        }
        case LampFamily::globe: {
            Material milk = plain("opal glass", {0.8f, 0.78f, 0.74f}, 0.15f);
            milk.emission = light * 0.55f;
            k.add(shapes::ball({0, y + 0.8f * r, 0}, {0.82f * r, 0.82f * r, 0.82f * r}, 28), k.material(milk));
            break;
        }
        case LampFamily::paper: {
            std::array<Vec2f, 25> p{};
            for (std::size_t i = 0; i < p.size(); ++i) {
                const float t = 0.12f + 2.9f * static_cast<float>(i) / 24.f;
                p[i] = {1.1f * r * std::sin(t) * (i % 2 == 0 ? 1.f : 0.975f), y + 0.85f * r - 0.85f * r * std::cos(t)};
            }
            cloth.name = "rice paper";
            cloth.emission = light * 0.3f;
            k.add(shapes::shade(p, 32), paper >= 0 ? paper : k.material(cloth));
            bulb(y + 0.85f * r, 0.04f);
            break;
        }
        case LampFamily::cage: {
            const int metal = k.material(k.style.metal);
            bulb(y + 0.5f * r, 0.045f);
            for (int i = 0; i < 6; ++i) {
                const float a = 1.0472f * static_cast<float>(i), c = std::cos(a), s = std::sin(a);
                const std::array<Vec3f, 4> wire{Vec3f{0.55f * r * c, y, 0.55f * r * s},
                                                {0.85f * r * c, y + 0.45f * r, 0.85f * r * s},
                                                {0.55f * r * c, y + 0.95f * r, 0.55f * r * s},
                                                {0.15f * r * c, y + 1.15f * r, 0.15f * r * s}};
                k.add(shapes::tube(wire, 0.003f, 6), metal);
            }
            for (const Vec2f ry : {Vec2f{0.55f, 0.f}, {0.85f, 0.45f}})
                k.add(shapes::ring(ry.x * r, 0.006f, 24), metal, {0, y + ry.y * r, 0});
            k.rod(metal, {0, y + 0.7f * r, 0}, {0, y + 1.2f * r, 0}, 0.025f, 0.02f);
            break;
        }
        case LampFamily::dome: {
            const std::array<Vec2f, 7> p{Vec2f{r, y},
                                         {0.97f * r, y + 0.2f * r},
                                         {0.85f * r, y + 0.45f * r},
                                         {0.62f * r, y + 0.68f * r},
                                         {0.34f * r, y + 0.82f * r},
                                         {0.1f * r, y + 0.88f * r},
                                         {0.05f * r, y + 1.f * r}};
            k.add(shapes::shade(p, 36), k.piece.main_material);
            bulb(y + 0.35f * r, 0.05f);
            break;
        }
    }
}
void lamp_head(Kit& k, float y, float r, bool hanging) { lamp_head(k, y, r, hanging, k.style.lamp); }
int lamp_metal(Kit& k) { return k.main(k.style.metal); }

// "brass pendant lights", "a black pendant": the shade is, not the cord alone; of glass it is a globe, of paper a
// lantern.
LampFamily shade_asked(const Kit& k) {
    if (k.style.lamp == LampFamily::cage) return k.style.lamp;
    const auto asked = k.request.material.empty() ? std::nullopt : material_named(k.request.material);
    if (k.request.material == "glass") return LampFamily::globe;
    if (asked ? asked->metal > 0.5f : k.request.color || !k.request.color_name.empty()) return LampFamily::dome;
    return k.style.lamp;
}

void foot_disc(Kit& k, int m, float r) {
    const std::array<Vec2f, 5> p{Vec2f{r, 0}, {r, 0.014f}, {r - 0.008f, 0.022f}, {0.02f, 0.03f}, {0.012f, 0.05f}};
    k.add(shapes::lathe(p, 32), m);
}
// A bow of steel from a heavy foot.
void arc_lamp(Kit& k) {
    const int metal = lamp_metal(k), stone = k.material(*material_named("marble"));
    k.board(stone, {-0.42f, 0, 0}, {0.26f, 0.06f, 0.26f}, 0.01f);
    std::vector<Vec3f> bow;
    for (int i = 0; i <= 16; ++i) {
        const float t = static_cast<float>(i) / 16.f;
        bow.push_back({-0.42f + 0.84f * (1.f - std::cos(1.5708f * t)),
                       0.06f + 1.72f * std::sin(1.5708f * std::min(1.f, 1.02f * t)), 0});
    }
    k.add(shapes::tube(bow, 0.011f, 10), metal);
    const Vec3f tip = bow.back();
    k.rod(metal, tip, tip - Vec3f{0, 0.1f, 0}, 0.008f);
    const std::array<Vec2f, 5> p{
        Vec2f{0.17f, -0.26f}, {0.165f, -0.2f}, {0.13f, -0.14f}, {0.07f, -0.1f}, {0.02f, -0.09f}};
    k.add(shapes::shade(p, 32), metal, tip);
    k.add(shapes::ball(tip - Vec3f{0, 0.2f, 0}, {0.05f, 0.05f, 0.05f}),
          k.material(glow("bulb", k.style.lamp_light * 1.4f)));
}
void floor_lamp(Kit& k) {
    if (form_for(k, {{"modern", 1, 0}, {"mid-century", 0, 1}, {"art deco", 0, 1}, {"industrial", 0, 1}}, 0) == 1)
        return arc_lamp(k);
    const int metal = lamp_metal(k);
    if (k.style.legs == LegType::tapered || k.style.legs == LegType::splayed) {
        const int wood = k.material(k.style.wood);
        for (int i = 0; i < 3; ++i) {
            const float a = 2.0944f * static_cast<float>(i) + 0.3f;
            k.rod(wood, {0.26f * std::cos(a), 0, 0.26f * std::sin(a)},
                  {0.02f * std::cos(a), 1.26f, 0.02f * std::sin(a)}, 0.011f, 0.016f);
        }
        k.rod(metal, {0, 1.22f, 0}, {0, 1.36f, 0}, 0.02f);
    } else {
        foot_disc(k, metal, 0.15f);
        k.rod(metal, {0, 0.03f, 0}, {0, 1.35f, 0}, 0.011f);
    }
    lamp_head(k, 1.3f, 0.21f, false);
    if (k.style.lamp == LampFamily::dome) k.rod(metal, {0, 1.3f, 0}, {0, 1.5f, 0}, 0.011f);
}
void table_lamp(Kit& k) {
    const int kind = k.dice.index(3);
    const int body = k.main(kind == 0 ? k.style.metal : plain("glazed ceramic", k.accent(), 0.2f));
    if (kind == 0) {
        foot_disc(k, body, 0.075f);
        k.rod(body, {0, 0.02f, 0}, {0, 0.3f, 0}, 0.009f);
    } else {
        const float b = kind == 1 ? 0.085f : 0.06f;
        const std::array<Vec2f, 8> p{Vec2f{0.05f, 0},   {0.06f, 0.01f},   {b, 0.07f},     {b * 1.05f, 0.11f},
                                     {b * 0.7f, 0.19f}, {0.022f, 0.235f}, {0.02f, 0.26f}, {0.012f, 0.3f}};
        k.add(shapes::lathe(shapes::curve(p, 3), 28, true), body);
    }
    lamp_head(k, 0.27f, 0.135f, false);
    k.piece.mount = Mount::surface;
}
void pendant_lamp(Kit& k) {
    const int metal = lamp_metal(k);
    const float drop = k.request.size_m.y > 0.4f ? k.request.size_m.y : 0.95f, r = 0.2f;
    k.sized = true;
    k.add(shapes::prism(shapes::circle(0.05f, 24), -0.025f, 0.f), metal);
    lamp_head(k, -drop, r, true, shade_asked(k));
    k.rod(metal, {0, -drop + 0.85f * r, 0}, {0, -0.01f, 0}, 0.004f, -1, 6);
    k.piece.mount = Mount::ceiling;
}
void ceiling_lamp(Kit& k) {
    const int metal = lamp_metal(k);
    // The plate is smaller than the glass: it throws no shadow on the ceiling.
    k.add(shapes::prism(shapes::circle(0.14f, 40), -0.02f, 0.f, 0.004f), metal);
    k.add(shapes::ring(0.203f, 0.007f, 40), metal, {0, -0.036f, 0});
    Material milk = plain("opal glass", {0.8f, 0.78f, 0.74f}, 0.2f);
    milk.emission = k.style.lamp_light * 0.7f;
    const std::array<Vec2f, 6> p{Vec2f{0, -0.1f},   {0.1f, -0.095f}, {0.16f, -0.08f},
                                 {0.192f, -0.055f}, {0.2f, -0.036f}, {0.19f, -0.019f}};
    k.add(shapes::lathe(p, 40, true), k.material(milk));
    k.piece.mount = Mount::ceiling;
}
// Cut glass: it takes the light of what is around it, and throws some of its own bulbs' back.
Material cut_glass(const Kit& k) {
    Material m = plain("cut crystal", {0.8f, 0.84f, 0.88f}, 0.06f);
    m.metal = 0.8f;
    m.emission = k.style.lamp_light * 0.035f;
    return m;
}

// A frame of metal, all hung with cut glass: strings of beads from the crown to the arms, drops below them, a basket
// that ends in a ball.
void crystal_chandelier(Kit& k) {
    const int crystal = k.piece.main_material = k.material(cut_glass(k)),
              metal = k.material(k.style.metal.metal > 0.5f ? k.style.metal : *material_named("chrome")),
              clear = k.material(glass()), sleeve = k.material(plain("candle sleeve", {0.75f, 0.72f, 0.64f}, 0.6f)),
              flame = k.material(glow("bulb", k.style.lamp_light * 1.6f));
    k.add(shapes::prism(shapes::circle(0.065f, 28), -0.03f, 0.f), metal);
    k.rod(metal, {0, -0.78f, 0}, {0, -0.02f, 0}, 0.006f);
    Mesh beads, drops;
    const auto bead = [&](Vec3f at, float r) { shapes::append(beads, shapes::ball(at, {r, r, r}, 7)); };
    // Faceted, six sides, its point down.
    const auto drop = [&](Vec3f at, float high) {
        const float r = 0.26f * high;
        const std::array<Vec2f, 5> p{
            Vec2f{0.f, -high}, {0.7f * r, -0.72f * high}, {r, -0.5f * high}, {0.35f * r, -0.12f * high}, {0.f, 0.f}};
        Mesh m = shapes::lathe(p, 6, false);
        shapes::append(drops, shapes::move(m, at));
    };
    const auto string = [&](Vec3f a, Vec3f b, float sag, int count) {
        for (int i = 0; i <= count; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(count);
            bead(lerp(a, b, t) - Vec3f{0, sag * 4 * t * (1 - t), 0}, 0.0085f);
        }
    };
    for (const float y : {-0.2f, -0.3f, -0.44f, -0.62f})
        k.add(shapes::ball({0, y, 0}, {0.032f, 0.04f, 0.032f}, 12), clear);
    const auto ring = [&](float y, float r) { k.add(shapes::ring(r, 0.005f, 36), metal, {0, y, 0}); };
    ring(-0.24f, 0.11f), ring(-0.7f, 0.2f), ring(-0.79f, 0.11f);
    constexpr int kArms = 8;
    const auto at = [](int i, int of, float r, float y) {
        return Vec3f{r * std::cos(kTau * static_cast<float>(i) / static_cast<float>(of)), y,
                     r * std::sin(kTau * static_cast<float>(i) / static_cast<float>(of))};
    };
    for (int i = 0; i < kArms; ++i) {
        std::vector<Vec3f> arm;
        for (int j = 0; j <= 12; ++j) {
            const float t = static_cast<float>(j) / 12.f;
            arm.push_back(at(i, kArms, 0.02f + 0.38f * t, -0.66f - 0.1f * std::sin(3.4f * t) + 0.1f * t * t));
        }
        k.add(shapes::tube(arm, 0.0065f, 8), metal);
        const Vec3f tip = arm.back();
        const std::array<Vec2f, 4> pan{Vec2f{0.008f, -0.006f}, {0.034f, 0.f}, {0.046f, 0.01f}, {0.04f, 0.01f}};
        k.add(shapes::lathe(pan, 18), clear, tip);
        k.rod(sleeve, tip, tip + Vec3f{0, 0.085f, 0}, 0.011f);
        k.add(shapes::ball(tip + Vec3f{0, 0.112f, 0}, {0.013f, 0.03f, 0.013f}, 10), flame);
        for (int j = 0; j < 5; ++j)
            drop(tip + Vec3f{0.042f * std::cos(1.2566f * static_cast<float>(j)), 0.004f,
                             0.042f * std::sin(1.2566f * static_cast<float>(j))},
                 0.055f);
        string(at(i, kArms, 0.11f, -0.25f), tip + Vec3f{0, 0.012f, 0}, 0.1f, 22);
        string(tip, at(i + 1, kArms, 0.4f, tip.y), 0.07f, 14);
        drop(lerp(tip, at(i + 1, kArms, 0.4f, tip.y), 0.5f) - Vec3f{0, 0.075f, 0}, 0.07f);
        drop(arm[6] - Vec3f{0, 0.006f, 0}, 0.08f);
    }
    // The crown's fringe and the basket below.
    for (int i = 0; i < 14; ++i) drop(at(i, 14, 0.11f, -0.245f), 0.06f);
    for (int i = 0; i < 18; ++i)
        drop(at(i, 18, 0.2f, -0.705f), 0.075f), string(at(i, 18, 0.2f, -0.7f), at(i, 18, 0.11f, -0.79f), 0.02f, 6);
    for (int i = 0; i < 12; ++i)
        drop(at(i, 12, 0.11f, -0.795f), 0.065f), string(at(i, 12, 0.11f, -0.79f), at(i, 12, 0.02f, -0.86f), 0.015f, 5);
    k.add(shapes::ball({0, -0.9f, 0}, {0.035f, 0.035f, 0.035f}, 14), clear);
    bead({0, -0.945f, 0}, 0.012f);
    k.add(std::move(beads), crystal);
    k.add(std::move(drops), crystal);
    k.piece.mount = Mount::ceiling;
}
void chandelier(Kit& k) {
    if (k.request.material == "glass") return crystal_chandelier(k);
    const int metal = lamp_metal(k), wax = k.material(plain("candle sleeve", {0.75f, 0.72f, 0.64f}, 0.6f)),
              flame = k.material(glow("bulb", k.style.lamp_light * 1.6f));
    k.add(shapes::prism(shapes::circle(0.06f, 24), -0.03f, 0.f), metal);
    k.rod(metal, {0, -0.55f, 0}, {0, -0.02f, 0}, 0.007f);
    const std::array<Vec2f, 9> p{Vec2f{0, -0.9f}, {0.02f, -0.88f}, {0.03f, -0.85f}, {0.015f, -0.81f}, {0.05f, -0.75f},
                                 {0.055f, -0.7f}, {0.02f, -0.63f}, {0.03f, -0.58f}, {0.008f, -0.52f}};
    k.add(shapes::lathe(p, 20, true), metal);
    for (int i = 0; i < 8; ++i) {
        const float a = 0.7854f * static_cast<float>(i), c = std::cos(a), s = std::sin(a);
        std::vector<Vec3f> arm;
        for (int j = 0; j <= 12; ++j) {
            const float t = static_cast<float>(j) / 12.f, r = 0.03f + 0.37f * t;
            arm.push_back({r * c, -0.72f - 0.11f * std::sin(3.4f * t) + 0.08f * t * t, r * s});
        }
        k.add(shapes::tube(arm, 0.007f, 8), metal);
        const Vec3f tip = arm.back();
        k.add(shapes::prism(shapes::circle(0.035f, 16), 0.f, 0.008f), metal, tip);
        k.rod(wax, tip, tip + Vec3f{0, 0.09f, 0}, 0.012f);
        k.add(shapes::ball(tip + Vec3f{0, 0.115f, 0}, {0.014f, 0.03f, 0.014f}, 10), flame);
    }
    k.piece.mount = Mount::ceiling;
}

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
// Sconces: the shade of the style's lamps on an arm; two candles where rooms are grand, a box of paper, a barn lamp.
void wall_lamp(Kit& k) {
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
// A ball of rice paper on a cord.
void paper_lantern(Kit& k) {
    const float drop = k.request.size_m.y > 0.4f ? k.request.size_m.y : 0.8f * k.request.size_factor,
                r = 0.24f * k.request.size_factor;
    k.sized = true;
    Material rice = plain("rice paper", {0.76f, 0.72f, 0.62f}, 0.9f);
    rice.transmission = 0.55f;
    const int paper = k.main(rice), cord = k.material(plain("cord", {0.6f, 0.58f, 0.54f}, 0.8f));
    // Dyed paper glows in its color.
    Material& dyed = k.piece.materials[static_cast<std::size_t>(paper)];
    dyed.emission = k.style.lamp_light * dyed.color_a * (0.3f / std::max(max_component(dyed.color_a), 0.05f));
    k.add(shapes::prism(shapes::circle(0.045f, 24), -0.022f, 0.f), cord);
    lamp_head(k, -drop, r, true, LampFamily::paper, paper);
    k.rod(cord, {0, -drop + 1.6f * r, 0}, {0, -0.01f, 0}, 0.003f, -1, 6);
    k.piece.mount = Mount::ceiling;
}
// Clear bulbs with a glowing thread, each on its own cord: three at different heights from one rose, or one.
void bulb_pendant(Kit& k) {
    const int metal = lamp_metal(k), cord = k.material(plain("textile cord", {0.05f, 0.046f, 0.04f}, 0.9f)),
              thread = k.material(glow("filament", k.style.lamp_light * Vec3f{1.f, 0.82f, 0.55f} * 7.f));
    Material clear = glass();
    clear.color_a = clear.color_b = clear.color_c = {0.82f, 0.74f, 0.6f};
    const int envelope = k.material(clear);
    const float drop = k.request.size_m.y > 0.4f ? k.request.size_m.y : 0.95f * k.request.size_factor;
    k.sized = true;
    const int count = k.request.pattern == "single" ? 1 : 3;
    k.add(shapes::prism(shapes::circle(count > 1 ? 0.09f : 0.05f, 32), -0.025f, 0.f), metal);
    for (int i = 0; i < count; ++i) {
        const float a = 2.0944f * static_cast<float>(i) + 0.4f, out = count > 1 ? 0.14f : 0.f,
                    y = -drop + 0.16f * static_cast<float>(i);
        const Vec3f at{out * std::cos(a), y, out * std::sin(a)}, rose{0.45f * at.x, -0.02f, 0.45f * at.z};
        const std::array<Vec3f, 4> path{rose, rose - Vec3f{0, 0.03f, 0}, {at.x, -0.12f, at.z}, at + Vec3f{0, 0.18f, 0}};
        k.add(shapes::tube(path, 0.0035f, 6), cord);
        k.rod(metal, at + Vec3f{0, 0.125f, 0}, at + Vec3f{0, 0.19f, 0}, 0.021f, 0.016f, 20);
        const std::array<Vec2f, 7> p{Vec2f{0.f, 0.f}, {0.02f, 0.004f},  {0.036f, 0.022f}, {0.042f, 0.05f},
                                     {0.036f, 0.08f}, {0.024f, 0.108f}, {0.016f, 0.13f}};
        k.add(shapes::lathe(shapes::curve(p, 2), 24, true), envelope, at);
        for (int j = 0; j < 5; ++j) {
            const float b = 1.2566f * static_cast<float>(j), r = 0.013f;
            k.rod(thread, at + Vec3f{r * std::cos(b), 0.03f, r * std::sin(b)},
                  at + Vec3f{0.5f * r * std::cos(b + 0.6f), 0.09f, 0.5f * r * std::sin(b + 0.6f)}, 0.0022f, -1, 6);
        }
    }
    k.piece.mount = Mount::ceiling;
}
// A rail under the ceiling with spots that look down to both sides.
void track_light(Kit& k) {
    const Vec3f s = k.wanted({1.4f, 0.2f, 0.2f});
    const int metal = lamp_metal(k), lens = k.material(glow("spot", k.style.lamp_light * 3.2f));
    k.board(metal, {0, -0.03f, 0}, {s.x, 0.03f, 0.035f}, 0.003f);
    const int heads = std::max(2, static_cast<int>(std::lround(s.x / 0.36f)));
    for (int i = 0; i < heads; ++i) {
        const float x = s.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(heads) - 0.5f),
                    side = i % 2 == 0 ? 1.f : -1.f;
        const Vec3f joint{x, -0.075f, 0},
            aim = normalize(Vec3f{0.25f * (static_cast<float>(i % 3) - 1.f), -1.f, 0.55f * side});
        k.rod(metal, {x, -0.03f, 0}, joint, 0.01f);
        k.rod(metal, joint - aim * 0.03f, joint + aim * 0.11f, 0.034f, -1, 24);
        k.rod(lens, joint + aim * 0.1105f, joint + aim * 0.113f, 0.027f, -1, 20);
    }
    k.piece.mount = Mount::ceiling;
}
// Blades about a motor on a short rod, an opal glass below it. Slim blades of three where rooms are sober, five of wood
// elsewhere, leaves of cane in the south.
void ceiling_fan(Kit& k) {
    const bool cane = k.style.lamp == LampFamily::paper || k.style.name == "mediterranean",
               slim = k.style.name == "modern" || k.style.name == "japandi" || k.style.name == "industrial";
    const float reach = 0.62f * k.request.size_factor;
    k.sized = true;
    Material wood = cane && !slim                  ? *material_named("rattan")
                    : k.style.name == "industrial" ? k.style.metal
                                                   : k.style.wood;
    const int blade = k.main(wood), metal = k.material(k.style.metal);
    const float hub = -0.27f;  // the blades' height
    const std::array<Vec2f, 4> rose{Vec2f{0.02f, -0.065f}, {0.045f, -0.055f}, {0.07f, -0.015f}, {0.07f, 0.f}};
    k.add(shapes::lathe(shapes::curve(rose, 3), 32), metal);
    k.rod(metal, {0, hub + 0.06f, 0}, {0, -0.05f, 0}, 0.012f);
    const std::array<Vec2f, 8> motor{Vec2f{0.06f, -0.075f}, {0.085f, -0.07f}, {0.1f, -0.045f}, {0.115f, -0.02f},
                                     {0.115f, 0.02f},       {0.1f, 0.05f},    {0.06f, 0.07f},  {0.02f, 0.085f}};
    k.add(shapes::lathe(shapes::curve(motor, 2), 40), metal, {0, hub, 0});
    const int blades = slim ? 3 : 5;
    for (int i = 0; i < blades; ++i) {
        const float turn = 360.f * static_cast<float>(i) / static_cast<float>(blades) + 11.f, from = slim ? 0.1f : 0.2f;
        // Pitched, rounded at its end; a leaf is widest in its middle.
        Mesh m = shapes::slab(6, 20, 0.007f, [&](float u, float v) {
            const float end = v > 0.9f ? std::sqrt(std::max(0.f, 1.f - 100.f * (v - 0.9f) * (v - 0.9f))) : 1.f;
            const float leaf = cane && !slim ? 0.075f + 0.13f * std::sin(kPi * std::min(1.f, 0.08f + 0.92f * v))
                               : slim        ? std::lerp(0.15f, 0.1f, v)
                                             : std::lerp(0.115f, 0.145f, v);
            const float across = (0.5f - u) * leaf * std::max(end, 0.02f);
            return Vec3f{across, 0.2f * across, from + (reach - from) * v};
        });
        shapes::turn(m, {0, 1, 0}, turn);
        k.add(std::move(m), blade, {0, hub, 0});
        if (slim) continue;
        Mesh bracket = shapes::box({0.035f, 0.01f, 0.16f}, 0.003f);
        shapes::move(bracket, {0, -0.003f, 0.17f});
        shapes::turn(bracket, {0, 1, 0}, turn);
        k.add(std::move(bracket), metal, {0, hub, 0});
    }
    Material milk = plain("opal glass", {0.8f, 0.78f, 0.74f}, 0.2f);
    milk.emission = k.style.lamp_light * 0.75f;
    const float r = slim ? 0.085f : 0.11f, deep = slim ? 0.03f : 0.075f;
    const std::array<Vec2f, 5> bowl{
        Vec2f{0.f, -deep}, {0.55f * r, -0.93f * deep}, {0.88f * r, -0.6f * deep}, {r, -0.15f * deep}, {r, 0.f}};
    k.add(shapes::lathe(shapes::curve(bowl, 3), 40, true), k.material(milk), {0, hub - 0.085f, 0});
    k.add(shapes::ring(r + 0.003f, 0.007f, 40), metal, {0, hub - 0.083f, 0});
    k.piece.mount = Mount::ceiling;
}

constexpr Entry kLamps[] = {{"floor_lamp", floor_lamp},       {"table_lamp", table_lamp},
                            {"pendant_lamp", pendant_lamp},   {"ceiling_lamp", ceiling_lamp},
                            {"chandelier", chandelier},       {"wall_lamp", wall_lamp},
                            {"paper_lantern", paper_lantern}, {"bulb_pendant", bulb_pendant},
                            {"track_light", track_light},     {"ceiling_fan", ceiling_fan}};

}  // namespace

std::span<const Entry> lamps() { return kLamps; }

}  // namespace fastscene::furniture
