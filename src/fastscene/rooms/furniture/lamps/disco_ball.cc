// Disco ball.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Small mirrors on a ball, on a rod from the ceiling.
void build_disco_ball(Kit& k) {
    const float r = 0.19f * k.request.size_factor,
                drop = k.request.size_m.y > 0.4f ? k.request.size_m.y : 0.75f * k.request.size_factor;
    k.sized = true;
    Material silvered = plain("mirror tiles", {0.82f, 0.83f, 0.85f}, 0.05f);
    silvered.mirror = 0.92f;
    const int mirror = k.main(silvered), metal = k.material(steel()),
              joint = k.material(plain("grout", {0.12f, 0.12f, 0.13f}, 0.6f));
    const Vec3f center{0, -drop + r, 0};
    k.add(shapes::ball(center, {0.985f * r, 0.985f * r, 0.985f * r}, 32), joint);
    k.rod(metal, center + Vec3f{0, 0.97f * r, 0}, center + Vec3f{0, r + 0.03f, 0}, 0.02f, -1, 16);
    k.rod(metal, center + Vec3f{0, r, 0}, {0, -0.02f, 0}, 0.004f, -1, 8);
    k.add(shapes::prism(shapes::circle(0.045f, 24), -0.03f, 0.f, 0.004f), metal);
    // Flat tiles in rings, each turned a hair off the ball's own slope as tiles are.
    Mesh tiles;
    constexpr int kRows = 26;
    const float tile = kPi * r / kRows;
    for (int row = 0; row < kRows; ++row) {
        const float lat = kPi * ((static_cast<float>(row) + 0.5f) / kRows - 0.5f);
        const int count = std::max(3, static_cast<int>(std::round(kTau * r * std::cos(lat) / tile)));
        for (int i = 0; i < count; ++i) {
            const float lon = kTau * (static_cast<float>(i) + 0.5f * static_cast<float>(row % 2)) /
                              static_cast<float>(count);
            const Vec3f n{std::cos(lat) * std::cos(lon), std::sin(lat), std::cos(lat) * std::sin(lon)},
                east{-std::sin(lon), 0, std::cos(lon)}, north = cross(east, n);
            const Vec3f up = dot(north, Vec3f{0, 1, 0}) < 0 ? -north : north;
            const float wide = 0.46f * std::min(tile, kTau * r * std::cos(lat) / static_cast<float>(count)),
                        high = 0.46f * tile;
            const Vec3f lean = normalize(n + east * k.rng.uniform(-0.025f, 0.025f) +
                                         up * k.rng.uniform(-0.025f, 0.025f));
            const auto first = static_cast<std::uint32_t>(tiles.positions.size());
            for (const Vec2f c : {Vec2f{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
                const Vec3f p = n * r + east * (c.x * wide) + up * (c.y * high);
                tiles.positions.push_back(center + p - n * dot(p - n * r, lean));
                tiles.normals.push_back(lean);
            }
            const bool turned = dot(cross(east, up), n) < 0;
            tiles.triangles.insert(tiles.triangles.end(),
                                   {first, first + (turned ? 2u : 1u), first + (turned ? 1u : 2u), first,
                                    first + (turned ? 3u : 2u), first + (turned ? 2u : 3u)});
        }
    }
    shapes::lay_grain(tiles);
    k.add(std::move(tiles), mirror);
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
