// Clothes horse.
#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A folding rack with washing over its bars.
void build_clothes_horse(Kit& k) {
    const int frame = k.main(plain("white enamel", {0.72f, 0.72f, 0.7f}, 0.35f));
    const float half = 0.52f, high = 0.95f, reach = 0.3f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.rod(frame, {sx * half, 0, sz * reach}, {sx * half, high, -sz * reach}, 0.011f, -1, 10);
    std::vector<Vec3f> bars;
    for (const float t : {1.f, 0.82f, 0.64f})
        for (const float sz : {-1.f, 1.f}) bars.push_back({0, high * t, sz * reach * (2 * t - 1)});
    for (const Vec3f& bar : bars) k.rod(frame, {-half, bar.y, bar.z}, {half, bar.y, bar.z}, 0.006f, -1, 8);
    for (std::size_t i = 0; i < 4; ++i) {
        // A towel, a shirt, a cloth: folded over the bar, one side longer.
        const Vec3f bar = bars[i < 2 ? i : i + 1 - (i % 2)];
        const float width = k.rng.uniform(0.3f, 0.46f),
                    x = (i % 2 == 0 ? -1.f : 1.f) * k.rng.uniform(0.02f, 0.06f) + (i < 2 ? 0.f : 0.02f),
                    down = (i < 2 ? 0.42f : 0.24f) * k.rng.uniform(0.8f, 1.f),
                    side = x + (i < 2 ? 0.f : (i == 2 ? -0.24f : 0.24f));
        Material m = tinted(k.style.fabric, lerp(k.accent(), {0.7f, 0.68f, 0.64f}, k.rng.uniform(0.2f, 0.7f)));
        const std::uint32_t seed = k.seed();
        k.add(shapes::slab(14, 20, 0.005f,
                           [=](float u, float v) {
                               const float across = (u - 0.5f) * (i < 2 ? width * 1.4f : width),
                                           run = (v - 0.42f) * 2.f * down, over = std::min(std::abs(run), 0.02f),
                                           way = run < 0 ? 1.f : -1.f, hang = std::max(0.f, std::abs(run) - 0.02f);
                               const float fold = 0.006f * std::min(1.f, 8.f * hang) *
                                                  (std::sin(across * 31.f) +
                                                   shapes::wobble({across * 9, v * 4, 0}, seed));
                               return Vec3f{side + across, bar.y + 0.012f - 0.25f * over - hang,
                                            bar.z + way * (0.55f * over + 0.008f) + fold};
                           }),
              k.material(m));
    }
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture
