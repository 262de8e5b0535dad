// Garland.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/decor/bows.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/plants/foliage.h"

namespace fastscene::furniture {

// Twigs along a cord in two bows, the ends hanging down; red berries among them.
void build_garland(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 0.5f, 0.12f});
    const int leaf = k.main(foliage(k, {0.07f, 0.16f, 0.06f}, 0.03f)),
              pale = k.material(foliage(k, {0.13f, 0.2f, 0.11f}, 0.03f)),
              cord = k.material(plain("twig", {0.16f, 0.1f, 0.055f}, 0.9f)),
              berry = k.material(plain("berry", {0.42f, 0.025f, 0.02f}, 0.25f));
    std::vector<Vec3f> path;
    const float top = s.y - 0.06f, half = 0.5f * s.x - 0.05f;
    for (int i = 0; i <= 5; ++i) path.push_back({-half, 0.06f + (top - 0.06f) * static_cast<float>(i) / 6.f, 0.05f});
    for (int i = 0; i <= 32; ++i)
        path.push_back(on_bows(static_cast<float>(i) / 32.f, 2, 2 * half, top, 0.34f * s.y) + Vec3f{0, 0, 0.05f});
    for (int i = 5; i >= 0; --i) path.push_back({half, 0.06f + (top - 0.06f) * static_cast<float>(i) / 6.f, 0.05f});
    k.add(shapes::tube(path, 0.006f, 6), cord);
    std::array<Mesh, 2> leaves;
    Mesh berries;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const Vec3f along = normalize(path[i + 1] - path[i]);
        const int many = std::max(3, static_cast<int>(length(path[i + 1] - path[i]) / 0.0082f));
        for (int j = 0; j < many; ++j) {
            const Vec3f at = lerp(path[i], path[i + 1], k.rng.uniform());
            // A leaf is made lying along +x and put where it grows: out and along the cord.
            const float spin = k.rng.uniform(-1.75f, 1.75f), size = k.rng.uniform(0.05f, 0.085f);
            const Vec3f side = std::abs(along.y) < 0.9f ? normalize(cross(along, Vec3f{0, 0, 1})) : Vec3f{1, 0, 0};
            const Vec3f out = normalize(side * std::sin(spin) + Vec3f{0, 0, 1} * std::cos(spin) +
                                        along * k.rng.uniform(0.4f, 1.1f));
            const Vec3f wide = normalize(cross(out, std::abs(out.z) < 0.9f ? Vec3f{0, 0, 1} : Vec3f{0, 1, 0})),
                        up = cross(wide, out);
            Mesh m = blade({0, 0, 0}, {1, 0, 0}, size, 0.3f * size, 0.1f, 0.25f, 0.8f);
            for (Vec3f& p : m.positions) {
                const Vec3f q = p;
                p = at + out * q.x + up * q.y + wide * q.z;
                p.z = std::max(p.z, 0.002f);
            }
            shapes::smooth_normals(m);
            shapes::append(leaves[static_cast<std::size_t>(j % 3 == 0)], m);
        }
        if (i % 2 == 0)
            for (int j = 0; j < 2; ++j)
                shapes::append(berries,
                               shapes::ball(path[i] + Vec3f{k.rng.uniform(-0.02f, 0.02f), k.rng.uniform(-0.025f, 0.02f),
                                                            0.025f + k.rng.uniform(0.f, 0.015f)},
                                            {0.009f, 0.009f, 0.009f}, 6));
    }
    k.add(std::move(leaves[0]), leaf);
    k.add(std::move(leaves[1]), pale);
    k.add(std::move(berries), berry);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.6f;
}

}  // namespace fastscene::furniture
