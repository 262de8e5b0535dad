// Roller blind.
#include <utility>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/openings/blind_parts.h"

namespace fastscene::furniture {

// A cloth from a roller, with a bar in its hem; of bamboo, canes side by side.
void build_roller_blind(Kit& k) {
    const Vec3f s = k.wanted(kUsualWindow);
    const bool canes = is_one_of(k.request.material, {"bamboo", "rattan", "wicker", "cane", "wood"});
    const float share = drawn(k, 0.3f, 0.52f), low = s.y * (1.f - share), w = s.x, r = canes ? 0.03f : 0.02f,
                z = 0.026f;
    const int metal = k.material(k.style.metal);
    if (canes) {
        const int cane = k.main(*material_named("bamboo")),
                  cord = k.material(plain("blind cord", {0.42f, 0.33f, 0.2f}, 0.9f));
        Mesh all;
        for (float y = low + 0.012f; y < s.y - 0.012f; y += 0.0105f)
            shapes::append(all, shapes::rod({-0.5f * w + k.rng.uniform(0.f, 0.004f), y, z},
                                            {0.5f * w - k.rng.uniform(0.f, 0.004f), y, z},
                                            0.0042f + 0.0006f * k.rng.uniform(), 0.0042f, 6));
        // What is rolled up hangs as a roll below.
        shapes::append(all, shapes::rod({-0.5f * w, low, z}, {0.5f * w, low, z}, r, r, 18));
        shapes::append(all, shapes::rod({-0.5f * w, s.y - 0.02f, z}, {0.5f * w, s.y - 0.02f, z}, 0.018f, 0.018f, 12));
        k.add(std::move(all), cane);
        for (const float x : {-0.36f * w, 0.36f * w}) {
            k.rod(cord, {x, low - r, z + 0.006f}, {x, s.y, z + 0.006f}, 0.003f, -1, 6);
            Mesh loop = shapes::ring(r + 0.002f, 0.005f, 20);
            shapes::turn(loop, {0, 0, 1}, 90);
            k.add(std::move(loop), cord, {x, low, z});
        }
        k.piece.mount = Mount::wall;
        return;
    }
    Material linen = plain("blind cloth", lerp(k.style.curtain.color_a, {0.7f, 0.68f, 0.63f}, 0.35f), 0.9f);
    linen.pattern = Pattern::fabric;
    linen.scale_m = 0.004f;
    linen.color_b = linen.color_a * 0.86f;
    const int cloth = blind_cloth(k, linen, 0.4f);
    k.rod(cloth, {-0.5f * w + 0.012f, s.y - r - 0.006f, z}, {0.5f * w - 0.012f, s.y - r - 0.006f, z}, r, -1, 24);
    for (const float sx : {-1.f, 1.f})
        k.board(metal, {sx * (0.5f * w - 0.006f), s.y - 0.05f, z}, {0.008f, 0.05f, 0.045f}, 0.002f);
    k.add(shapes::sheet(
              8, 10,
              [&](float u, float v) {
                  return Vec3f{(w - 0.03f) * (u - 0.5f), low + 0.02f + (s.y - r - 0.01f - low - 0.02f) * v, z + r};
              }),
          cloth);
    k.board(metal, {0, low, z + r}, {w - 0.03f, 0.022f, 0.01f}, 0.003f);
    // The chain at one side.
    const float x = 0.5f * w - 0.016f, reach = 0.55f * s.y;
    for (const float dz : {-0.014f, 0.014f})
        k.rod(metal, {x, s.y - reach, z + dz}, {x, s.y - 0.03f, z + dz}, 0.0016f, -1, 5);
    k.piece.mount = Mount::wall;
}

}  // namespace fastscene::furniture
