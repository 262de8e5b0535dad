// Trunk.
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/storage/carcass.h"

namespace fastscene::furniture {

// A chest with a rounded lid, bound with iron, a lock in front.
void build_trunk(Kit& k) {
    const Vec3f s = k.wanted({0.85f, 0.52f, 0.48f});
    const int wood = k.main(*material_named("walnut"));
    Material iron = k.style.metal;
    if (luminance(iron.color_a) > 0.3f) iron = tinted(iron, {0.3f, 0.21f, 0.09f});
    const int band = k.material(iron);
    const float low = 0.62f * s.y, rise = s.y - low - 0.006f, half = 0.5f * s.z;
    k.board(wood, {}, {s.x, low - 0.004f, s.z}, 0.008f);
    // The lid: a low arch from front to back.
    const auto arch = [&](float x, float width, float grow, int material) {
        std::vector<Vec2f> outline;
        for (int i = 0; i <= 16; ++i) {
            const float a = kPi * static_cast<float>(i) / 16.f;
            outline.push_back({(half + grow) * std::cos(a), (rise + grow) * std::sin(a)});
        }
        Mesh m = shapes::prism(outline, -0.5f * width, 0.5f * width, 0.004f);
        // (x, y, z) of the prism: depth, width, height.
        for (auto* list : {&m.positions, &m.normals})
            for (Vec3f& v : *list) v = {v.y, v.z, v.x};
        k.add(std::move(m), material, {x, low, 0});
    };
    arch(0, s.x, 0.f, wood);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * s.x - 0.1f);
        k.board(band, {x, 0, 0}, {0.05f, low, s.z + 0.01f}, 0.003f);
        arch(x, 0.05f, 0.005f, band);
        k.rod(band, {sx * (0.5f * s.x + 0.008f), 0.55f * low, -0.06f}, {sx * (0.5f * s.x + 0.008f), 0.55f * low, 0.06f},
              0.008f, -1, 10);
    }
    k.board(band, {0, low - 0.09f, half + 0.003f}, {0.11f, 0.13f, 0.012f}, 0.003f);
    k.add(shapes::ball({0, low - 0.03f, half + 0.01f}, {0.016f, 0.016f, 0.01f}, 12),
          k.material(plain("keyhole", {0.03f, 0.028f, 0.025f}, 0.6f)));
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.3f;
}

}  // namespace fastscene::furniture
