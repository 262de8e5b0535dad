// Hanging plant.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/plants/foliage.h"

namespace fastscene::furniture {

// A pot in a net of cords under the ceiling: vines with leaves hang from it, or fronds arch out.
void build_hanging_plant(Kit& k) {
    const float size = k.request.size_factor,
                drop = (k.request.size_m.y > 0.5f ? 0.62f * k.request.size_m.y : 0.82f * size);
    k.sized = true;
    const bool trailing = k.request.pattern == "trailing" || (k.request.pattern != "fern" && k.rng.chance(0.7f));
    const int green = k.main(foliage(k, trailing ? Vec3f{0.08f, 0.19f, 0.055f} : Vec3f{0.1f, 0.23f, 0.07f}, 0.05f)),
              stem = k.material(plain("stem", {0.09f, 0.15f, 0.05f}, 0.8f)),
              soil = k.material(plain("soil", {0.06f, 0.042f, 0.03f}, 0.95f)),
              cord = k.material(plain("cotton cord", {0.66f, 0.6f, 0.47f}, 0.95f)), metal = k.material(k.style.metal);
    Material clay = plain("plant pot", k.rng.chance(0.5f) ? Vec3f{0.7f, 0.68f, 0.63f} : Vec3f{0.46f, 0.21f, 0.12f},
                          0.6f);
    if (k.style.plants > 0.8f && k.rng.chance(0.4f)) clay = *material_named("wicker");
    const float r = 0.115f * size, high = 0.15f * size, base = -drop - high, rim = -drop;
    const std::array<Vec2f, 6> p{Vec2f{0.5f * r, 0}, {0.62f * r, 0.006f},      {0.88f * r, 0.3f * high},
                                 {r, 0.65f * high},  {0.99f * r, 0.9f * high}, {0.96f * r, high}};
    k.add(shapes::vessel(shapes::curve(p, 2), 0.007f, 32), k.material(clay), {0, base, 0});
    k.add(shapes::prism(shapes::circle(0.86f * r, 24), -0.03f, -0.018f), soil, {0, rim, 0});
    k.add(shapes::prism(shapes::circle(0.025f, 20), -0.012f, 0.f, 0.003f), metal);
    k.rod(metal, {0, -0.05f, 0}, {0, -0.008f, 0}, 0.003f, -1, 6);
    // Four cords from a knot, apart about the pot, together below it.
    const Vec3f knot{0, -drop + 0.42f * drop + 0.06f, 0};
    k.rod(cord, knot, {0, -0.04f, 0}, 0.006f, -1, 8);
    k.add(shapes::ball(knot, {0.013f, 0.017f, 0.013f}, 12), cord);
    for (int i = 0; i < 4; ++i) {
        const Vec3f out = around(1.5708f * static_cast<float>(i) + 0.4f);
        const std::array<Vec3f, 6> path{knot,
                                        out * (0.7f * r) + Vec3f{0, 0.5f * (knot.y + rim), 0},
                                        out * (1.03f * r) + Vec3f{0, rim, 0},
                                        out * (1.05f * r) + Vec3f{0, base + 0.62f * high, 0},
                                        out * (0.7f * r) + Vec3f{0, base - 0.002f, 0},
                                        Vec3f{0, base - 0.03f, 0}};
        k.add(shapes::tube(path, 0.0035f, 6), cord);
        k.add(shapes::ball(path[3], {0.009f, 0.011f, 0.009f}, 8), cord);
    }
    k.add(shapes::ball({0, base - 0.032f, 0}, {0.013f, 0.016f, 0.013f}, 12), cord);
    for (int i = 0; i < 7; ++i) {
        const float a = 0.9f * static_cast<float>(i), x = 0.008f * std::cos(a), z = 0.008f * std::sin(a);
        k.rod(cord, {x, base - 0.04f, z}, {2.2f * x, base - 0.12f, 2.2f * z}, 0.0026f, -1, 5);
    }
    if (!trailing) {
        for (int i = 0; i < 46; ++i) {
            const float a = 2.39996f * static_cast<float>(i), t = static_cast<float>(i) / 46.f;
            k.add(blade(around(a) * (0.3f * r) + Vec3f{0, rim - 0.02f, 0}, around(a), size * (0.36f - 0.14f * t),
                        0.03f * size, 0.75f + 1.5f * t, 1.65f - 0.3f * t, 0.7f),
                  green);
        }
        k.piece.mount = Mount::ceiling;
        return;
    }
    Mesh stems;
    const int vines = 11;
    for (int i = 0; i < vines; ++i) {
        const float a = 2.39996f * static_cast<float>(i), length = size * k.rng.uniform(0.22f, 0.62f),
                    swing = k.rng.uniform(0.6f, 1.f);
        const Vec3f out = around(a), side{-out.z, 0, out.x};
        // Over the rim, then straight down, a little wavy.
        const float phase = k.rng.uniform(0, kTau);
        const auto vine = [&](float t) {
            const float over = std::min(1.f, t / 0.18f), down = std::max(0.f, t - 0.12f) / 0.88f;
            return out * (r * (0.45f + (0.62f + 0.12f * swing) * over) + 0.012f * std::sin(6.f * t + phase)) +
                   side * (0.018f * std::sin(5.f * t + 2.f * phase)) +
                   Vec3f{0, rim - 0.015f + 0.05f * std::sin(kPi * std::min(1.f, t / 0.26f)) - length * down, 0};
        };
        std::vector<Vec3f> path;
        for (int j = 0; j <= 14; ++j) path.push_back(vine(static_cast<float>(j) / 14.f));
        shapes::append(stems, shapes::tube(path, 0.0022f, 5));
        const int leaves = 4 + static_cast<int>(length / 0.036f);
        for (int j = 0; j < leaves; ++j) {
            const float t = (static_cast<float>(j) + 0.4f) / static_cast<float>(leaves),
                        la = a + (j % 2 ? 1.1f : -1.1f) + k.rng.uniform(-0.5f, 0.5f),
                        l = size * k.rng.uniform(0.04f, 0.062f) * (1.15f - 0.45f * t);
            k.add(blade(vine(t), around(la), l, 0.8f * l, k.rng.uniform(-0.1f, 0.35f), 0.9f, 0.62f), green);
        }
    }
    // A tuft where they come from.
    for (int i = 0; i < 16; ++i) {
        const float a = 2.39996f * static_cast<float>(i) + 0.3f;
        k.add(blade(around(a) * (0.2f * r) + Vec3f{0, rim - 0.015f, 0}, around(a), size * k.rng.uniform(0.07f, 0.11f),
                    0.055f * size, k.rng.uniform(0.6f, 1.6f), 0.8f, 0.62f),
              green);
    }
    k.add(std::move(stems), stem);
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
