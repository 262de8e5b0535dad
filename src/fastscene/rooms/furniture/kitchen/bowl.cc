// Bowl.
#include <array>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_bowl(Kit& k) {
    const int body = k.main(plain("bowl", k.accent(), 0.3f));
    // Deep, or wide and low on a foot.
    static constexpr std::array<std::array<Vec2f, 6>, 2> kShapes{
        {{Vec2f{0.05f, 0}, {0.055f, 0.008f}, {0.09f, 0.025f}, {0.12f, 0.055f}, {0.13f, 0.08f}, {0.131f, 0.085f}},
         {Vec2f{0.045f, 0}, {0.046f, 0.016f}, {0.08f, 0.022f}, {0.118f, 0.04f}, {0.129f, 0.062f}, {0.131f, 0.07f}}}};
    k.add(shapes::vessel(kShapes[static_cast<std::size_t>(k.rng.index(2))], 0.005f, 32), body);
    // Mixed fruit, or all of one kind.
    const Vec3f fruit[] = {{0.5f, 0.08f, 0.04f}, {0.65f, 0.3f, 0.05f}, {0.35f, 0.42f, 0.08f}};
    const int only = k.rng.index(5);
    for (int i = 0; i < 5; ++i) {
        const float a = 1.2566f * static_cast<float>(i);
        k.add(shapes::ball(i == 4 ? Vec3f{0, 0.085f, 0} : around(a) * 0.05f + Vec3f{0, 0.055f, 0},
                           {0.034f, 0.032f, 0.034f}, 14),
              k.material(plain("fruit", fruit[only < 3 ? only : i % 3], 0.35f)));
    }
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
