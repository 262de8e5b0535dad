// Chandelier.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/lamps/lamp_parts.h"

namespace fastscene::furniture {
namespace {

// Cut glass: it takes the light of what is around it, and throws some of its own bulbs' back.
Material cut_glass(const Kit& k) {
    Material m = plain("cut crystal", {0.8f, 0.84f, 0.88f}, 0.06f);
    m.metal = 0.8f;
    m.emission = k.style.lamp_light * 0.035f;
    return m;
}

// A frame of metal, all hung with cut glass: strings of beads from the crown to the arms, drops below them, a basket
// that ends in a ball.
void crystal_chandelier(Kit& k) {
    const int crystal = k.piece.main_material = k.material(cut_glass(k)),
              metal = k.material(k.style.metal.metal > 0.5f ? k.style.metal : *material_named("chrome")),
              clear = k.material(glass()), sleeve = k.material(plain("candle sleeve", {0.75f, 0.72f, 0.64f}, 0.6f)),
              flame = k.material(glow("bulb", k.style.lamp_light * 1.6f));
    k.add(shapes::prism(shapes::circle(0.065f, 28), -0.03f, 0.f), metal);
    k.rod(metal, {0, -0.78f, 0}, {0, -0.02f, 0}, 0.006f);
    Mesh beads, drops;
    const auto bead = [&](Vec3f at, float r) { shapes::append(beads, shapes::ball(at, {r, r, r}, 7)); };
    // Faceted, six sides, its point down.
    const auto drop = [&](Vec3f at, float high) {
        const float r = 0.26f * high;
        const std::array<Vec2f, 5> p{
            Vec2f{0.f, -high}, {0.7f * r, -0.72f * high}, {r, -0.5f * high}, {0.35f * r, -0.12f * high}, {0.f, 0.f}};
        Mesh m = shapes::lathe(p, 6, false);
        shapes::append(drops, shapes::move(m, at));
    };
    const auto string = [&](Vec3f a, Vec3f b, float sag, int count) {
        for (int i = 0; i <= count; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(count);
            bead(lerp(a, b, t) - Vec3f{0, sag * 4 * t * (1 - t), 0}, 0.0085f);
        }
    };
    for (const float y : {-0.2f, -0.3f, -0.44f, -0.62f})
        k.add(shapes::ball({0, y, 0}, {0.032f, 0.04f, 0.032f}, 12), clear);
    const auto ring = [&](float y, float r) { k.add(shapes::ring(r, 0.005f, 36), metal, {0, y, 0}); };
    ring(-0.24f, 0.11f), ring(-0.7f, 0.2f), ring(-0.79f, 0.11f);
    constexpr int kArms = 8;
    const auto at = [](int i, int of, float r, float y) {
        return Vec3f{r * std::cos(kTau * static_cast<float>(i) / static_cast<float>(of)), y,
                     r * std::sin(kTau * static_cast<float>(i) / static_cast<float>(of))};
    };
    for (int i = 0; i < kArms; ++i) {
        std::vector<Vec3f> arm;
        for (int j = 0; j <= 12; ++j) {
            const float t = static_cast<float>(j) / 12.f;
            arm.push_back(at(i, kArms, 0.02f + 0.38f * t, -0.66f - 0.1f * std::sin(3.4f * t) + 0.1f * t * t));
        }
        k.add(shapes::tube(arm, 0.0065f, 8), metal);
        const Vec3f tip = arm.back();
        const std::array<Vec2f, 4> pan{Vec2f{0.008f, -0.006f}, {0.034f, 0.f}, {0.046f, 0.01f}, {0.04f, 0.01f}};
        k.add(shapes::lathe(pan, 18), clear, tip);
        k.rod(sleeve, tip, tip + Vec3f{0, 0.085f, 0}, 0.011f);
        k.add(shapes::ball(tip + Vec3f{0, 0.112f, 0}, {0.013f, 0.03f, 0.013f}, 10), flame);
        for (int j = 0; j < 5; ++j)
            drop(tip + Vec3f{0.042f * std::cos(1.2566f * static_cast<float>(j)), 0.004f,
                             0.042f * std::sin(1.2566f * static_cast<float>(j))},
                 0.055f);
        string(at(i, kArms, 0.11f, -0.25f), tip + Vec3f{0, 0.012f, 0}, 0.1f, 22);
        string(tip, at(i + 1, kArms, 0.4f, tip.y), 0.07f, 14);
        drop(lerp(tip, at(i + 1, kArms, 0.4f, tip.y), 0.5f) - Vec3f{0, 0.075f, 0}, 0.07f);
        drop(arm[6] - Vec3f{0, 0.006f, 0}, 0.08f);
    }
    // The crown's fringe and the basket below.
    for (int i = 0; i < 14; ++i) drop(at(i, 14, 0.11f, -0.245f), 0.06f);
    for (int i = 0; i < 18; ++i)
        drop(at(i, 18, 0.2f, -0.705f), 0.075f), string(at(i, 18, 0.2f, -0.7f), at(i, 18, 0.11f, -0.79f), 0.02f, 6);
    for (int i = 0; i < 12; ++i)
        drop(at(i, 12, 0.11f, -0.795f), 0.065f), string(at(i, 12, 0.11f, -0.79f), at(i, 12, 0.02f, -0.86f), 0.015f, 5);
    k.add(shapes::ball({0, -0.9f, 0}, {0.035f, 0.035f, 0.035f}, 14), clear);
    bead({0, -0.945f, 0}, 0.012f);
    k.add(std::move(beads), crystal);
    k.add(std::move(drops), crystal);
    k.piece.mount = Mount::ceiling;
}

}  // namespace

void build_chandelier(Kit& k) {
    if (k.request.material == "glass") return crystal_chandelier(k);
    const int metal = lamp_metal(k), wax = k.material(plain("candle sleeve", {0.75f, 0.72f, 0.64f}, 0.6f)),
              flame = k.material(glow("bulb", k.style.lamp_light * 1.6f));
    k.add(shapes::prism(shapes::circle(0.06f, 24), -0.03f, 0.f), metal);
    k.rod(metal, {0, -0.55f, 0}, {0, -0.02f, 0}, 0.007f);
    const std::array<Vec2f, 9> p{Vec2f{0, -0.9f}, {0.02f, -0.88f}, {0.03f, -0.85f}, {0.015f, -0.81f}, {0.05f, -0.75f},
                                 {0.055f, -0.7f}, {0.02f, -0.63f}, {0.03f, -0.58f}, {0.008f, -0.52f}};
    k.add(shapes::lathe(p, 20, true), metal);
    for (int i = 0; i < 8; ++i) {
        const float a = 0.7854f * static_cast<float>(i), c = std::cos(a), s = std::sin(a);
        std::vector<Vec3f> arm;
        for (int j = 0; j <= 12; ++j) {
            const float t = static_cast<float>(j) / 12.f, r = 0.03f + 0.37f * t;
            arm.push_back({r * c, -0.72f - 0.11f * std::sin(3.4f * t) + 0.08f * t * t, r * s});
        }
        k.add(shapes::tube(arm, 0.007f, 8), metal);
        const Vec3f tip = arm.back();
        k.add(shapes::prism(shapes::circle(0.035f, 16), 0.f, 0.008f), metal, tip);
        k.rod(wax, tip, tip + Vec3f{0, 0.09f, 0}, 0.012f);
        k.add(shapes::ball(tip + Vec3f{0, 0.115f, 0}, {0.014f, 0.03f, 0.014f}, 10), flame);
    }
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
