// Pot rack.
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A frame on four chains with pots and pans around it.
void build_pot_rack(Kit& k) {
    const int metal = k.main(*material_named("copper")),
              iron = k.material(plain("wrought iron", {0.035f, 0.034f, 0.033f}, 0.5f));
    const float hx = 0.45f, hz = 0.2f, rail = -0.62f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) {
            k.rod(iron, {sx * hx * 0.8f, rail, sz * hz}, {sx * hx * 0.62f, -0.01f, sz * hz * 0.4f}, 0.004f, -1, 8);
            k.add(shapes::prism(shapes::circle(0.02f, 16), -0.012f, 0.f), iron, {sx * hx * 0.62f, 0, sz * hz * 0.4f});
        }
    for (const float sz : {-1.f, 1.f}) k.rod(iron, {-hx, rail, sz * hz}, {hx, rail, sz * hz}, 0.01f, -1, 12);
    for (int i = -2; i <= 2; ++i)
        k.rod(iron, {0.5f * hx * static_cast<float>(i), rail, -hz}, {0.5f * hx * static_cast<float>(i), rail, hz},
              i == -2 || i == 2 ? 0.01f : 0.005f, -1, 10);
    for (const float sz : {-1.f, 1.f})
        for (int i = 0; i < 4; ++i) {
            const float x = (static_cast<float>(i) - 1.5f) * 0.225f + 0.02f * sz,
                        r = std::array{0.082f, 0.07f, 0.092f, 0.064f}[static_cast<std::size_t>(sz > 0 ? i : 3 - i)] *
                            k.rng.uniform(0.94f, 1.05f),
                        deep = i % 2 == 0 ? 0.045f : 0.08f;
            const float handle = 0.13f + 0.05f * k.rng.uniform(), middle = rail - 0.05f - handle - r;
            k.rod(iron, {x, rail - 0.004f, sz * hz}, {x, rail - 0.05f, sz * hz}, 0.004f, -1, 6);
            k.rod(metal, {x, rail - 0.045f, sz * hz}, {x, middle + 0.95f * r, sz * hz}, 0.008f, 0.01f, 8);
            // Its polished bottom to the outside.
            const std::array<Vec2f, 5> bowl{
                Vec2f{0.78f * r, 0.f}, {0.9f * r, 0.006f}, {0.97f * r, 0.02f}, {r, deep}, {r + 0.004f, deep + 0.004f}};
            Mesh pan = shapes::vessel(bowl, 0.004f, 28);
            shapes::turn(pan, {1, 0, 0}, sz > 0 ? -90.f : 90.f);
            k.add(std::move(pan), metal, {x, middle, sz * (hz + 0.5f * deep)});
        }
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
