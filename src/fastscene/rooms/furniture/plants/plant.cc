// Potted plants of three sizes.
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/plants/foliage.h"

namespace fastscene::furniture {
namespace {

enum Growth { rosette, leafy_tree, swords, palm };

// Fronds that arch from the top of a slim trunk, leaflets along both sides of each.
void palm_crown(Kit& k, float y, float size, int green, int bark) {
    const Vec3f crown{0.05f * size, y + 0.5f * size, 0.02f * size};
    k.rod(bark, {0, y - 0.03f, 0}, crown, 0.032f * size, 0.024f * size, 10);
    Mesh ribs;
    for (int f = 0; f < 11; ++f) {
        const float a = 2.39996f * static_cast<float>(f), t = static_cast<float>(f) / 10.f,
                    length = size * k.rng.uniform(0.52f, 0.66f) * (1.f - 0.22f * t), lift = 0.55f + 1.1f * t,
                    droop = 1.05f + 0.1f * t;
        const Vec3f out = around(a), side = cross(Vec3f{0, 1, 0}, out);
        const auto rib = [&](float v) {
            return crown + out * (length * v) + Vec3f{0, length * (lift * v - droop * v * v), 0};
        };
        std::vector<Vec3f> path;
        for (int i = 0; i <= 8; ++i) path.push_back(rib(static_cast<float>(i) / 8.f));
        shapes::append(ribs, shapes::tube(path, 0.005f * size, 5));
        for (int i = 0; i < 12; ++i) {
            const float v = 0.2f + 0.067f * static_cast<float>(i), leaf = length * (0.36f - 0.2f * std::abs(v - 0.45f));
            for (const float way : {-1.f, 1.f})
                k.add(blade(rib(v), normalize(side * way + out * 0.75f), leaf, 0.034f * size, 0.18f, 0.55f, 0.7f),
                      green);
        }
    }
    k.add(std::move(ribs), green);
}

void plant_of(Kit& k, int kind, float size) {
    Material clay = plain("plant pot", k.rng.chance(0.4f) ? Vec3f{0.7f, 0.68f, 0.63f} : k.accent(), 0.6f);
    if (k.style.plants > 0.8f && size > 0.6f) clay = *material_named("wicker");
    const int green = k.main(foliage(k,
                                     kind == 1   ? Vec3f{0.09f, 0.19f, 0.06f}
                                     : kind == 0 ? Vec3f{0.06f, 0.16f, 0.06f}
                                                 : Vec3f{0.11f, 0.2f, 0.09f},
                                     0.2f * size)),
              clay_m = k.material(clay);
    const float y = flower_pot(k, clay_m, 0.17f * size, 0.3f * size);
    Material bark_m = plain("bark", {0.18f, 0.12f, 0.08f}, 0.9f);
    bark_m.pattern = Pattern::bark;
    bark_m.scale_m = 0.03f;
    bark_m.color_b = {0.08f, 0.055f, 0.04f};
    const int bark = k.material(bark_m);
    if (kind == palm) return palm_crown(k, y, size, green, bark);
    if (kind == 0) {  // a rosette of arching fronds
        for (int i = 0; i < 22; ++i) {
            const float a = 2.39996f * static_cast<float>(i), t = static_cast<float>(i) / 22.f;
            k.add(blade({0, y - 0.01f, 0}, around(a), size * (0.62f - 0.25f * t), size * 0.085f, 0.7f + 1.7f * t,
                        1.1f - 0.2f * t, 0.7f),
                  green);
        }
    } else if (kind == 1) {  // a small tree with many leaves
        const Vec3f crown{0.04f * size, y + 0.75f * size, 0.02f * size};
        k.rod(bark, {0, y - 0.03f, 0}, crown, 0.022f * size, 0.014f * size, 10);
        for (int b = 0; b < 9; ++b) {
            const float a = 2.39996f * static_cast<float>(b), rise = 0.1f + 0.06f * static_cast<float>(b % 5);
            const Vec3f from = lerp(Vec3f{0, y, 0}, crown, 0.55f + 0.05f * static_cast<float>(b)),
                        to = from + around(a) * (0.3f * size) + Vec3f{0, rise * 1.3f * size, 0};
            k.rod(bark, from, to, 0.009f * size, 0.004f * size, 6);
            for (int i = 0; i < 12; ++i) {
                const float t = 0.3f + 0.06f * static_cast<float>(i), la = a + k.rng.uniform(-1.6f, 1.6f);
                k.add(blade(lerp(from, to, t), around(la), size * k.rng.uniform(0.13f, 0.2f), size * 0.085f,
                            k.rng.uniform(0.1f, 0.9f), 0.8f, 0.8f),
                      green);
            }
        }
    } else {  // upright swords
        for (int i = 0; i < 16; ++i) {
            const float a = 2.39996f * static_cast<float>(i), r = 0.02f + 0.0065f * static_cast<float>(i);
            k.add(blade(around(a) * (r * size) + Vec3f{0, y - 0.02f, 0}, around(a), size * 0.16f, size * 0.065f,
                        k.rng.uniform(3.2f, 5.6f), 0.2f, 1.4f),
                  green);
        }
    }
}

}  // namespace

void build_plant(Kit& k) { plant_of(k, k.request.pattern == "palm" ? palm : k.rng.index(3), 1.05f); }

void build_plant_tree(Kit& k) { plant_of(k, k.request.pattern == "palm" ? palm : leafy_tree, 1.4f); }

void build_plant_small(Kit& k) {
    plant_of(k, k.rng.index(2) * 2, 0.3f);
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
