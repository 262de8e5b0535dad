// Ceiling fan.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/plants/foliage.h"

namespace fastscene::furniture {

// Blades about a motor on a short rod, an opal glass below it: three slim ones, five boards or five leaves.
void build_ceiling_fan(Kit& k) {
    const bool leaves = k.style.fan_blades == FanForm::leaves, slim = k.style.fan_blades == FanForm::slim;
    const float reach = 0.62f * k.request.size_factor;
    k.sized = true;
    const int blade = k.main(k.style.of(k.style.made_of.fan_blades)), metal = k.material(k.style.metal);
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
            const float leaf = leaves ? 0.075f + 0.13f * std::sin(kPi * std::min(1.f, 0.08f + 0.92f * v))
                               : slim ? std::lerp(0.15f, 0.1f, v)
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

}  // namespace fastscene::furniture
