// Teddy bear.
#include <array>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_teddy_bear(Kit& k) {
    Material fur = k.style.fabric;
    fur.pattern = Pattern::carpet;
    fur.bump_m = 0.003f;
    static constexpr std::array<std::array<Vec3f, 2>, 4> kFurs{{{Vec3f{0.36f, 0.2f, 0.09f}, {0.6f, 0.44f, 0.26f}},
                                                                {Vec3f{0.58f, 0.46f, 0.3f}, {0.7f, 0.62f, 0.48f}},
                                                                {Vec3f{0.17f, 0.09f, 0.045f}, {0.5f, 0.36f, 0.2f}},
                                                                {Vec3f{0.42f, 0.4f, 0.39f}, {0.68f, 0.66f, 0.62f}}}};
    const auto& [coat, muzzle] = kFurs[static_cast<std::size_t>(k.rng.index(4))];
    const int body = k.main(tinted(fur, coat)), dark = k.material(plain("button", {0.03f, 0.025f, 0.02f}, 0.3f)),
              pale = k.material(tinted(fur, muzzle));
    k.add(shapes::ball({0, 0.1f, 0}, {0.085f, 0.1f, 0.075f}), body);
    k.add(shapes::ball({0, 0.24f, 0.01f}, {0.075f, 0.07f, 0.07f}), body);
    k.add(shapes::ball({0, 0.225f, 0.07f}, {0.035f, 0.028f, 0.025f}), pale);
    k.add(shapes::ball({0, 0.238f, 0.092f}, {0.012f, 0.009f, 0.008f}, 10), dark);
    for (const float s : {-1.f, 1.f}) {
        k.add(shapes::ball({s * 0.06f, 0.3f, 0}, {0.03f, 0.03f, 0.015f}), body);
        k.add(shapes::ball({s * 0.03f, 0.262f, 0.07f}, {0.008f, 0.008f, 0.006f}, 8), dark);
        k.add(shapes::ball({s * 0.1f, 0.13f, 0.03f}, {0.032f, 0.065f, 0.035f}), body);
        k.add(shapes::ball({s * 0.065f, 0.036f, 0.085f}, {0.036f, 0.036f, 0.07f}), body);
    }
    on_surface(k);
}

}  // namespace fastscene::furniture
