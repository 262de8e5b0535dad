// Telescope.
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// On a tripod, looking up.
void build_telescope(Kit& k) {
    const int tube = k.main(plain("telescope tube", {0.6f, 0.58f, 0.54f}, 0.3f)),
              brass = k.material(*material_named("brass")), wood = k.material(k.style.wood);
    const Vec3f head{0, 1.05f, 0}, dir = normalize(Vec3f{0, 0.5f, 0.86f});
    for (int i = 0; i < 3; ++i) {
        const float a = 2.0944f * static_cast<float>(i);
        k.rod(wood, {0.4f * std::sin(a), 0, 0.4f * std::cos(a)}, {0.04f * std::sin(a), 1.f, 0.04f * std::cos(a)},
              0.013f, 0.018f, 8);
        k.rod(brass, {0, 0.5f, 0}, {0.22f * std::sin(a), 0.5f, 0.22f * std::cos(a)}, 0.006f, -1, 6);
    }
    k.add(shapes::ball(head - Vec3f{0, 0.03f, 0}, {0.045f, 0.05f, 0.045f}, 14), brass);
    k.rod(tube, head + dir * -0.34f, head + dir * 0.4f, 0.045f, 0.052f, 24);
    for (const float t : {-0.3f, 0.f, 0.36f})
        k.rod(brass, head + dir * (t - 0.014f), head + dir * (t + 0.014f), 0.056f, 0.056f, 24);
    k.rod(brass, head + dir * -0.44f, head + dir * -0.33f, 0.02f, 0.03f, 16);
    k.rod(k.material(plain("lens", {0.05f, 0.06f, 0.08f}, 0.05f)), head + dir * 0.4f, head + dir * 0.404f, 0.046f, -1,
          24);
}

}  // namespace fastscene::furniture
