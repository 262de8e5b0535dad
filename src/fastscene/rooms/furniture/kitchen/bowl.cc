// Bowl.
#include <array>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_bowl(Kit& k) {
    const int body = k.main(plain("bowl", k.accent(), 0.3f));
    const std::array<Vec2f, 6> p{Vec2f{0.05f, 0}, {0.055f, 0.008f}, {0.09f, 0.025f},
                                 {0.12f, 0.055f}, {0.13f, 0.08f},   {0.131f, 0.085f}};
    k.add(shapes::vessel(p, 0.005f, 32), body);
    const Vec3f fruit[] = {{0.5f, 0.08f, 0.04f}, {0.65f, 0.3f, 0.05f}, {0.35f, 0.42f, 0.08f}};
    for (int i = 0; i < 5; ++i) {
        const float a = 1.2566f * static_cast<float>(i);
        k.add(shapes::ball(i == 4 ? Vec3f{0, 0.085f, 0} : around(a) * 0.05f + Vec3f{0, 0.055f, 0},
                           {0.034f, 0.032f, 0.034f}, 14),
              k.material(plain("fruit", fruit[i % 3], 0.35f)));
    }
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
