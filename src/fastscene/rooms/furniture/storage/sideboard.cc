// Low, wide boxes with doors: sideboard, TV stand.
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/storage/carcass.h"

namespace fastscene::furniture {

void build_sideboard(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 0.75f, 0.45f});
    if (slatted(k)) return slatted_chest(k, s, 0.18f, 0.5f);
    const bool one_row = k.style.sideboard_most_rows < 2 || k.rng.chance(0.5f);
    chest(k, s, 0.16f, k.style.sideboard_columns, one_row ? 1 : 2, 0.5f);
}

void build_tv_stand(Kit& k) {
    const Vec3f s = k.wanted({1.6f, 0.48f, 0.42f});
    if (slatted(k)) return slatted_chest(k, s, 0.12f, 0.6f);
    chest(k, s, 0.12f, 3, 1, 0.6f);
}

}  // namespace fastscene::furniture
