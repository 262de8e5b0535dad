// Kettle.
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_kettle(Kit& k) {
    const int body = k.main(k.rng.chance(0.5f) ? steel() : plain("enamel", k.accent(), 0.2f)),
              dark = k.material(plain("black plastic", {0.035f, 0.035f, 0.037f}, 0.4f));
    const std::array<Vec2f, 7> p{Vec2f{0.08f, 0}, {0.092f, 0.015f}, {0.09f, 0.07f}, {0.068f, 0.15f},
                                 {0.05f, 0.175f}, {0.014f, 0.185f}, {0.f, 0.2f}};
    k.add(shapes::lathe(shapes::curve(p, 3), 26, true), body);
    k.rod(body, {-0.06f, 0.09f, 0}, {-0.125f, 0.15f, 0}, 0.018f, 0.01f);
    std::vector<Vec3f> handle;
    for (int i = 0; i <= 8; ++i) {
        const float a = 1.5f - 3.f * static_cast<float>(i) / 8.f;
        handle.push_back({0.065f + 0.06f * std::cos(a), 0.11f + 0.07f * std::sin(a), 0});
    }
    k.add(shapes::tube(handle, 0.01f, 8), dark);
    on_surface(k);
}

}  // namespace fastscene::furniture
