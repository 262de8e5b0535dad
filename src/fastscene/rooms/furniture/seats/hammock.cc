// Hammock.
#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {

// Cloth between the ends of a wooden stand.
void build_hammock(Kit& k) {
    const Vec3f s = k.wanted({2.5f, 1.2f, 0.85f});
    Material m = tinted(k.style.fabric2, k.accent());
    m.pattern = Pattern::stripes;
    m.scale_m = 0.07f;
    m.color_b = {0.68f, 0.64f, 0.55f};
    m.color_c = m.color_a;
    const int cloth = k.main(m), wood = k.material(k.style.wood2),
              cord = k.material(plain("cord", {0.5f, 0.44f, 0.33f}, 0.9f));
    const float reach = 0.5f * s.x - 0.04f, high = s.y - 0.03f, width = 0.88f * s.z, sag = 0.5f * high;
    // A low bow of wood, feet across its ends.
    std::vector<Vec3f> bow;
    for (int i = 0; i <= 24; ++i) {
        const float t = static_cast<float>(i) / 12.f - 1.f, t4 = t * t * t * t;
        bow.push_back({reach * (t < 0 ? -1.f : 1.f) * std::pow(std::abs(t), 0.72f), 0.075f + (high - 0.075f) * t4, 0});
    }
    k.add(shapes::tube(bow, 0.036f, 12), wood);
    for (const float x : {-0.5f * reach, 0.5f * reach}) k.board(wood, {x, 0, 0}, {0.09f, 0.06f, s.z}, 0.01f);
    const auto hang = [&](float u, float v) {
        const float t = 2 * u - 1, across = 2 * v - 1, end = std::sqrt(std::max(0.f, 1.f - t * t));
        const float y = high - 0.06f - (sag * (1.f - t * t)) * (1.f - 0.22f * across * across);
        return Vec3f{0.74f * reach * t, y, 0.5f * width * across * (0.42f + 0.58f * end)};
    };
    k.add(shapes::slab(30, 12, 0.006f, [&](float u, float v) { return hang(u, 1 - v); }), cloth);
    for (const float end : {0.f, 1.f})
        for (int i = 0; i <= 8; ++i)
            k.rod(cord, hang(end, static_cast<float>(i) / 8.f), bow[end > 0.5f ? 24 : 0], 0.0035f, -1, 6);
    k.piece.clearance_front_m = 0.3f;
}

}  // namespace fastscene::furniture
