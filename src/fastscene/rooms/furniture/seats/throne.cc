// Throne.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// High-backed, gilt, cushioned in velvet, with a crest.
void build_throne(Kit& k) {
    Material velvet = *material_named("velvet");
    velvet = tinted(velvet, *color_named("burgundy"));
    const int cloth = k.main(velvet), gold = k.material(*material_named("brass")),
              wood = k.material(k.style.of(k.style.made_of.throne));
    const float hx = 0.36f, seat = 0.46f, back = -0.32f, high = 1.62f;
    for (const float sx : {-1.f, 1.f}) {
        const std::array<Vec2f, 9> p{Vec2f{0.03f, 0}, {0.042f, 0.02f}, {0.03f, 0.06f},
                                     {0.022f, 0.12f}, {0.036f, 0.24f}, {0.03f, 0.32f},
                                     {0.042f, 0.36f}, {0.042f, 0.56f}, {0.036f, 0.68f}};
        k.add(shapes::lathe(p, 18, true), wood, {sx * hx, 0, 0.3f});
        k.board(wood, {sx * hx, 0, back}, {0.075f, high - 0.12f, 0.07f}, 0.012f);
        // The arm ends in a gilt scroll.
        k.board(wood, {sx * hx, 0.68f, 0.0f}, {0.085f, 0.045f, 0.62f}, 0.014f);
        k.soft(cloth, {sx * hx, 0.72f, -0.03f}, {0.075f, 0.04f, 0.4f}, {0.018f, 0.008f, 0.001f, 8});
        k.add(shapes::ball({sx * hx, 0.7f, 0.32f}, {0.05f, 0.05f, 0.05f}, 18), gold);
        const std::array<Vec2f, 8> finial{Vec2f{0.036f, 0}, {0.046f, 0.016f}, {0.03f, 0.032f}, {0.044f, 0.07f},
                                          {0.05f, 0.095f},  {0.036f, 0.13f},  {0.016f, 0.16f}, {0.004f, 0.185f}};
        k.add(shapes::lathe(finial, 18, true), gold, {sx * hx, high - 0.12f, back});
        k.soft(cloth, {sx * hx, 0.5f, -0.02f}, {0.03f, 0.16f, 0.5f}, {0.01f, 0.004f, 0.001f, 8});
    }
    k.board(wood, {0, seat - 0.1f, 0}, {2 * hx, 0.1f, 0.66f}, 0.016f);
    k.board(gold, {0, seat - 0.095f, 0.33f}, {2 * hx - 0.06f, 0.022f, 0.012f}, 0.004f);
    k.soft(cloth, {0, seat - 0.01f, 0.02f}, {2 * hx - 0.06f, 0.12f, 0.6f}, {0.045f, 0.025f, 0.002f, 12});
    k.board(wood, {0, seat, back}, {2 * hx, high - seat - 0.2f, 0.04f}, 0.01f);
    k.soft(cloth, {0, seat + 0.1f, back + 0.04f}, {2 * hx - 0.16f, 0.86f, 0.08f}, {0.035f, 0.02f, 0.001f, 12});
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < (row % 2 ? 2 : 3); ++i)
            k.add(shapes::ball({0.16f * (static_cast<float>(i) - (row % 2 ? 0.5f : 1.f)),
                                seat + 0.24f + 0.18f * static_cast<float>(row), back + 0.078f},
                               {0.013f, 0.013f, 0.008f}, 8),
                  gold);
    // The crest: an arch with a crown of points.
    std::vector<Vec2f> arch;
    constexpr int kArch = 16;
    for (int i = 0; i <= kArch; ++i) {
        const float t = static_cast<float>(i) / kArch, x = (hx - 0.02f) * (2 * t - 1);
        arch.push_back({x, 0.06f + 0.15f * std::sin(kPi * t)});
    }
    arch.push_back({hx - 0.02f, -0.05f});
    arch.push_back({-hx + 0.02f, -0.05f});
    for (Vec2f& p : arch) p.y = -p.y;
    Mesh crest = shapes::prism(arch, -0.022f, 0.022f, 0.006f);
    shapes::turn(crest, {1, 0, 0}, 90);
    k.add(std::move(crest), wood, {0, high - 0.16f, back});
    std::vector<Vec3f> rim;
    for (int i = 0; i <= kArch; ++i) {
        const float t = static_cast<float>(i) / kArch;
        rim.push_back({(hx - 0.03f) * (2 * t - 1), high - 0.1f + 0.15f * std::sin(kPi * t), back + 0.012f});
    }
    k.add(shapes::tube(rim, 0.016f, 10), gold);
    for (int i = -1; i <= 1; ++i)
        k.add(shapes::ball({0.11f * static_cast<float>(i), high + 0.08f - 0.02f * std::fabs(static_cast<float>(i)),
                            back + 0.012f},
                           {0.024f, i == 0 ? 0.05f : 0.034f, 0.024f}, 14),
              gold);
    k.top(seat + 0.1f, 0, 0.06f, 0.22f, 0.18f);
    k.piece.clearance_front_m = 0.6f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
