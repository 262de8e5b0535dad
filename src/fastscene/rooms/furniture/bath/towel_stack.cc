// Towel stack.
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_towel_stack(Kit& k) {
    Material m = k.style.fabric;
    m.pattern = Pattern::knit;
    m.scale_m = 0.008f;
    m.bump_m = 0.002f;
    const int first = k.main(tinted(m, lerp(k.accent(), {0.76f, 0.74f, 0.7f}, 0.5f))),
              second = k.material(tinted(m, {0.76f, 0.74f, 0.7f}));
    const int count = 2 + k.rng.index(3);
    for (int i = 0; i < count; ++i)
        k.soft(i % 2 == 0 ? first : second, {0, 0.058f * static_cast<float>(i), 0},
               {0.34f - 0.01f * static_cast<float>(i), 0.062f, 0.24f}, {0.024f, 0.01f, 0.002f, 10});
    on_surface(k);
}

}  // namespace fastscene::furniture
