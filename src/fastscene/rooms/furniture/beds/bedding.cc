// Cloth over a mattress.
#include "fastscene/rooms/furniture/beds/bedding.h"

#include <algorithm>
#include <cmath>

namespace fastscene::furniture {

// Cloth over a mattress: flat on top, hanging at the sides, with folds.
Mesh blanket(Vec3f mattress, float drop, float from_z, float to_z, float lift, float thick, std::uint32_t seed,
             float fold) {
    const float hx = 0.5f * mattress.x + 0.02f + lift;
    Mesh cloth = shapes::slab(44, 30, thick, [=](float u, float v) {
        const float arc = (u - 0.5f) * 2.f * (hx + drop), z = from_z + (to_z - from_z) * v;
        const float over = std::max(0.f, std::fabs(arc) - hx + 0.05f), sx = arc < 0 ? -1.f : 1.f;
        const float bend = std::min(over / 0.1f, 1.f), hang = std::max(0.f, over - 0.1f * 0.6f);
        const float ripple = shapes::wobble({arc * 3.f, 2.f, z * 3.1f}, seed) +
                             0.5f * shapes::wobble({arc * 7.f, 5.f, z * 7.5f}, seed + 1) +
                             0.22f * shapes::wobble({arc * 15.f, 8.f, z * 15.f}, seed + 2);
        const float wave = std::sin(z * 15.f + 2.f * shapes::wobble({z * 2.f, sx, 0}, seed + 3));
        float x = std::fabs(arc) < hx - 0.05f ? arc
                                              : sx * (hx - 0.05f + 0.05f * std::sin(1.5708f * bend) +
                                                      0.025f * hang / std::max(drop, 0.01f) * (1.f + wave));
        float y = mattress.y + lift + thick - 0.05f * (1.f - std::cos(1.5708f * bend)) - hang +
                  fold * (1.f + 0.6f * ripple) * (1.f - 0.7f * bend);
        // The foot end hangs too.
        const float past = z - 0.5f * mattress.z;
        if (past > 0.f) {
            y -= std::max(past - hang, 0.f);  // at the corner the longer of both falls
            return Vec3f{x, y, 0.5f * mattress.z + 0.03f + lift + 0.012f * (1.f + std::sin(arc * 14.f))};
        }
        return Vec3f{x, std::max(y, 0.06f), z};
    });
    // Stripes run from side to side, whatever the folds.
    for (std::size_t i = 0; i < cloth.positions.size(); ++i)
        cloth.coords[i] = {cloth.positions[i].z, cloth.positions[i].x, cloth.positions[i].y};
    return cloth;
}

}  // namespace fastscene::furniture
