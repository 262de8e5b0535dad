// Venetian blind.
#include <utility>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/openings/blind_parts.h"

namespace fastscene::furniture {
namespace {}  // namespace

// Slats on ladder cords between a head rail and a bottom rail, tilted so that light falls in and one sees out between
// them.
void build_venetian_blind(Kit& k) {
    const Vec3f s = k.wanted(kUsualWindow);
    const bool wooden = k.style.of(k.style.made_of.blind_slats).pattern == Pattern::wood ||
                        k.request.material == "wood" || k.request.material == "bamboo";
    const int slat = k.main(k.style.of(k.style.made_of.blind_slats)),
              cord = k.material(plain("blind cord", {0.6f, 0.58f, 0.54f}, 0.8f));
    const float deep = 0.046f, thick = wooden ? 0.003f : 0.0014f, pitch = 0.042f, head = 0.045f, w = s.x,
                share = drawn(k, 0.f, 1.f) < 0.7f ? 1.f : 0.62f;
    const float low = s.y * (1.f - share) + 0.004f, top = s.y - head, mid = 0.025f;
    k.board(slat, {0, top, mid}, {w, head, 0.05f}, 0.004f);
    const float tilt = drawn(k, 30.f, 40.f);
    // What is drawn up lies as a stack on the bottom rail.
    const int stacked = share < 1.f ? static_cast<int>((s.y - s.y * share) / pitch) : 0;
    const float stack = static_cast<float>(stacked) * (thick + 0.0012f), rail = 0.022f;
    k.board(slat, {0, low, mid}, {w - 0.004f, rail, 0.042f}, 0.005f);
    Mesh one = shapes::slab(1, 4, thick, [&](float u, float v) {
        return Vec3f{(w - 0.006f) * (u - 0.5f), 0.0035f * (1.f - 4.f * (v - 0.5f) * (v - 0.5f)), deep * (0.5f - v)};
    });
    Mesh slats;
    for (int i = 0; i < stacked; ++i) {
        Mesh flat = one;
        shapes::append(slats,
                       shapes::move(flat, {0, low + rail + (thick + 0.0012f) * (static_cast<float>(i) + 0.6f), mid}));
    }
    shapes::turn(one, {1, 0, 0}, tilt);
    for (float y = low + rail + stack + 0.5f * pitch; y < top - 0.012f; y += pitch) {
        Mesh next = one;
        for (Vec3f& c : next.coords) c = c + Vec3f{k.rng.uniform(0, 3), k.rng.uniform(0, 3), 0};
        shapes::append(slats, shapes::move(next, {0, y, mid}));
    }
    k.add(std::move(slats), slat);
    const int ladders = w > 1.1f ? 3 : 2;
    for (int i = 0; i < ladders; ++i) {
        const float x = (w - 0.3f) * (static_cast<float>(i) / static_cast<float>(ladders - 1) - 0.5f);
        for (const float z : {mid - 0.023f, mid + 0.023f})
            k.rod(cord, {x, low + rail, z}, {x, top, z}, wooden ? 0.0022f : 0.0012f, -1, 5);
    }
    k.rod(cord, {0.5f * w - 0.07f, top - 0.5f * s.y * share, 0.052f}, {0.5f * w - 0.07f, top, 0.052f}, 0.004f, -1, 8);
    k.piece.mount = Mount::wall;
}

}  // namespace fastscene::furniture
