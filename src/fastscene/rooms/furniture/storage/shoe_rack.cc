// Shoe rack.
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/storage/carcass.h"

namespace fastscene::furniture {

void build_shoe_rack(Kit& k) {
    const Vec3f s = k.wanted({0.8f, 0.5f, 0.32f});
    const int wood = k.main(k.style.wood);
    carcass(k, wood, s, 0.06f);
    k.board(wood, {0, 0.28f, 0}, {s.x - 0.044f, 0.02f, s.z - 0.02f});
    for (const float sx : {-1.f, 1.f}) k.board(wood, {sx * (0.5f * s.x - 0.06f), 0, 0}, {0.04f, 0.062f, s.z - 0.04f});
    for (int i = 0; i < 6; ++i) {
        const int shoe = i % 2 == 0 ? k.material(tinted(k.style.leather, k.accent()))
                                    : static_cast<int>(k.piece.materials.size()) - 1;
        const float y = i < 4 ? 0.082f : 0.3f, x = (i < 4 ? -0.27f : -0.15f) + 0.12f * static_cast<float>(i % 4) +
                                                   0.06f * static_cast<float>(i / 2);
        Mesh m = shapes::soft_box({0.085f, 0.07f, 0.24f}, {0.035f, 0.01f, 0.001f, 3, k.seed()});
        k.add(std::move(m), shoe, {x, y + 0.036f, 0.02f});
        k.soft(shoe, {x, y + 0.04f, -0.055f}, {0.075f, 0.07f, 0.1f}, {0.03f, 0.005f, 0.001f, 2});
    }
    k.top(s.y, 0, 0, 0.45f * s.x, 0.4f * s.z);
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
