// Flag.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A flag on a staff along its upper edge, in bands; in one color when one was asked for.
void build_flag(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 0.8f, 0.04f});
    Material cloth = plain("flag cloth", k.style.palette[0], 0.8f);
    cloth.pattern = Pattern::fabric;
    cloth.scale_m = 0.003f;
    cloth.color_b = cloth.color_a * 0.9f;
    cloth.specular = 0.02f;
    const int main = k.main(cloth), metal = k.material(k.style.metal);
    const bool one_color = !k.request.color_name.empty() || k.request.color;
    const auto dyed = [&](Vec3f color) {
        Material m = cloth;
        m.color_a = color, m.color_b = color * 0.9f;
        m.color_c = color;
        return k.material(m);
    };
    const int middle = one_color ? main : dyed({0.72f, 0.71f, 0.67f}),
              last = one_color ? main : dyed(k.style.palette[2 % k.style.palette.size()]);
    const float p = k.rng.uniform(0, kTau), staff = s.y - 0.012f;
    const auto wave = [&](float x, float y) {
        return 0.03f + (0.016f * std::sin(15.f * x / s.x + p + 1.1f * y) +
                        0.007f * std::sin(31.f * x / s.x + 2 * p - 2.f * y)) *
                           std::min(1.f, 0.15f + (staff - y) / 0.3f);
    };
    for (int band = 0; band < 3; ++band) {
        const float x0 = s.x * (static_cast<float>(band) / 3.f - 0.5f);
        k.add(shapes::slab(24, 12, 0.002f,
                           [&](float u, float v) {
                               const float x = x0 + s.x * u / 3.f, y = staff * v;
                               return Vec3f{x, y, wave(x, y)};
                           }),
              band == 0   ? main
              : band == 1 ? middle
                          : last);
    }
    k.rod(metal, {-0.5f * s.x - 0.03f, staff, 0.03f}, {0.5f * s.x + 0.03f, staff, 0.03f}, 0.009f, -1, 12);
    for (const float x : {-0.4f * s.x, 0.4f * s.x}) k.rod(metal, {x, staff, 0}, {x, staff, 0.03f}, 0.006f, -1, 8);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.2f;
}

}  // namespace fastscene::furniture
