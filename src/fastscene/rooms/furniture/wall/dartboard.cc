// Dartboard.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Twenty fields in two colors, rings and bull, three darts in it.
void build_dartboard(Kit& k) {
    const float r = 0.17f, rim = 0.2255f;
    const int board = k.main(plain("dartboard", {0.035f, 0.034f, 0.033f}, 0.85f)),
              cream = k.material(plain("sisal", {0.6f, 0.5f, 0.32f}, 0.9f)),
              black = k.material(plain("black sisal", {0.04f, 0.038f, 0.036f}, 0.9f)),
              red = k.material(plain("red sisal", {0.45f, 0.03f, 0.03f}, 0.9f)),
              green = k.material(plain("green sisal", {0.02f, 0.2f, 0.07f}, 0.9f)), wire = k.material(steel());
    Mesh disc = shapes::prism(shapes::circle(rim, 60), 0.f, 0.038f, 0.005f);
    shapes::turn(disc, {1, 0, 0}, 90);
    k.add(std::move(disc), board);
    const float z = 0.0385f;
    const std::array<float, 7> rings{0.f, 0.0065f, 0.016f, 0.099f, 0.107f, 0.162f, r};
    for (int i = 0; i < 20; ++i)
        for (std::size_t j = 0; j < 6; ++j) {
            const bool odd = i % 2 != 0, scoring = j == 3 || j == 5;
            const int material = j == 0 ? red : j == 1 ? green : scoring ? (odd ? green : red) : (odd ? cream : black);
            k.add(shapes::sheet(3, 1,
                                [&](float u, float v) {
                                    const float a = kTau * (static_cast<float>(i) - 0.5f + u) / 20.f,
                                                d = std::max(0.0005f, std::lerp(rings[j + 1], rings[j], v));
                                    return Vec3f{-d * std::sin(a), d * std::cos(a), z};
                                }),
                  material);
        }
    for (const float d : {0.0065f, 0.016f, 0.099f, 0.107f, 0.162f, 0.17f, 0.2f}) {
        Mesh m = shapes::ring(d, 0.0014f, 40);
        k.add(std::move(shapes::turn(m, {1, 0, 0}, 90)), wire, {0, 0, z});
    }
    for (int i = 0; i < 3; ++i) {
        const float a = k.rng.uniform(0, kTau), d = k.rng.uniform(0.02f, 0.11f);
        const Vec3f at{d * std::cos(a), d * std::sin(a), z},
            back = at + Vec3f{k.rng.uniform(-0.012f, 0.012f), 0.012f, 0.085f}, out = normalize(back - at);
        k.rod(wire, at, at + out * 0.03f, 0.0012f, -1, 6);
        k.rod(wire, at + out * 0.025f, at + out * 0.07f, 0.0036f, -1, 10);
        k.rod(black, at + out * 0.07f, back + out * 0.02f, 0.002f, -1, 8);
        for (const float turn : {0.f, 90.f}) {
            Mesh flight = shapes::box({0.03f, 0.001f, 0.03f}, 0.0003f);
            shapes::turn(flight, {0, 0, 1}, turn + 45.f);
            k.add(std::move(flight), red, back + out * 0.02f);
        }
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.5f;
}

}  // namespace fastscene::furniture
