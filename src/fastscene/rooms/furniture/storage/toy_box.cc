// Toy box.
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/storage/carcass.h"

namespace fastscene::furniture {

void build_toy_box(Kit& k) {
    const int wood = k.main(k.style.wood2);
    const Vec3f s{0.8f, 0.42f, 0.45f};
    carcass(k, wood, s, 0.0f);
    k.board(wood, {0, 0, 0.5f * s.z - 0.011f}, {s.x - 0.044f, s.y - 0.02f, 0.02f});
    for (int i = 0; i < 3; ++i)
        k.add(shapes::ball({-0.2f + 0.2f * static_cast<float>(i), 0.42f + 0.06f, 0.02f * static_cast<float>(i)},
                           {0.07f, 0.07f, 0.07f}, 16),
              k.material(plain("toy ball", k.accent(), 0.4f)));
    for (int i = 0; i < 4; ++i)
        k.board(k.material(plain("toy block", k.accent(), 0.5f)),
                {-0.26f + 0.17f * static_cast<float>(i), 0.14f, 0.5f * s.z}, {0.09f, 0.09f, 0.012f}, 0.004f);
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
