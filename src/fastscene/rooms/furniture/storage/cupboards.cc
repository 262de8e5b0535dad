// Boxes with doors or drawers: nightstand, dresser, wardrobe, cabinet.
#include <algorithm>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/storage/carcass.h"

namespace fastscene::furniture {

void build_nightstand(Kit& k) { chest(k, k.wanted({0.45f, 0.52f, 0.4f}), 0.14f, 1, 2, 0.3f); }

void build_dresser(Kit& k) { chest(k, k.wanted({1.2f, 0.82f, 0.48f}), 0.12f, 2, 3, 0.6f); }

void build_wardrobe(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 2.1f, 0.6f});
    chest(k, s, 0.06f, std::max(2, static_cast<int>(s.x / 0.5f)), 1, 0.6f);
}

void build_cabinet(Kit& k) { chest(k, k.wanted({0.9f, 1.2f, 0.42f}), 0.12f, 2, 1, 0.5f); }

}  // namespace fastscene::furniture
