// Rocking horse.
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_rocking_horse(Kit& k) {
    const int wood = k.main(k.style.wood2), hair = k.material(plain("mane", {0.25f, 0.15f, 0.08f}, 0.9f)),
              saddle = k.material(tinted(k.style.leather, k.accent()));
    for (const float sz : {-1.f, 1.f}) {
        std::vector<Vec3f> rocker;
        for (int i = 0; i <= 16; ++i) {
            const float t = static_cast<float>(i) / 8.f - 1.f;
            rocker.push_back({0.48f * t, 0.018f + 0.13f * t * t, sz * 0.14f});
        }
        k.add(shapes::tube(rocker, 0.018f, 10), wood);
        for (const float sx : {-1.f, 1.f})
            k.rod(wood, {sx * 0.26f, 0.05f, sz * 0.14f}, {sx * 0.18f, 0.42f, sz * 0.07f}, 0.02f, 0.03f);
    }
    k.add(shapes::ball({0, 0.46f, 0}, {0.3f, 0.13f, 0.12f}, 24), wood);
    k.rod(wood, {0.2f, 0.48f, 0}, {0.36f, 0.76f, 0}, 0.085f, 0.055f, 18);
    k.rod(wood, {0.33f, 0.76f, 0}, {0.5f, 0.66f, 0}, 0.065f, 0.04f, 18);
    for (const float sz : {-1.f, 1.f})
        k.rod(wood, {0.33f, 0.8f, sz * 0.035f}, {0.32f, 0.86f, sz * 0.04f}, 0.018f, 0.006f, 8);
    for (int i = 0; i < 6; ++i)
        k.add(shapes::ball({0.17f + 0.028f * static_cast<float>(i), 0.57f + 0.045f * static_cast<float>(i), 0},
                           {0.04f, 0.05f, 0.03f}, 10),
              hair);
    k.rod(hair, {-0.28f, 0.5f, 0}, {-0.4f, 0.28f, 0}, 0.035f, 0.015f);
    k.add(shapes::ball({-0.02f, 0.56f, 0}, {0.13f, 0.06f, 0.11f}, 18), saddle);
    k.rod(wood, {0.33f, 0.72f, -0.13f}, {0.33f, 0.72f, 0.13f}, 0.012f);
    k.piece.clearance_front_m = 0.2f;
}

}  // namespace fastscene::furniture
