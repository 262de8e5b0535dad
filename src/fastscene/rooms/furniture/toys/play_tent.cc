// Play tent.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/openings/blind_parts.h"

namespace fastscene::furniture {

// Poles tied near their tops, canvas about them with its flaps drawn aside, a cushion within.
void build_play_tent(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 1.65f, 1.2f});
    Material canvas = plain("canvas", {0.7f, 0.66f, 0.57f}, 0.95f);
    canvas.pattern = Pattern::fabric;
    canvas.scale_m = 0.004f;
    canvas.color_b = canvas.color_a * 0.88f;
    canvas.transmission = 0.12f;
    canvas.specular = 0.02f;
    const int cloth = k.main(canvas), wood = k.material(*material_named("pine")),
              cord = k.material(plain("cord", {0.5f, 0.42f, 0.3f}, 0.9f)),
              mat = k.material(tinted(k.style.fabric2, lerp(k.accent(), {0.6f, 0.56f, 0.5f}, 0.35f))),
              band = k.material(tinted(k.style.fabric2, k.accent()));
    const float hx = 0.46f * s.x, hz = 0.46f * s.z, tie = 0.82f * s.y, neck = 0.045f;
    // Corner i: at the floor, where the poles meet, and on beyond.
    const auto corner = [&](int i, float y) {
        const float sx = i == 0 || i == 3 ? -1.f : 1.f, sz = i < 2 ? 1.f : -1.f, t = y / tie;
        return Vec3f{sx * std::lerp(hx, 0.f, t), y, sz * std::lerp(hz, 0.f, t)};
    };
    for (int i = 0; i < 4; ++i) k.rod(wood, corner(i, 0.f), corner(i, s.y), 0.014f, 0.011f, 10);
    for (const float y : {tie - 0.03f, tie - 0.015f, tie}) k.add(shapes::ring(0.03f, 0.012f, 20), cord, {0, y, 0});
    const float top = tie * (1.f - neck / hx);
    const auto wall = [&](Vec3f a0, Vec3f a1, Vec3f b0, Vec3f b1, int columns,
                          float sag) {  // from a to b, foot to head; sagging inward
        const Vec3f in = normalize(Vec3f{-(a0.x + b0.x), 0, -(a0.z + b0.z)});
        const std::uint32_t seed = k.seed();
        k.add(shapes::slab(columns, 10, 0.003f,
                           [&](float u, float v) {
                               const Vec3f low = lerp(a0, b0, u), high = lerp(a1, b1, u);
                               return lerp(low, high, v) +
                                      in * (sag * std::sin(kPi * u) * std::sin(kPi * std::min(1.f, v + 0.2f)) +
                                            0.006f * shapes::wobble({u * 4, v * 4, 0}, seed)) +
                                      Vec3f{0, 0.006f, 0};
                           }),
              cloth);
    };
    for (const int i : {1, 2, 3})
        wall(corner(i, 0), corner(i, top), corner((i + 1) % 4, 0), corner((i + 1) % 4, top), 12, 0.03f);
    // The front: closed above, below two flaps drawn to the poles.
    const float eave = 0.6f * tie;
    wall(corner(0, eave), corner(0, top), corner(1, eave), corner(1, top), 10, 0.008f);
    for (const int i : {0, 1}) {
        const int j = 1 - i;
        const Vec3f a0 = corner(i, 0), a1 = corner(i, eave), to = corner(j, eave);
        const std::uint32_t seed = k.seed();
        k.add(shapes::slab(10, 16, 0.003f,
                           [&](float u, float v) {
                               // Wide under the eave, gathered by a tie at a third of the height, falling in folds
                               // below.
                               const float across = i == 0 ? u : 1.f - u, waist = 0.34f,
                                           t = v < waist ? (waist - v) / waist : (v - waist) / (1 - waist);
                               const float wide = v < waist ? 0.13f + 0.13f * t : 0.13f + 0.37f * t * t,
                                           fold = 0.013f * std::sin(16.f * across) * (1.f - 0.7f * t * (v > waist));
                               const Vec3f edge = lerp(a0, a1, v), dir = normalize(Vec3f{to.x - a1.x, 0, 0});
                               const float reach = wide * (v < waist ? 2.f * hx * 0.62f : 2.f * hx * 0.4f + 0.02f);
                               return edge + dir * (across * reach) +
                                      Vec3f{0, 0.006f,
                                            0.012f + fold + 0.005f * shapes::wobble({across * 5, v * 5, 0}, seed)};
                           }),
              cloth);
        const Vec3f at = corner(i, 0.34f * eave);
        k.add(shapes::ring(0.055f, 0.014f, 20), band, at + Vec3f{i == 0 ? 0.04f : -0.04f, 0, 0.012f});
    }
    // Within: a mat and cushions; pennants over the door.
    k.soft(mat, {0, 0, -0.02f}, {1.7f * hx, 0.06f, 1.7f * hz}, {0.028f, 0.012f, 0.003f, 10});
    for (const float sx : {-1.f, 1.f}) {
        Mesh cushion = shapes::pillow({0.36f, 0.34f, 0.12f}, k.seed(), 10);
        shapes::turn(cushion, {1, 0, 0}, -24);
        shapes::turn(cushion, {0, 1, 0}, -sx * 14);
        k.add(std::move(cushion), sx > 0 ? band : k.material(tinted(k.style.fabric2, k.accent())),
              {sx * 0.17f, 0.062f, -0.5f * hz});
    }
    for (int i = 0; i < 5; ++i) {
        const float t = (static_cast<float>(i) + 0.5f) / 5.f;
        const Vec3f at = lerp(corner(0, eave), corner(1, eave), t) + Vec3f{0, 0.045f - 0.04f * 4 * t * (1 - t), 0.012f};
        const float half = 0.32f * (corner(1, eave).x - corner(0, eave).x) / 5.f * 1.2f;
        k.add(
            shapes::slab(2, 3, 0.002f,
                         [&](float u, float v) {
                             return at + Vec3f{(u - 0.5f) * 2.f * half * std::max(v, 0.03f), -0.085f * (1 - v), 0.004f};
                         }),
            k.material(plain("pennant", k.style.palette[static_cast<std::size_t>(i) % k.style.palette.size()], 0.9f)));
    }
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture
