// Towel rail.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_towel_rail(Kit& k) {
    const int cloth = k.main(tinted(k.style.fabric, k.accent())), chrome = k.material(k.style.metal);
    for (const float sx : {-1.f, 1.f}) k.rod(chrome, {sx * 0.29f, 0.5f, 0}, {sx * 0.29f, 0.5f, 0.075f}, 0.01f);
    k.rod(chrome, {-0.3f, 0.5f, 0.07f}, {0.3f, 0.5f, 0.07f}, 0.009f);
    const std::uint32_t seed = k.seed();
    k.add(shapes::slab(24, 24, 0.008f,
                       [=](float u, float v) {
                           const float x = (u - 0.5f) * 0.42f, run = (v - 0.45f) * 1.05f,
                                       over = std::min(std::fabs(run), 0.03f);
                           const float side = run < 0 ? 1.f : -1.f, hang = std::max(0.f, std::fabs(run) - 0.03f);
                           return Vec3f{x, 0.518f - 0.2f * over - hang,
                                        0.07f + side * (0.55f * over + 0.01f * hang) +
                                            0.007f * std::min(1.f, 6.f * hang) *
                                                (std::sin(x * 26.f) + shapes::wobble({x * 9, v * 3, 0}, seed))};
                       }),
          cloth);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.8f;
}

}  // namespace fastscene::furniture
