// Bulb pendant.
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/lamps/lamp_parts.h"

namespace fastscene::furniture {

// Clear bulbs with a glowing thread, each on its own cord: three at different heights from one rose, or one.
void build_bulb_pendant(Kit& k) {
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

}  // namespace fastscene::furniture
