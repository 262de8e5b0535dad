// An axis-aligned box mesh; its pattern is evaluated at world positions.
#pragma once

#include <array>
#include <cstdint>

#include "fastscene/scene/room.h"

namespace fastscene {

// Closed, with outward normals; `inward` flips them, for the inside of an empty room.
inline Mesh box_mesh(Vec3f low, Vec3f high, int material, int object = -1, bool inward = false) {
    Mesh mesh;
    mesh.material = material;
    mesh.object = object;
    for (std::size_t a = 0; a < 3; ++a)
        for (int side = 0; side < 2; ++side) {
            const std::size_t u = (a + 1) % 3, v = (a + 2) % 3;
            Vec3f normal{};
            normal[a] = (side ? 1.f : -1.f) * (inward ? -1.f : 1.f);
            const auto base = static_cast<std::uint32_t>(mesh.positions.size());
            for (int corner = 0; corner < 4; ++corner) {
                Vec3f p;
                p[a] = side ? high[a] : low[a];
                p[u] = corner == 1 || corner == 2 ? high[u] : low[u];
                p[v] = corner >= 2 ? high[v] : low[v];
                mesh.positions.push_back(p);
                mesh.coords.push_back(p);
                mesh.normals.push_back(normal);
            }
            const bool turned = (side == 1) == inward;
            for (const std::uint32_t i : turned ? std::array<std::uint32_t, 6>{0, 2, 1, 0, 3, 2}
                                                : std::array<std::uint32_t, 6>{0, 1, 2, 0, 2, 3})
                mesh.triangles.push_back(base + i);
        }
    return mesh;
}

}  // namespace fastscene
