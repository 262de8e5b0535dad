// Adirondack chair.
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Of boards: a seat that slopes back, a fan of slats, broad arms.
void build_adirondack_chair(Kit& k) {
    const int wood = k.main(k.style.wood2);
    const auto board_from = [&](Vec3f a, Vec3f b, float wide, float thick) {
        const Vec3f d = b - a;
        Mesh m = shapes::box({wide, length(d), thick}, 0.006f);
        shapes::turn(m, {0, 0, 1}, -std::asin(d.x / length(d)) * 180.f / kPi);
        shapes::turn(m, {1, 0, 0}, std::atan2(d.z, d.y) * 180.f / kPi);
        k.add(std::move(m), wood, (a + b) * 0.5f);
    };
    for (const float sx : {-1.f, 1.f}) {
        // A rail from before the knees to the floor behind; legs; an arm on both.
        board_from({sx * 0.27f, 0.05f, -0.48f}, {sx * 0.27f, 0.36f, 0.34f}, 0.025f, 0.1f);
        k.board(wood, {sx * 0.3f, 0, 0.29f}, {0.028f, 0.55f, 0.1f}, 0.006f);
        k.board(wood, {sx * 0.3f, 0.02f, -0.26f}, {0.028f, 0.53f, 0.08f}, 0.006f);
        k.board(wood, {sx * 0.335f, 0.55f, 0.02f}, {0.13f, 0.024f, 0.76f}, 0.01f);
    }
    for (int i = 0; i < 6; ++i) {
        const float t = static_cast<float>(i) / 5.f;
        k.board(wood, {0, 0.405f - 0.155f * t, 0.32f - 0.44f * t}, {0.56f, 0.022f, 0.078f}, 0.006f);
    }
    const Vec3f foot{0, 0.2f, -0.19f};
    for (int i = -3; i <= 3; ++i) {
        const float x = static_cast<float>(i), tall = 0.8f - 0.018f * x * x;
        board_from(foot + Vec3f{0.07f * x, 0, 0}, foot + Vec3f{0.092f * x, tall * 0.9f, -tall * 0.42f}, 0.072f, 0.02f);
    }
    k.board(wood, {0, 0.47f, -0.345f}, {0.66f, 0.07f, 0.024f}, 0.006f);
    k.board(wood, {0, 0.78f, -0.49f}, {0.52f, 0.055f, 0.022f}, 0.006f);
    put_pillow(k, accent_cloth(k), {0, 0.34f, -0.03f}, {0.42f, 0.4f, 0.13f}, 26.f);
    k.top(0.4f, 0, 0.2f, 0.2f, 0.08f);
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture
