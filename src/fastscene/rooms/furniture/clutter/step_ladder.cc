// Step ladder.
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Steps in front, a frame to lean on behind, a cap on top; splashed with paint.
void build_step_ladder(Kit& k) {
    const float high = 1.55f, half = 0.21f, front = 0.42f, back = -0.42f;
    Material wood = *material_named("pine");
    wood.color_a = wood.color_a * 0.85f;
    const bool metal = k.style.aluminium_ladders;
    const int rail = k.main(metal ? plain("aluminium", {0.52f, 0.53f, 0.54f}, 0.35f) : wood),
              cap = k.material(plain("ladder cap", metal ? Vec3f{0.6f, 0.12f, 0.04f} : wood.color_a, 0.5f)),
              cord = k.material(plain("cord", {0.5f, 0.44f, 0.33f}, 0.9f)),
              paint = k.material(plain("dried paint", {0.74f, 0.73f, 0.7f}, 0.6f));
    const auto at = [&](float y, float foot) { return foot * (1.f - y / (high + 0.12f)); };
    for (const float sx : {-1.f, 1.f}) {
        strut(k, rail, {sx * (half + 0.04f), 0.003f, front}, {sx * half, high, at(high, front)}, 0.026f, 0.062f);
        strut(k, rail, {sx * (half - 0.02f), 0.003f, back}, {sx * (half - 0.04f), high - 0.03f, at(high, back)}, 0.024f,
              0.042f);
        k.rod(cord, {sx * (half + 0.01f), 0.62f, at(0.62f, front)}, {sx * (half - 0.03f), 0.62f, at(0.62f, back)},
              0.004f, -1, 6);
    }
    for (int i = 1; i <= 5; ++i) {
        const float y = 0.27f * static_cast<float>(i);
        k.board(rail, {0, y, at(y, front) - 0.005f}, {2 * half + 0.05f, 0.022f, 0.1f}, 0.003f);
        if (k.rng.chance(0.7f))
            k.add(shapes::ball({k.rng.uniform(-0.13f, 0.13f), y + 0.022f, at(y, front) + k.rng.uniform(-0.02f, 0.02f)},
                               {0.03f, 0.0025f, 0.02f}, 12),
                  paint);
    }
    for (const float y : {0.4f, 1.05f})
        k.rod(rail, {-half + 0.02f, y, at(y, back)}, {half - 0.02f, y, at(y, back)}, 0.012f, -1, 10);
    k.board(cap, {0, high - 0.02f, 0.0f}, {2 * half + 0.06f, 0.035f, 0.17f}, 0.006f);
    k.top(high + 0.015f, 0, 0, 0.14f, 0.06f);
}

}  // namespace fastscene::furniture
