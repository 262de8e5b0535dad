// Storage box.
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_storage_box(Kit& k) {
    Material m = k.rng.chance(0.5f) ? *material_named("wicker")
                                    : tinted(k.style.fabric2, lerp(k.accent(), {0.6f, 0.57f, 0.5f}, 0.5f));
    const int mat = k.main(m);
    const Vec3f s = k.wanted({0.32f, 0.2f, 0.24f});
    k.board(mat, {}, {s.x, 0.8f * s.y, s.z}, 0.012f);
    k.board(mat, {0, 0.8f * s.y, 0}, {s.x + 0.012f, 0.2f * s.y, s.z + 0.012f}, 0.01f);
    on_surface(k);
}

}  // namespace fastscene::furniture
