// What kitchen units and washbasins share: fronts, worktop, tap.
#include "fastscene/rooms/furniture/kitchen/worktop.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fastscene::furniture {
namespace {

Material usual_worktop(const Kit& k) {
    return k.style.legs == LegType::tapered || k.style.legs == LegType::square ? k.style.wood2
                                                                               : *material_named("marble");
}

}  // namespace

Material part_in(Material usual, const std::string& material, const std::string& color) {
    if (const auto asked = material.empty() ? std::nullopt : material_named(material)) usual = *asked;
    if (const auto asked = color.empty() ? std::nullopt : color_named(color)) {
        // A plain worktop of another color is no longer wood.
        usual = material.empty() && usual.pattern == Pattern::wood ? plain("worktop", *asked, 0.3f)
                                                                   : tinted(usual, *asked);
    }
    return usual;
}

Material worktop(const Kit& k) { return part_in(usual_worktop(k), k.request.holder_material, k.request.holder_color); }

// Of wood, or in one of the paints that kitchens of the style have: not every accent of a room suits a wall of doors.
Material kitchen_front(const Kit& k) {
    if (k.style.kitchen_paints.empty()) return k.style.wood;
    const bool second = (k.request.seed & 4) != 0;
    return plain("painted fronts", k.style.kitchen_paints[second ? 1 : 0], 0.4f);
}

void tap(Kit& k, int chrome, Vec3f at, float h) {
    std::vector<Vec3f> path{at, at + Vec3f{0, 0.6f * h, 0}};
    for (int i = 0; i <= 8; ++i) {
        const float a = 3.14159f * static_cast<float>(i) / 8.f;
        path.push_back(at + Vec3f{0, 0.7f * h + 0.3f * h * std::sin(a), 0.07f * (1.f - std::cos(a))});
    }
    k.add(shapes::tube(path, 0.011f, 10), chrome);
    k.rod(chrome, at, at + Vec3f{0, 0.03f, 0}, 0.024f, -1, 16);
    k.rod(chrome, at + Vec3f{0.015f, 0.06f, 0}, at + Vec3f{0.07f, 0.085f, 0}, 0.007f, -1, 8);
}

}  // namespace fastscene::furniture
