// Lamps: what shines has an emissive bulb inside and a glowing shade.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture_forms.h"

namespace fastscene::furniture {
namespace {

// A shade of the style's family whose lower rim is at y, radius r; the light of the bulb inside.
void lamp_head(Kit& k, float y, float r, bool hanging) {
    const Vec3f light = k.style.lamp_light;
    const auto bulb = [&](float by, float br) { k.add(shapes::ball({0, by, 0}, {br, br, br}, 14), k.material(glow("bulb", light * 1.6f))); };
    Material cloth = plain("lamp shade", {0.75f, 0.68f, 0.55f}, 0.9f);
    cloth.transmission = 0.55f;
    cloth.emission = light * 0.16f;
    switch (k.style.lamp) {
        case LampFamily::drum:
        case LampFamily::candelabra: {
            const float top = k.style.lamp == LampFamily::drum ? 0.86f : 0.6f;
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
            k.add(shapes::shade(p, 32), k.material(cloth));
            bulb(y + 0.85f * r, 0.04f);
            break;
        }
        case LampFamily::cage: {
            const int metal = k.material(k.style.metal);
            bulb(y + 0.5f * r, 0.045f);
            for (int i = 0; i < 6; ++i) {
                const float a = 1.0472f * static_cast<float>(i), c = std::cos(a), s = std::sin(a);
                const std::array<Vec3f, 4> wire{Vec3f{0.55f * r * c, y, 0.55f * r * s}, {0.85f * r * c, y + 0.45f * r, 0.85f * r * s}, {0.55f * r * c, y + 0.95f * r, 0.55f * r * s}, {0.15f * r * c, y + 1.15f * r, 0.15f * r * s}};
                k.add(shapes::tube(wire, 0.003f, 6), metal);
            }
            for (const Vec2f ry : {Vec2f{0.55f, 0.f}, {0.85f, 0.45f}}) k.add(shapes::ring(ry.x * r, 0.006f, 24), metal, {0, y + ry.y * r, 0});
            k.rod(metal, {0, y + 0.7f * r, 0}, {0, y + 1.2f * r, 0}, 0.025f, 0.02f);
            break;
        }
        case LampFamily::dome: {
            const std::array<Vec2f, 7> p{Vec2f{r, y}, {0.97f * r, y + 0.2f * r}, {0.85f * r, y + 0.45f * r}, {0.62f * r, y + 0.68f * r}, {0.34f * r, y + 0.82f * r}, {0.1f * r, y + 0.88f * r}, {0.05f * r, y + 1.f * r}};
            k.add(shapes::shade(p, 36), k.piece.main_material);
            bulb(y + 0.35f * r, 0.05f);
            break;
        }
    }
}
int lamp_metal(Kit& k) { return k.main(k.style.metal); }

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
        bow.push_back({-0.42f + 0.84f * (1.f - std::cos(1.5708f * t)), 0.06f + 1.72f * std::sin(1.5708f * std::min(1.f, 1.02f * t)), 0});
    }
    k.add(shapes::tube(bow, 0.011f, 10), metal);
    const Vec3f tip = bow.back();
    k.rod(metal, tip, tip - Vec3f{0, 0.1f, 0}, 0.008f);
    const std::array<Vec2f, 5> p{Vec2f{0.17f, -0.26f}, {0.165f, -0.2f}, {0.13f, -0.14f}, {0.07f, -0.1f}, {0.02f, -0.09f}};
    k.add(shapes::shade(p, 32), metal, tip);
    k.add(shapes::ball(tip - Vec3f{0, 0.2f, 0}, {0.05f, 0.05f, 0.05f}), k.material(glow("bulb", k.style.lamp_light * 1.4f)));
}
void floor_lamp(Kit& k) {
    if (form_for(k, {{"modern", 1, 0}, {"mid-century", 0, 1}, {"art deco", 0, 1}, {"industrial", 0, 1}}, 0) == 1) return arc_lamp(k);
    const int metal = lamp_metal(k);
    if (k.style.legs == LegType::tapered || k.style.legs == LegType::splayed) {
        const int wood = k.material(k.style.wood);
        for (int i = 0; i < 3; ++i) {
            const float a = 2.0944f * static_cast<float>(i) + 0.3f;
            k.rod(wood, {0.26f * std::cos(a), 0, 0.26f * std::sin(a)}, {0.02f * std::cos(a), 1.26f, 0.02f * std::sin(a)}, 0.011f, 0.016f);
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
        const std::array<Vec2f, 8> p{Vec2f{0.05f, 0}, {0.06f, 0.01f}, {b, 0.07f}, {b * 1.05f, 0.11f}, {b * 0.7f, 0.19f}, {0.022f, 0.235f}, {0.02f, 0.26f}, {0.012f, 0.3f}};
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
    lamp_head(k, -drop, r, true);
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
    const std::array<Vec2f, 6> p{Vec2f{0, -0.1f}, {0.1f, -0.095f}, {0.16f, -0.08f}, {0.192f, -0.055f}, {0.2f, -0.036f}, {0.19f, -0.019f}};
    k.add(shapes::lathe(p, 40, true), k.material(milk));
    k.piece.mount = Mount::ceiling;
}
void chandelier(Kit& k) {
    const int metal = lamp_metal(k), wax = k.material(plain("candle sleeve", {0.75f, 0.72f, 0.64f}, 0.6f)),
              flame = k.material(glow("bulb", k.style.lamp_light * 1.6f));
    k.add(shapes::prism(shapes::circle(0.06f, 24), -0.03f, 0.f), metal);
    k.rod(metal, {0, -0.55f, 0}, {0, -0.02f, 0}, 0.007f);
    const std::array<Vec2f, 9> p{Vec2f{0, -0.9f}, {0.02f, -0.88f}, {0.03f, -0.85f}, {0.015f, -0.81f}, {0.05f, -0.75f}, {0.055f, -0.7f}, {0.02f, -0.63f}, {0.03f, -0.58f}, {0.008f, -0.52f}};
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

constexpr Entry kLamps[] = {{"floor_lamp", floor_lamp}, {"table_lamp", table_lamp}, {"pendant_lamp", pendant_lamp}, {"ceiling_lamp", ceiling_lamp}, {"chandelier", chandelier}};

}  // namespace

std::span<const Entry> lamps() { return kLamps; }

}  // namespace fastscene::furniture
