// Paint buckets.
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {
namespace {

// A tin with its rim and its handle; open ones show what is left in them, with a run down the side.
void paint_tin(Kit& k, Vec3f at, float r, float h, Vec3f color, bool open, int tin) {
    const int paint = k.material(plain("wet paint", color, 0.15f)),
              label = k.material(plain("tin label", lerp(color, {0.7f, 0.69f, 0.66f}, 0.45f), 0.5f));
    const std::array<Vec2f, 8> wall{
        Vec2f{r - 0.006f, 0},    {r, 0.006f},    {r, 0.16f * h},           {r - 0.001f, 0.17f * h},
        {r - 0.001f, 0.86f * h}, {r, 0.87f * h}, {r + 0.004f, h - 0.006f}, {r + 0.002f, h}};
    if (open) k.add(shapes::vessel(wall, 0.003f, 32), tin, at);
    else k.add(shapes::lathe(wall, 32), tin, at);
    const std::array<Vec2f, 2> band{Vec2f{r + 0.0012f, 0.2f * h}, {r + 0.0012f, 0.82f * h}};
    k.add(shapes::lathe(band, 32), label, at);
    if (open) {
        k.add(shapes::prism(shapes::circle(r - 0.005f, 32), 0.8f * h, 0.81f * h, 0.001f), paint, at);
        const float a = k.rng.uniform(0.f, kTau);
        for (int i = 0; i < 3; ++i) {
            const float b = a + 0.28f * static_cast<float>(i - 1), far = h * k.rng.uniform(0.25f, 0.6f);
            k.rod(paint, at + Vec3f{(r + 0.003f) * std::cos(b), h - 0.004f, (r + 0.003f) * std::sin(b)},
                  at + Vec3f{(r + 0.003f) * std::cos(b), h - far, (r + 0.003f) * std::sin(b)}, 0.006f, 0.009f, 8);
        }
    } else {
        k.add(shapes::prism(shapes::circle(r - 0.008f, 32), h - 0.004f, h + 0.002f, 0.001f), tin, at);
    }
    // The handle has fallen to one side.
    std::vector<Vec3f> wire;
    const float turn = k.rng.uniform(0.f, kTau);
    for (int i = 0; i <= 14; ++i) {
        const float b = kPi * static_cast<float>(i) / 14.f, out = (r + 0.012f) * std::sin(b);
        const Vec3f p{(r + 0.006f) * std::cos(b), 0.78f * h - 0.35f * h * std::sin(b),
                      0.35f * out + (r + 0.004f) * std::sin(b)};
        wire.push_back(
            at + Vec3f{p.x * std::cos(turn) + p.z * std::sin(turn), p.y, p.z * std::cos(turn) - p.x * std::sin(turn)});
    }
    k.add(shapes::tube(wire, 0.0022f, 6), tin);
}

}  // namespace

// Three tins, a brush laid across the open one, a tray with its roller.
void build_paint_buckets(Kit& k) {
    const int tin = k.main(steel()), plastic = k.material(plain("paint tray", {0.05f, 0.05f, 0.055f}, 0.45f)),
              wood = k.material(*material_named("birch")),
              bristle = k.material(plain("bristles", {0.24f, 0.16f, 0.08f}, 0.9f)), metal = k.material(steel());
    const Vec3f color = k.request.color                ? *k.request.color
                        : k.request.color_name.empty() ? lerp(k.accent(), {0.72f, 0.7f, 0.66f}, 0.25f)
                                                       : color_named(k.request.color_name).value_or(k.accent());
    paint_tin(k, {-0.17f, 0, 0.02f}, 0.095f, 0.2f, color, true, tin);
    paint_tin(k, {0.06f, 0, -0.12f}, 0.095f, 0.2f, {0.74f, 0.73f, 0.7f}, false, tin);
    paint_tin(k, {-0.05f, 0, 0.2f}, 0.06f, 0.12f, lerp(k.accent(), color, 0.3f), false, tin);
    // The brush.
    k.board(wood, {-0.11f, 0.203f, 0.02f}, {0.13f, 0.012f, 0.024f}, 0.005f);
    k.board(metal, {-0.2f, 0.202f, 0.02f}, {0.05f, 0.015f, 0.05f}, 0.002f);
    k.board(bristle, {-0.25f, 0.203f, 0.02f}, {0.055f, 0.012f, 0.048f}, 0.003f);
    // The tray slopes down to its well.
    const int wet = k.material(plain("paint in the tray", color, 0.15f)),
              nap = k.material(plain("roller", lerp(color, {0.7f, 0.68f, 0.64f}, 0.2f), 0.95f));
    k.board(plastic, {0.27f, 0, 0.12f}, {0.25f, 0.012f, 0.34f}, 0.004f);
    for (const float sx : {-1.f, 1.f})
        k.board(plastic, {0.27f + sx * 0.12f, 0.01f, 0.12f}, {0.012f, 0.05f, 0.34f}, 0.003f);
    for (const float sz : {-1.f, 1.f})
        k.board(plastic, {0.27f, 0.01f, 0.12f + sz * 0.164f}, {0.25f, 0.05f, 0.012f}, 0.003f);
    k.board(wet, {0.27f, 0.011f, 0.19f}, {0.226f, 0.012f, 0.16f}, 0.001f);
    k.rod(nap, {0.18f, 0.048f, 0.04f}, {0.36f, 0.048f, 0.04f}, 0.032f, -1, 20);
    const std::array<Vec3f, 5> arm{Vec3f{0.36f, 0.048f, 0.04f},
                                   {0.385f, 0.055f, 0.04f},
                                   {0.385f, 0.075f, -0.02f},
                                   {0.3f, 0.1f, -0.06f},
                                   {0.27f, 0.115f, -0.12f}};
    k.add(shapes::tube(arm, 0.004f, 8), metal);
    k.rod(plastic, {0.27f, 0.115f, -0.1f}, {0.255f, 0.15f, -0.24f}, 0.013f, 0.015f, 12);
}

}  // namespace fastscene::furniture
