// Bunting.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/decor/bows.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Pennants on a cord, in two bows along a wall. In one color that was said they alternate with white.
void build_bunting(Kit& k) {
    const Vec3f s = k.wanted({2.4f, 0.42f, 0.02f});
    const bool said = k.request.color || !k.request.color_name.empty();
    static constexpr std::array<Vec3f, 5> kMerry{{{0.5f, 0.05f, 0.045f},
                                                  {0.62f, 0.42f, 0.06f},
                                                  {0.06f, 0.26f, 0.34f},
                                                  {0.2f, 0.36f, 0.12f},
                                                  {0.58f, 0.24f, 0.2f}}};
    Material first = k.style.fabric;
    first.color_a = kMerry[0], first.color_b = kMerry[0] * 0.8f, first.color_c = kMerry[0];
    std::vector<int> cloth{k.main(first)};
    const auto dye = [&](Vec3f color) {
        Material m = k.style.fabric;
        m.color_a = color, m.color_b = color * 0.8f, m.color_c = color;
        cloth.push_back(k.material(m));
    };
    if (!k.request.color2_name.empty()) dye(*color_named(k.request.color2_name));
    else if (said) dye({0.74f, 0.72f, 0.67f});
    else
        for (std::size_t i = 1; i < kMerry.size(); ++i) dye(kMerry[i]);
    const int cord = k.material(plain("cord", {0.66f, 0.62f, 0.52f}, 0.9f));
    constexpr int kBows = 2;
    const int flags = 2 * std::max(3, static_cast<int>(s.x / 0.36f));
    const float sag = 0.5f * s.y, high = 0.48f * s.y, wide = 0.82f * s.x / static_cast<float>(flags);
    std::vector<Vec3f> path;
    for (int i = 0; i <= 40; ++i)
        path.push_back(on_bows(static_cast<float>(i) / 40.f, kBows, s.x, s.y, sag) + Vec3f{0, 0, 0.008f});
    k.add(shapes::tube(path, 0.004f, 6), cord);
    for (int i = 0; i < flags; ++i) {
        const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(flags), half = 0.5f * wide / s.x,
                    flutter = k.rng.uniform(-0.008f, 0.008f);
        const Vec3f a = on_bows(t - half, kBows, s.x, s.y, sag), b = on_bows(t + half, kBows, s.x, s.y, sag),
                    tip = (a + b) * 0.5f - Vec3f{0, high, 0};
        k.add(shapes::slab(6, 6, 0.002f,
                           [=](float u, float v) {
                               return lerp(lerp(a, b, u), tip, 0.985f * v) +
                                      Vec3f{0, 0, 0.012f + flutter * v * std::sin(3.f * u + 1.f)};
                           }),
              cloth[static_cast<std::size_t>(i) % cloth.size()]);
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.85f;
}

}  // namespace fastscene::furniture
