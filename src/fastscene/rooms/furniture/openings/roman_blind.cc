// Roman blind.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/openings/blind_parts.h"

namespace fastscene::furniture {

// Cloth drawn up in soft folds over rods.
void build_roman_blind(Kit& k) {
    const Vec3f s = k.wanted(kUsualWindow);
    Material linen = k.style.fabric;
    linen.color_a = lerp(k.style.curtain.color_a, k.style.fabric2.color_a,
                         k.style.mouldings == Mouldings::rich ? 0.8f : 0.3f);
    linen.color_b = linen.color_a * 0.85f;
    const int cloth = blind_cloth(k, linen, 0.24f), metal = k.material(plain("blind rail", {0.7f, 0.69f, 0.66f}, 0.5f));
    const float w = s.x - 0.006f, share = drawn(k, 0.38f, 0.56f), low = s.y * (1.f - share), z = 0.02f, fold = 0.2f;
    k.board(metal, {0, s.y - 0.03f, 0.014f}, {w, 0.03f, 0.028f}, 0.003f);
    // From the top down: flat fields with a slight belly between rods, then the folds that lie before each other.
    std::vector<Vec2f> profile;  // z, y
    const float gathered = low + 0.13f;
    const int fields = std::max(1, static_cast<int>(std::lround((s.y - gathered) / fold)));
    const float field = (s.y - gathered) / static_cast<float>(fields);
    for (int i = 0; i < fields; ++i)
        for (int j = 0; j < 6; ++j) {
            const float t = static_cast<float>(j) / 6.f;
            profile.push_back({z + 0.011f * std::sin(kPi * t) * (0.5f + 0.5f * t),
                               s.y - 0.004f - field * (static_cast<float>(i) + t)});
        }
    profile.push_back({z, gathered});
    profile.push_back({z + 0.004f, low + 0.03f});
    const std::uint32_t seed = k.seed();
    const int rows = static_cast<int>(profile.size()) - 1;
    Mesh m = shapes::sheet(24, rows, [&](float u, float v) {
        const Vec2f p = profile[static_cast<std::size_t>(std::lround((1.f - v) * static_cast<float>(rows)))];
        return Vec3f{w * (u - 0.5f), p.y, p.x + 0.0025f * shapes::wobble({u * 5.f, p.y * 6.f, 0}, seed)};
    });
    for (std::size_t i = 0; i < m.coords.size(); ++i) m.coords[i] = {m.positions[i].x, m.positions[i].y, 0};
    k.add(std::move(m), cloth);
    // What is drawn up: loops of cloth before each other, each hanging a little lower.
    constexpr int kFolds = 3;
    for (int i = 0; i < kFolds; ++i) {
        const float half = 0.05f + 0.008f * static_cast<float>(i),
                    y = low + 0.012f * static_cast<float>(kFolds - 1 - i) + half,
                    out = z + 0.012f + 0.012f * static_cast<float>(i);
        Mesh loop = shapes::sheet(20, 14, [&](float u, float v) {
            const float a = -kTau * v, x = (w - 0.002f) * (u - 0.5f);
            // Thicker where the cloth turns, below.
            return Vec3f{x, y + half * std::cos(a) + 0.002f * shapes::wobble({6 * x, static_cast<float>(i), 2}, seed),
                         out + (0.005f - 0.0022f * std::cos(a)) * std::sin(a) * -1.f};
        });
        for (std::size_t j = 0; j < loop.coords.size(); ++j)
            loop.coords[j] = {loop.positions[j].x, loop.positions[j].y, 0};
        k.add(std::move(loop), cloth);
    }
    k.piece.mount = Mount::wall;
}

}  // namespace fastscene::furniture
