// Cobweb.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Threads across a corner under the ceiling: spokes from the corner, and arcs that sag between them. Its walls are at
// -x and -z.
void build_cobweb(Kit& k) {
    const int silk = k.main(plain("cobweb", {0.62f, 0.61f, 0.58f}, 0.95f));
    const float size = 0.62f;
    const Vec3f corner{0, 0, 0};
    // Where spokes end: along the wall's upper edges and down the corner.
    std::vector<Vec3f> ends;
    for (const float t : {0.f, 0.25f, 0.5f, 0.75f, 1.f})
        ends.push_back(
            Vec3f{size * (1 - t), -0.01f - 0.9f * size * t * (0.3f + 0.7f * t), 0.012f + 0.1f * t * (1 - t)});
    for (const float t : {0.25f, 0.5f, 0.75f, 1.f})
        ends.push_back(
            Vec3f{0.012f + 0.1f * t * (1 - t), -0.01f - 0.9f * size * (1 - t) * (0.3f + 0.7f * (1 - t)), size * t});
    for (const Vec3f& end : ends) k.rod(silk, corner - Vec3f{0, 0.004f, 0}, end, 0.0022f, -1, 5);
    Mesh arcs;
    for (int ring = 1; ring <= 9; ++ring) {
        const float far = 0.1f + 0.1f * static_cast<float>(ring);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            if (k.rng.chance(0.12f)) continue;  // torn
            const Vec3f a = ends[i] * far, b = ends[i + 1] * far, sag = (a + b) * 0.5f * 0.86f;
            const std::array<Vec3f, 4> path{a, lerp(a, sag, 0.75f), lerp(b, sag, 0.75f), b};
            shapes::append(arcs, shapes::tube(path, 0.0018f, 4));
        }
    }
    // Next to the corner it is so old that dust has made a film of it, torn at its edge.
    Material film = plain("dusty web", {0.5f, 0.49f, 0.46f}, 0.95f);
    film.transmission = 0.5f;
    const std::uint32_t seed = k.seed();
    k.add(shapes::slab(24, 4, 0.001f,
                       [&](float u, float v) {
                           const float at = u * static_cast<float>(ends.size() - 1),
                                       far = (0.66f + 0.14f * shapes::wobble({u * 11, 0, 0}, seed)) *
                                             (0.04f + 0.96f * v);
                           const auto i = std::min(static_cast<std::size_t>(at), ends.size() - 2);
                           return lerp(ends[i], ends[i + 1], at - static_cast<float>(i)) *
                                  (far * (1.f - 0.05f * std::sin(kPi * (at - std::floor(at)))));
                       }),
          k.material(film));
    // A few that hang down, with dust on them.
    for (int i = 0; i < 5; ++i) {
        const Vec3f from = ends[static_cast<std::size_t>(k.rng.index(static_cast<int>(ends.size())))] *
                           k.rng.uniform(0.5f, 0.95f);
        const std::array<Vec3f, 3> path{from, from + Vec3f{0.01f, -0.09f, 0.006f},
                                        from + Vec3f{0.004f, -k.rng.uniform(0.14f, 0.24f), 0.012f}};
        shapes::append(arcs, shapes::tube(path, 0.0018f, 4));
    }
    k.add(std::move(arcs), silk);
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
