// Floor lamp.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/lamps/lamp_parts.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {
namespace {

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

}  // namespace

void build_floor_lamp(Kit& k) {
    if (form_for(k, k.style.forms.floor_lamp) == FloorLampForm::arc) return arc_lamp(k);
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

}  // namespace fastscene::furniture
