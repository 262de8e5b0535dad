// Hung pans.
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A rail on the wall with pots and pans on hooks.
void build_hung_pans(Kit& k) {
    const int metal = k.main(*material_named("copper")),
              iron = k.material(plain("wrought iron", {0.035f, 0.034f, 0.033f}, 0.5f));
    const float half = 0.48f, rail = 0.5f, off = 0.075f;
    k.rod(iron, {-half, rail, off}, {half, rail, off}, 0.009f, -1, 10);
    for (const float sx : {-0.8f, 0.8f}) k.rod(iron, {sx * half, rail, 0}, {sx * half, rail, off}, 0.009f, -1, 10);
    for (int i = 0; i < 5; ++i) {
        const float x = (static_cast<float>(i) - 2.f) * 0.19f,
                    r = std::array{0.082f, 0.07f, 0.09f, 0.062f, 0.078f}[static_cast<std::size_t>(i)] *
                        k.rng.uniform(0.94f, 1.05f),
                    deep = i % 2 == 0 ? 0.042f : 0.075f, down = rail - 0.035f, long_ = 0.16f + 0.05f * k.rng.uniform();
        k.rod(iron, {x, rail, off + 0.008f}, {x, down, off + 0.008f}, 0.004f, -1, 6);
        // Its open side to the wall: one sees the polished bottom.
        const Vec3f middle{x, down - long_ - r, 0};
        k.rod(metal, {x, down + 0.004f, off - 0.01f}, {middle.x, middle.y + 0.96f * r, off - 0.006f}, 0.008f, 0.011f,
              8);
        const std::array<Vec2f, 5> bowl{
            Vec2f{0.78f * r, 0.f}, {0.9f * r, 0.006f}, {0.97f * r, 0.02f}, {r, deep}, {r + 0.004f, deep + 0.004f}};
        Mesh pan = shapes::vessel(bowl, 0.004f, 28);
        shapes::turn(pan, {1, 0, 0}, -90);
        k.add(std::move(pan), metal, {middle.x, middle.y, deep + 0.012f});
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.32f;
}

}  // namespace fastscene::furniture
