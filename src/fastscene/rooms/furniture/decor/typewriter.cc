// Typewriter.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// An old office machine: enamelled body, four rows of round keys, the basket of types, a carriage with a sheet in it.
void build_typewriter(Kit& k) {
    static constexpr std::array<Vec3f, 4> kEnamels{
        {{0.018f, 0.018f, 0.019f}, {0.05f, 0.11f, 0.09f}, {0.28f, 0.36f, 0.32f}, {0.3f, 0.045f, 0.04f}}};
    const int body = k.main(plain("enamel", kEnamels[static_cast<std::size_t>(k.rng.index(4))], 0.25f)),
              dark = k.material(plain("cast iron", {0.025f, 0.024f, 0.023f}, 0.45f)),
              bright = k.material(plain("key ring", {0.5f, 0.5f, 0.49f}, 0.25f)),
              ivory = k.material(plain("key", {0.62f, 0.58f, 0.48f}, 0.4f)),
              rubber = k.material(plain("platen", {0.02f, 0.02f, 0.02f}, 0.6f)),
              paper = k.material(plain("paper", {0.76f, 0.74f, 0.68f}, 0.9f));
    k.piece.materials[static_cast<std::size_t>(bright)].metal = 1.f;
    // The profile from the side, extruded: a low front for the keys, a hood over the types.
    const std::vector<Vec2f> hood{{-0.15f, 0.f},    {-0.15f, 0.125f}, {-0.06f, 0.14f},
                                  {-0.005f, 0.12f}, {0.02f, 0.075f},  {0.02f, 0.f}};
    std::vector<Vec2f> outline;
    for (const Vec2f& p : hood) outline.push_back({-p.x, p.y});
    for (const float sx : {-1.f, 1.f}) {
        Mesh cheek = shapes::prism(outline, -0.02f, 0.02f, 0.006f);  // (x, z) -> (z, y)
        shapes::turn(cheek, {1, 0, 0}, -90);
        shapes::turn(cheek, {0, 1, 0}, 90);
        k.add(std::move(cheek), body, {sx * 0.135f, 0, 0});
    }
    k.board(body, {0, 0.012f, 0.f}, {0.31f, 0.03f, 0.32f}, 0.012f);
    k.board(body, {0, 0.03f, -0.115f}, {0.27f, 0.095f, 0.06f}, 0.008f);
    k.board(dark, {0, 0.03f, -0.035f}, {0.24f, 0.05f, 0.1f}, 0.004f);
    // The basket: types in a fan.
    for (int i = 0; i < 21; ++i) {
        const float a = -1.1f + 0.11f * static_cast<float>(i);
        k.rod(bright, {0.012f * std::sin(a), 0.082f, -0.062f},
              {0.1f * std::sin(a), 0.096f - 0.012f * std::abs(a), -0.062f + 0.085f * std::cos(a)}, 0.0016f, -1, 5);
    }
    k.board(body, {0, 0.035f, 0.026f}, {0.25f, 0.042f, 0.012f}, 0.005f);
    // Keys on levers, each row lower than the one behind it.
    for (int row = 0; row < 4; ++row) {
        const float y = 0.088f - 0.0145f * static_cast<float>(row), z = 0.05f + 0.027f * static_cast<float>(row);
        const int keys = row == 0 ? 11 : row == 3 ? 9 : 10;
        for (int i = 0; i < keys; ++i) {
            const float x = (static_cast<float>(i) - 0.5f * static_cast<float>(keys - 1)) * 0.0245f +
                            (row % 2 ? 0.004f : -0.003f);
            const std::array<Vec2f, 3> rim{Vec2f{0.0082f, 0}, {0.0095f, 0.0015f}, {0.0095f, 0.0045f}};
            k.add(shapes::lathe(rim, 14), bright, {x, y, z});
            k.add(shapes::prism(shapes::circle(0.0078f, 14), 0.0042f, 0.0056f, 0.0004f),
                  (i + row) % 9 == 8 ? dark : ivory, {x, y, z});
            k.rod(dark, {x, 0.042f, z - 0.004f}, {x, y + 0.001f, z}, 0.0016f, -1, 5);
        }
    }
    k.rod(dark, {-0.075f, 0.04f, 0.155f}, {0.075f, 0.04f, 0.155f}, 0.006f, -1, 10);
    for (const float sx : {-0.07f, 0.07f}) k.rod(dark, {sx, 0.025f, 0.14f}, {sx, 0.04f, 0.155f}, 0.003f, -1, 6);
    // The carriage.
    k.board(dark, {0, 0.125f, -0.115f}, {0.36f, 0.016f, 0.05f}, 0.003f);
    k.rod(rubber, {-0.165f, 0.158f, -0.11f}, {0.165f, 0.158f, -0.11f}, 0.021f, -1, 20);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(dark, {sx * 0.165f, 0.158f, -0.11f}, {sx * 0.205f, 0.158f, -0.11f}, 0.006f, -1, 10);
        k.rod(dark, {sx * 0.192f, 0.158f, -0.11f}, {sx * 0.212f, 0.158f, -0.11f}, 0.018f, -1, 18);
        k.board(bright, {sx * 0.17f, 0.138f, -0.115f}, {0.006f, 0.035f, 0.05f}, 0.002f);
    }
    const std::array<Vec3f, 4> lever{
        {{-0.17f, 0.165f, -0.09f}, {-0.195f, 0.172f, -0.06f}, {-0.2f, 0.175f, -0.02f}, {-0.197f, 0.172f, -0.005f}}};
    k.add(shapes::tube(lever, 0.004f, 8), bright);
    // The sheet comes up behind the platen and bends back a little.
    k.add(shapes::slab(4, 14, 0.0012f,
                       [](float u, float v) {
                           const float up = 0.19f * v;
                           return Vec3f{(u - 0.5f) * 0.21f, 0.165f + up, -0.135f - 0.5f * up * up - 0.12f * up};
                       }),
          paper);
    const int ink = k.material(plain("ink", {0.05f, 0.05f, 0.055f}, 0.9f));
    for (int i = 0; i < 5; ++i) {
        const float up = 0.16f - 0.02f * static_cast<float>(i),
                    wide = i == 4 ? 0.06f : 0.15f + 0.01f * static_cast<float>(i % 3);
        k.board(ink, {-0.08f + 0.5f * wide, 0.163f + up, -0.1335f - 0.5f * up * up - 0.12f * up + 0.0016f},
                {wide, 0.003f, 0.0006f}, 0.0001f);
    }
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
