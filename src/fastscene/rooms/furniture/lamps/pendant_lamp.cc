// Pendant lamp.
#include <array>
#include <optional>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/lamps/lamp_parts.h"

namespace fastscene::furniture {
namespace {

// "brass pendant lights", "a black pendant": the shade is, not the cord alone; of glass it is a globe, of paper a
// lantern.
LampFamily shade_asked(const Kit& k) {
    if (k.style.lamp == LampFamily::cage) return k.style.lamp;
    const auto asked = k.request.material.empty() ? std::nullopt : material_named(k.request.material);
    // Where lamps bear candles, a single one is of opal glass.
    if (k.request.material == "glass" ||
        (k.style.lamp == LampFamily::candelabra && !asked && k.request.color_name.empty() && !k.request.color))
        return LampFamily::globe;
    if (asked ? asked->metal > 0.5f : k.request.color || !k.request.color_name.empty()) return LampFamily::dome;
    return k.style.lamp;
}

}  // namespace

void build_pendant_lamp(Kit& k) {
    const int metal = lamp_metal(k);
    const float drop = k.request.size_m.y > 0.4f ? k.request.size_m.y : 0.95f, r = 0.2f;
    k.sized = true;
    k.add(shapes::prism(shapes::circle(0.05f, 24), -0.025f, 0.f), metal);
    const LampFamily shade = shade_asked(k);
    lamp_head(k, -drop, r, true, shade);
    if (shade == LampFamily::globe && k.style.lamp == LampFamily::candelabra) {  // a turned gallery holds the globe
        const std::array<Vec2f, 6> gallery{Vec2f{0.5f * r, 0},    {0.54f * r, 0.06f * r}, {0.3f * r, 0.2f * r},
                                           {0.16f * r, 0.3f * r}, {0.2f * r, 0.4f * r},   {0.04f * r, 0.5f * r}};
        k.add(shapes::lathe(gallery, 24, true), metal, {0, -drop + 1.46f * r, 0});
        k.add(shapes::ball({0, -0.5f * drop, 0}, {0.025f, 0.035f, 0.025f}, 14), metal);
        k.rod(metal, {0, -drop + 1.5f * r, 0}, {0, -0.01f, 0}, 0.009f, -1, 10);
    }
    k.rod(metal, {0, -drop + 0.85f * r, 0}, {0, -0.01f, 0}, 0.004f, -1, 6);
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
