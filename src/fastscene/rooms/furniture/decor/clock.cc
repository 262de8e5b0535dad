// Clock.
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_clock(Kit& k) {
    const int rim = k.main(k.style.metal), face = k.material(plain("dial", {0.76f, 0.74f, 0.69f}, 0.6f)),
              dark = k.material(plain("clock hands", {0.035f, 0.035f, 0.035f}, 0.5f));
    const auto flat = [&](Mesh m, int mat, Vec3f at) { k.add(std::move(shapes::turn(m, {1, 0, 0}, 90)), mat, at); };
    flat(shapes::prism(shapes::circle(0.18f, 48), 0.f, 0.02f), face, {0, 0.2f, 0});
    flat(shapes::ring(0.185f, 0.03f, 48), rim, {0, 0.2f, 0.015f});
    for (int i = 0; i < 12; ++i) {
        const float a = kTau * static_cast<float>(i) / 12.f;
        Mesh m = shapes::box({0.006f, i % 3 == 0 ? 0.03f : 0.016f, 0.002f}, 0.0005f);
        shapes::move(m, {0, 0.15f, 0.021f});
        k.add(shapes::turn(m, {0, 0, 1}, a * 57.29578f), dark, {0, 0.2f, 0});
    }
    for (int i = 0; i < 2; ++i) {
        Mesh m = shapes::box({0.008f, i == 0 ? 0.1f : 0.14f, 0.002f}, 0.0005f);
        shapes::move(m, {0, i == 0 ? 0.04f : 0.06f, 0.023f + 0.002f * static_cast<float>(i)});
        k.add(shapes::turn(m, {0, 0, 1}, k.rng.uniform(0, 360)), dark, {0, 0.2f, 0});
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.7f;
}

}  // namespace fastscene::furniture
