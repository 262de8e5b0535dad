// Cups, plates, bottles and trays.
#include "fastscene/rooms/furniture/kitchen/tableware.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace fastscene::furniture {
namespace {

void cup_at(Kit& k, int mat, Vec3f at, float r = 0.04f, float h = 0.085f) {
    const std::array<Vec2f, 4> p{Vec2f{0.6f * r, 0}, {0.85f * r, 0.2f * h}, {r, 0.6f * h}, {0.98f * r, h}};
    Mesh m = shapes::vessel(p, 0.004f, 18);
    k.add(std::move(m), mat, at);
    std::vector<Vec3f> handle;
    for (int i = 0; i <= 6; ++i) {
        const float a = -1.4f + 2.8f * static_cast<float>(i) / 6.f;
        handle.push_back({0.88f * r + 0.45f * r * std::cos(a), 0.5f * h + 0.3f * h * std::sin(a), 0});
    }
    k.add(shapes::tube(handle, 0.005f, 6), mat, at);
}

void plate_at(Kit& k, int mat, Vec3f at, float r) {
    const std::array<Vec2f, 6> p{Vec2f{0.f, 0}, {0.6f * r, 0.f},     {0.65f * r, 0.006f},
                                 {r, 0.017f},   {0.985f * r, 0.02f}, {0.62f * r, 0.009f}};
    k.add(shapes::lathe(p, 28), mat, at);
}

}  // namespace

int glazed(Kit& k) {
    return k.main(plain("glazed ceramic", lerp(k.accent(), {0.75f, 0.72f, 0.66f}, k.rng.uniform(0.f, 0.6f)), 0.25f));
}

void bottle_at(Kit& k, int mat, Vec3f at, float r, float h) {
    const std::array<Vec2f, 8> p{Vec2f{0.9f * r, 0},      {r, 0.01f},
                                 {r, 0.55f * h},          {0.85f * r, 0.66f * h},
                                 {0.36f * r, 0.78f * h},  {0.34f * r, 0.96f * h},
                                 {0.42f * r, 0.965f * h}, {0.42f * r, h}};
    k.add(shapes::lathe(p, 20), mat, at);
}

void build_cup(Kit& k) {
    const int mat = glazed(k);
    if (k.rng.chance(0.5f)) plate_at(k, mat, {}, 0.07f);
    cup_at(k, mat, {0, 0.008f, 0});
    on_surface(k);
}

// A tray with a pot and cups, or bottles and glasses.
void build_tray(Kit& k) {
    const int wood = k.main(k.style.wood2),
              china = k.material(plain("porcelain", lerp(k.accent(), {0.78f, 0.76f, 0.7f}, 0.6f), 0.2f));
    const float w = 0.38f, d = 0.27f;
    k.board(wood, {}, {w, 0.012f, d}, 0.004f);
    for (const float s : {-1.f, 1.f}) {
        k.board(wood, {0, 0.01f, s * (0.5f * d - 0.006f)}, {w, 0.025f, 0.012f}, 0.004f);
        k.board(wood, {s * (0.5f * w - 0.006f), 0.01f, 0}, {0.012f, 0.04f, d - 0.024f}, 0.004f);
    }
    if (k.rng.chance(0.5f)) {
        const std::array<Vec2f, 7> pot{Vec2f{0.045f, 0}, {0.065f, 0.02f},  {0.072f, 0.06f}, {0.055f, 0.1f},
                                       {0.03f, 0.115f},  {0.012f, 0.125f}, {0.012f, 0.14f}};
        k.add(shapes::lathe(shapes::curve(pot, 3), 24, true), china, {-0.07f, 0.012f, 0});
        k.rod(china, {-0.14f, 0.09f, 0}, {-0.17f, 0.125f, 0}, 0.009f, 0.006f);
        cup_at(k, china, {0.06f, 0.012f, 0.05f}, 0.036f, 0.055f);
        cup_at(k, china, {0.11f, 0.012f, -0.05f}, 0.036f, 0.055f);
    } else {
        Material green = glass();
        green.color_a = {0.12f, 0.25f, 0.12f};
        green.transmission = 0.4f;
        bottle_at(k, k.material(green), {-0.1f, 0.012f, 0.02f}, 0.037f, 0.28f);
        const int clear = k.material(glass());
        for (int i = 0; i < 2; ++i) {
            const std::array<Vec2f, 2> p{Vec2f{0.03f, 0}, {0.036f, 0.09f}};
            k.add(shapes::vessel(p, 0.003f, 18), clear,
                  {0.04f + 0.08f * static_cast<float>(i), 0.012f, i == 0 ? 0.05f : -0.04f});
        }
    }
    on_surface(k);
}

// A plate on a mat with cutlery and a glass: what the table is laid with.
void build_place_setting(Kit& k) {
    Material linen = tinted(k.style.fabric2, lerp(k.accent(), {0.7f, 0.67f, 0.6f}, 0.4f));
    const int mat = k.main(linen), china = k.material(porcelain()), metal = k.material(steel());
    k.board(mat, {}, {0.42f, 0.004f, 0.3f}, 0.001f);
    plate_at(k, china, {0, 0.004f, 0}, 0.13f);
    plate_at(k, china, {0, 0.013f, 0}, 0.09f);
    for (const float x : {-0.165f, 0.16f, 0.185f}) k.board(metal, {x, 0.004f, 0}, {0.014f, 0.004f, 0.19f}, 0.001f);
    const std::array<Vec2f, 2> p{Vec2f{0.028f, 0}, {0.034f, 0.1f}};
    k.add(shapes::vessel(p, 0.003f, 18), k.material(glass()), {0.15f, 0.004f, -0.105f});
    on_surface(k);
}

void build_bottles(Kit& k) {
    const int count = 2 + k.rng.index(3);
    for (int i = 0; i < count; ++i) {
        Material m = k.rng.chance(0.5f) ? glass() : plain("stoneware", k.accent(), 0.35f);
        if (m.transmission > 0)
            m.color_a = m.color_b = lerp(k.accent(), {0.3f, 0.4f, 0.3f}, 0.5f), m.transmission = 0.5f;
        const int mat = i == 0 ? k.main(m) : k.material(m);
        bottle_at(k, mat, {0.085f * static_cast<float>(i), 0, k.rng.uniform(-0.03f, 0.03f)},
                  k.rng.uniform(0.028f, 0.038f), k.rng.uniform(0.18f, 0.31f));
    }
    on_surface(k);
}

}  // namespace fastscene::furniture
