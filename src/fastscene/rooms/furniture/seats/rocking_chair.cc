// Rocking chair.
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A chair of turned wood on two rockers, with a cushion.
void build_rocking_chair(Kit& k) {
    const int wood = k.main(k.style.wood2), cloth = k.material(tinted(k.style.fabric2, k.accent()));
    const float half = 0.27f, seat = 0.41f;
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * half;
        std::vector<Vec3f> rocker;
        for (int i = 0; i <= 18; ++i) {
            const float t = static_cast<float>(i) / 9.f - 1.f;
            rocker.push_back({x, 0.017f + 0.085f * t * t, 0.47f * t - 0.04f});
        }
        k.add(shapes::tube(rocker, 0.017f, 10), wood);
        k.rod(wood, {x, 0.045f, 0.21f}, {x, 0.655f, 0.235f}, 0.017f, 0.02f, 12);
        k.rod(wood, {x, 0.045f, -0.25f}, {x - sx * 0.015f, seat, -0.22f}, 0.018f, 0.02f, 12);
        k.rod(wood, {x - sx * 0.015f, seat, -0.22f}, {x - sx * 0.03f, 1.09f, -0.43f}, 0.02f, 0.014f, 12);
        k.add(shapes::ball({x - sx * 0.03f, 1.1f, -0.434f}, {0.02f, 0.026f, 0.02f}, 12), wood);
        Mesh arm = shapes::box({0.065f, 0.024f, 0.56f}, 0.008f);
        shapes::turn(arm, {1, 0, 0}, -2);
        k.add(std::move(arm), wood, {x, 0.665f, -0.01f});
        k.rod(wood, {x, 0.22f, 0.215f}, {x, 0.2f, -0.24f}, 0.011f, -1, 10);
    }
    for (const float z : {0.218f, -0.235f}) k.rod(wood, {-half, 0.24f, z}, {half, 0.24f, z}, 0.011f, -1, 10);
    k.board(wood, {0, seat - 0.02f, -0.005f}, {2 * half - 0.01f, 0.026f, 0.48f}, 0.01f);
    // The back: slats between two rails, leaning as its posts do.
    const auto back = [&](float x, float y) { return Vec3f{x, y, -0.22f - 0.309f * (y - seat)}; };
    for (int i = -3; i <= 3; ++i)
        k.rod(wood, back(0.066f * static_cast<float>(i), seat), back(0.062f * static_cast<float>(i), 1.0f), 0.009f, -1,
              8);
    for (const auto& [y, high] : {std::pair{1.0f, 0.1f}, std::pair{0.52f, 0.04f}}) {
        Mesh rail = shapes::box({2 * half - 0.06f, high, 0.022f}, 0.007f);
        shapes::turn(rail, {1, 0, 0}, -17.2f);
        k.add(std::move(rail), wood, back(0, y));
    }
    k.soft(cloth, {0, seat + 0.006f, 0.01f}, {0.44f, 0.055f, 0.42f}, {0.022f, 0.012f, 0.002f, 9});
    k.top(seat + 0.06f, 0, 0.05f, 0.18f, 0.15f);
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture
