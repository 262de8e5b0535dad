// Of dance studios: a wall of mirrors with the barre before it.
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

void build_ballet_barre(Kit& k) {
    const Vec3f s = k.wanted({2.0f, 2.1f, 0.3f});
    Material glass_of = plain("mirror", {0.82f, 0.83f, 0.83f}, 0.04f);
    glass_of.mirror = 1;
    const int wood = k.main(materials::timber("natural", 0.35f)), metal = k.material(steel()),
              mirror = k.material(glass_of), edge = color(k, "mirror back", {0.12f, 0.14f, 0.14f}, 0.3f);
    k.board(edge, {0, 0.02f, 0.006f}, {s.x, s.y - 0.02f, 0.012f}, 0.001f);
    const int panes = std::max(1, static_cast<int>(s.x / 0.95f));
    const float w = s.x / static_cast<float>(panes);
    for (int i = 0; i < panes; ++i)
        k.board(mirror, {-0.5f * s.x + w * (static_cast<float>(i) + 0.5f), 0.025f, 0.0135f},
                {w - 0.006f, s.y - 0.03f, 0.003f}, 0.0008f);
    k.board(metal, {0, 0, 0.012f}, {s.x, 0.03f, 0.024f}, 0.002f);
    for (const float y : {0.82f, 1.08f}) {
        k.rod(wood, {-0.5f * s.x, y, s.z - 0.03f}, {0.5f * s.x, y, s.z - 0.03f}, 0.021f, -1, 16);
        for (const float x : {-0.36f, 0.36f}) {
            k.rod(metal, {x * s.x, y - 0.02f, 0.012f}, {x * s.x, y - 0.02f, s.z - 0.03f}, 0.012f, -1, 10);
            k.rod(metal, {x * s.x, y - 0.02f, 0.014f}, {x * s.x, y - 0.02f, 0.022f}, 0.035f, -1, 16);
        }
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.8f;
}

}  // namespace fastscene::furniture
