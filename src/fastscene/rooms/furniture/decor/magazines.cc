// Magazines.
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_magazines(Kit& k) {
    const int count = 2 + k.rng.index(3);
    for (int i = 0; i < count; ++i) {
        Material m = plain("magazine", lerp(k.accent(), {0.7f, 0.68f, 0.62f}, k.rng.uniform(0.f, 0.5f)), 0.35f);
        m.pattern = Pattern::art;
        m.color_b = k.accent();
        m.color_c = {0.75f, 0.73f, 0.68f};
        m.scale_m = 0.2f;
        m.seed = k.seed();
        const int mat = i == 0 ? k.main(m) : k.material(m);
        Mesh sheet = shapes::box({0.21f, 0.008f, 0.28f}, 0.001f);
        for (Vec3f& c : sheet.coords) c = {c.x, c.z, c.y};
        shapes::turn(sheet, {0, 1, 0}, k.rng.uniform(-14, 14));
        k.add(std::move(sheet), mat, {0, 0.004f + 0.008f * static_cast<float>(i), 0});
    }
    on_surface(k);
}

}  // namespace fastscene::furniture
