// Shades and feet that lamps of a style share.
#include "fastscene/rooms/furniture/lamps/lamp_parts.h"

#include <array>
#include <cmath>

namespace fastscene::furniture {

void lamp_head(Kit& k, float y, float r, bool hanging, LampFamily family, int paper) {
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

void foot_disc(Kit& k, int m, float r) {
    const std::array<Vec2f, 5> p{Vec2f{r, 0}, {r, 0.014f}, {r - 0.008f, 0.022f}, {0.02f, 0.03f}, {0.012f, 0.05f}};
    k.add(shapes::lathe(p, 32), m);
}

}  // namespace fastscene::furniture
