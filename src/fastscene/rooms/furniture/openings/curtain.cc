// Curtain.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_curtain(Kit& k) {
    // size.x: the rod's width; size.y: from the floor to the rod.
    const Vec3f s = k.wanted({2.0f, 2.4f, 0.12f});
    const int cloth = k.main(k.style.curtain), metal = k.material(k.style.metal);
    // Deeply dyed cloth lets less through than a white veil: in the sun red would glow pink.
    constexpr float kVeil = 0.5f, kLeast = 0.15f;  // luminance of a veil's albedo; share that the darkest dye leaves
    Material& dyed = k.piece.materials[static_cast<std::size_t>(cloth)];
    dyed.transmission *= std::clamp(luminance(dyed.color_a) / kVeil, kLeast, 1.f);
    const float w = std::min(0.3f * s.x, 0.62f), h = s.y - 0.03f;
    for (const float sx : {-1.f, 1.f}) {
        const std::uint32_t seed = k.seed();
        const float folds = std::round(w / 0.085f);
        k.add(shapes::sheet(96, 18,
                            [=](float u, float v) {
                                const float drape = 1.f - v,
                                            wave = std::sin(kTau * folds * u +
                                                            0.9f * shapes::wobble({u * 4.f, v * 1.5f, 1.f}, seed));
                                const float spread = 0.92f + 0.08f * drape;
                                return Vec3f{sx * (0.5f * s.x - 0.02f) - sx * w * (sx > 0 ? 1.f - u : u) * spread,
                                             h * v + 0.006f,
                                             0.06f + (0.026f + 0.016f * drape) * wave +
                                                 0.006f * shapes::wobble({u * 9.f, v * 3.f, 4.f}, seed)};
                            }),
              cloth);
    }
    k.rod(metal, {-0.5f * s.x, s.y - 0.015f, 0.06f}, {0.5f * s.x, s.y - 0.015f, 0.06f}, 0.012f, -1, 16);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(metal, {sx * (0.5f * s.x - 0.06f), s.y - 0.015f, 0.f}, {sx * (0.5f * s.x - 0.06f), s.y - 0.015f, 0.06f},
              0.008f);
        k.add(shapes::ball({sx * (0.5f * s.x - 0.004f), s.y - 0.022f, 0.06f}, {0.022f, 0.022f, 0.022f}, 14), metal);
    }
    k.piece.mount = Mount::wall;
}

}  // namespace fastscene::furniture
