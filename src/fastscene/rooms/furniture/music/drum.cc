// Drum.
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {

// A bass drum with two toms, a floor tom, a snare and cymbals, its front to the listeners.
void build_drum(Kit& k) {
    const int shell = k.main(plain("drum shell", lerp(k.accent(), {0.3f, 0.02f, 0.02f}, 0.5f), 0.25f)),
              skin = k.material(plain("drum skin", {0.72f, 0.7f, 0.65f}, 0.6f)), chrome = k.material(steel()),
              brass = k.material(*material_named("brass"));
    const auto standing = [&](Vec3f at, float r, float h) {
        k.add(shapes::prism(shapes::circle(r, 32), 0.f, h, 0.004f), shell, at);
        for (const float y : {-0.004f, h - 0.008f})
            k.add(shapes::prism(shapes::circle(r + 0.008f, 32), 0.f, 0.012f, 0.003f), chrome, at + Vec3f{0, y, 0});
        k.add(shapes::prism(shapes::circle(r - 0.006f, 32), 0.f, 0.004f, 0.001f), skin, at + Vec3f{0, h + 0.003f, 0});
    };
    const auto lying = [&](float r, float from, float to, int material) {
        Mesh m = shapes::prism(shapes::circle(r, 36), from, to, 0.004f);
        shapes::turn(m, {1, 0, 0}, 90);
        k.add(std::move(m), material, {0, 0.29f, 0.1f});
    };
    lying(0.27f, -0.2f, 0.2f, shell);
    lying(0.285f, 0.185f, 0.205f, chrome);
    lying(0.262f, 0.2f, 0.209f, skin);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(chrome, {sx * 0.24f, 0.3f, 0.2f}, {sx * 0.36f, 0.f, 0.32f}, 0.009f, -1, 8);
        standing({sx * 0.17f, 0.6f, 0.02f}, 0.14f, 0.2f);
        k.rod(chrome, {sx * 0.05f, 0.5f, 0.05f}, {sx * 0.1f, 0.64f, 0.04f}, 0.012f, -1, 8);
    }
    standing({-0.52f, 0.16f, -0.22f}, 0.19f, 0.36f);
    standing({0.46f, 0.5f, -0.28f}, 0.17f, 0.13f);
    k.rod(chrome, {0.46f, 0.f, -0.28f}, {0.46f, 0.51f, -0.28f}, 0.014f, -1, 10);
    for (int i = 0; i < 3; ++i) {
        const float a = 2.0944f * static_cast<float>(i);
        k.rod(chrome, {-0.52f + 0.19f * std::sin(a), 0.f, -0.22f + 0.19f * std::cos(a)},
              {-0.52f + 0.19f * std::sin(a), 0.4f, -0.22f + 0.19f * std::cos(a)}, 0.008f, -1, 8);
        k.rod(chrome, {0.46f + 0.22f * std::sin(a), 0.f, -0.28f + 0.22f * std::cos(a)}, {0.46f, 0.3f, -0.28f}, 0.008f,
              -1, 8);
    }
    for (const auto& [x, z, y, r] :
         {std::array{-0.5f, 0.16f, 0.98f, 0.2f}, {0.56f, 0.12f, 1.02f, 0.22f}, {0.7f, -0.14f, 0.8f, 0.16f}}) {
        k.rod(chrome, {x, 0.f, z}, {x, y + 0.03f, z}, 0.01f, 0.008f, 8);
        for (int i = 0; i < 3; ++i) {
            const float a = 2.0944f * static_cast<float>(i) + 0.5f;
            k.rod(chrome, {x + 0.2f * std::sin(a), 0.f, z + 0.2f * std::cos(a)}, {x, 0.22f, z}, 0.007f, -1, 8);
        }
        const std::array<Vec2f, 5> bow{
            Vec2f{r, 0.f}, {0.96f * r, 0.004f}, {0.35f * r, 0.016f}, {0.2f * r, 0.028f}, {0.02f, 0.034f}};
        Mesh m = shapes::lathe(bow, 32, true);
        shapes::turn(m, {0, 0, 1}, x < 0 ? 9.f : -9.f);
        k.add(std::move(m), brass, {x, y, z});
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture
