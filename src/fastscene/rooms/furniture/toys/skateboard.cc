// Skateboard.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A deck with its wheels, lying on the floor.
void build_skateboard(Kit& k) {
    const int deck = k.main(plain("deck", k.accent(), 0.5f)), metal = k.material(steel()),
              wheel = k.material(plain("wheels", {0.65f, 0.6f, 0.5f}, 0.5f)),
              grip = k.material(plain("grip tape", {0.035f, 0.035f, 0.035f}, 0.95f));
    const auto curve = [](float lift, float inset) {
        return [=](float u, float v) {
            const float x = (u - 0.5f) * (0.8f - inset), end = std::max(0.f, std::abs(x) - 0.28f);
            return Vec3f{x, 0.09f + lift + 0.5f * end, (0.5f - v) * (0.2f - inset) * (end > 0.06f ? 0.8f : 1.f)};
        };
    };
    k.add(shapes::slab(24, 4, 0.012f, curve(0.f, 0.f)), deck);
    k.add(shapes::slab(24, 4, 0.001f, curve(0.0015f, 0.006f)), grip);
    for (const float sx : {-0.21f, 0.21f}) {
        k.board(metal, {sx, 0.035f, 0}, {0.05f, 0.043f, 0.06f}, 0.004f);
        k.rod(metal, {sx, 0.027f, -0.09f}, {sx, 0.027f, 0.09f}, 0.005f, -1, 8);
        for (const float sz : {-0.085f, 0.085f})
            k.rod(wheel, {sx, 0.027f, sz - 0.016f}, {sx, 0.027f, sz + 0.016f}, 0.027f, -1, 20);
    }
}

}  // namespace fastscene::furniture
