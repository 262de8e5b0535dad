// Crystal ball.
#include <array>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A ball of clear glass on a turned foot.
void build_crystal_ball(Kit& k) {
    Material clear = plain("crystal", {0.4f, 0.46f, 0.68f}, 0.03f);
    clear.metal = 0.5f;
    const int ball = k.main(clear), foot = k.material(*material_named("brass"));
    const std::array<Vec2f, 9> p{Vec2f{0.07f, 0}, {0.072f, 0.012f}, {0.05f, 0.022f},  {0.024f, 0.035f}, {0.03f, 0.048f},
                                 {0.05f, 0.058f}, {0.058f, 0.07f},  {0.054f, 0.072f}, {0.02f, 0.064f}};
    k.add(shapes::lathe(p, 32, false), foot);
    k.add(shapes::ball({0, 0.155f, 0}, {0.095f, 0.095f, 0.095f}, 36), ball);
    for (int i = 0; i < 3; ++i) {
        const Vec3f out = around(2.0944f * static_cast<float>(i) + 0.5f);
        k.rod(foot, out * 0.045f + Vec3f{0, 0.06f, 0}, out * 0.088f + Vec3f{0, 0.11f, 0}, 0.007f, 0.004f, 8);
    }
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
