// Teddy bear.
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_teddy_bear(Kit& k) {
    Material fur = k.style.fabric;
    fur.pattern = Pattern::carpet;
    fur.bump_m = 0.003f;
    const int body = k.main(tinted(fur, {0.36f, 0.2f, 0.09f})),
              dark = k.material(plain("button", {0.03f, 0.025f, 0.02f}, 0.3f)),
              pale = k.material(tinted(fur, {0.6f, 0.44f, 0.26f}));
    k.add(shapes::ball({0, 0.1f, 0}, {0.085f, 0.1f, 0.075f}), body);
    k.add(shapes::ball({0, 0.24f, 0.01f}, {0.075f, 0.07f, 0.07f}), body);
    k.add(shapes::ball({0, 0.225f, 0.07f}, {0.035f, 0.028f, 0.025f}), pale);
    k.add(shapes::ball({0, 0.238f, 0.092f}, {0.012f, 0.009f, 0.008f}, 10), dark);
    for (const float s : {-1.f, 1.f}) {
        k.add(shapes::ball({s * 0.06f, 0.3f, 0}, {0.03f, 0.03f, 0.015f}), body);
        k.add(shapes::ball({s * 0.03f, 0.262f, 0.07f}, {0.008f, 0.008f, 0.006f}, 8), dark);
        k.add(shapes::ball({s * 0.1f, 0.13f, 0.03f}, {0.032f, 0.065f, 0.035f}), body);
        k.add(shapes::ball({s * 0.065f, 0.036f, 0.085f}, {0.036f, 0.036f, 0.07f}), body);
    }
    on_surface(k);
}

}  // namespace fastscene::furniture
