// Pendant lamp.
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
    if (k.request.material == "glass") return LampFamily::globe;
    if (asked ? asked->metal > 0.5f : k.request.color || !k.request.color_name.empty()) return LampFamily::dome;
    return k.style.lamp;
}

}  // namespace

void build_pendant_lamp(Kit& k) {
    const int metal = lamp_metal(k);
    const float drop = k.request.size_m.y > 0.4f ? k.request.size_m.y : 0.95f, r = 0.2f;
    k.sized = true;
    k.add(shapes::prism(shapes::circle(0.05f, 24), -0.025f, 0.f), metal);
    lamp_head(k, -drop, r, true, shade_asked(k));
    k.rod(metal, {0, -drop + 0.85f * r, 0}, {0, -0.01f, 0}, 0.004f, -1, 6);
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
