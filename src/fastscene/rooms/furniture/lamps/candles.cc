// Candles: single ones, groups, candelabra.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {
namespace {

// A wick and the flame on it, `height` tall: dark orange at the root, yellow in its belly, orange at the point.
class Wick {
  public:
    explicit Wick(Kit& k)
        : k_(k),
          root_(k.material(flame("flame root", {5.f, 1.3f, 0.22f}))),
          belly_(k.material(flame("flame", {17.f, 7.6f, 1.1f}))),
          point_(k.material(flame("flame point", {11.f, 2.9f, 0.16f}))),
          thread_(k.material(plain("wick", {0.03f, 0.027f, 0.025f}, 0.9f))) {}
    void burn(Vec3f at, float height) {
        const float r = 0.2f * height;
        k_.rod(thread_, at, at + Vec3f{0, 0.22f * height, 0}, 0.0012f, -1, 5);
        const auto part = [&](std::initializer_list<Vec2f> profile, int material) {
            const std::vector<Vec2f> p(profile);
            k_.add(shapes::lathe(shapes::curve(p, 2), 12, true), material, at + Vec3f{0, 0.12f * height, 0});
        };
        part({{0.f, 0.f}, {0.55f * r, 0.06f * height}, {0.88f * r, 0.16f * height}}, root_);
        part({{0.88f * r, 0.16f * height}, {r, 0.3f * height}, {0.86f * r, 0.5f * height}, {0.62f * r, 0.64f * height}},
             belly_);
        part({{0.62f * r, 0.64f * height}, {0.3f * r, 0.84f * height}, {0.f, height}}, point_);
    }

  private:
    Kit& k_;
    int root_, belly_, point_, thread_;
};

// One for narrow places: a bathtub's rim.
void single_candle(Kit& k) {
    k.sized = true;
    const int wax = k.main(plain("wax", {0.75f, 0.7f, 0.6f}, 0.6f));
    k.add(shapes::prism(shapes::circle(0.028f, 24), 0.f, 0.006f), k.material(k.style.metal));
    const float high = k.rng.uniform(0.07f, 0.12f);
    k.rod(wax, {0, 0.005f, 0}, {0, high, 0}, 0.022f, -1, 20);
    Wick(k).burn({0, high - 0.001f, 0}, 0.034f);
    k.piece.mount = Mount::surface;
}

}  // namespace

void build_candle(Kit& k) {
    if (k.request.size_m.x > 0 && k.request.size_m.x < 0.12f) return single_candle(k);
    const int wax = k.main(plain("wax", {0.75f, 0.7f, 0.6f}, 0.6f)), metal = k.material(k.style.metal);
    Wick wick(k);
    // Pillars on a tray, all settings of one size: two of one height, three of three, four slim ones in a row, or a
    // thick one between two.
    struct Pillar {
        float x, z, high, radius;
    };
    static const std::array<std::vector<Pillar>, 4> kSettings{
        {{{-0.055f, 0.f, 0.17f, 0.034f}, {0.055f, 0.f, 0.17f, 0.034f}},
         {{-0.07f, 0.02f, 0.11f, 0.026f}, {0.f, -0.02f, 0.17f, 0.026f}, {0.06f, 0.04f, 0.08f, 0.026f}},
         {{-0.093f, 0.f, 0.1f, 0.019f},
          {-0.031f, 0.f, 0.15f, 0.019f},
          {0.031f, 0.f, 0.17f, 0.019f},
          {0.093f, 0.f, 0.12f, 0.019f}},
         {{-0.085f, 0.01f, 0.08f, 0.022f}, {0.f, 0.f, 0.17f, 0.036f}, {0.085f, -0.01f, 0.08f, 0.022f}}}};
    const int setting = k.rng.index(4);
    k.add(shapes::prism(shapes::rounded_rectangle(0.26f, 0.14f, 0.05f), 0.f, 0.012f), metal);
    for (const Pillar& p : kSettings[static_cast<std::size_t>(setting)]) {
        k.rod(wax, {p.x, 0.011f, p.z}, {p.x, p.high, p.z}, p.radius, -1, 20);
        wick.burn({p.x, p.high - 0.001f, p.z}, 0.036f);
    }
    k.piece.mount = Mount::surface;
}

// Five arms on a turned foot, a candle on each.
void build_candelabrum(Kit& k) {
    const int metal = k.main(k.style.metal.metal > 0.5f ? k.style.metal : *material_named("brass")),
              wax = k.material(plain("wax", {0.75f, 0.71f, 0.62f}, 0.6f));
    const std::array<Vec2f, 12> p{Vec2f{0.075f, 0}, {0.078f, 0.01f}, {0.05f, 0.022f}, {0.016f, 0.04f},
                                  {0.024f, 0.06f},  {0.012f, 0.08f}, {0.011f, 0.15f}, {0.02f, 0.168f},
                                  {0.011f, 0.186f}, {0.014f, 0.25f}, {0.008f, 0.27f}, {0.008f, 0.3f}};
    k.add(shapes::lathe(p, 24, true), metal);
    Wick wick(k);
    const auto light = [&](Vec3f at) {
        const std::array<Vec2f, 6> cup{Vec2f{0.006f, -0.012f}, {0.014f, -0.004f}, {0.03f, 0.004f},
                                       {0.031f, 0.008f},       {0.015f, 0.01f},   {0.013f, 0.024f}};
        k.add(shapes::lathe(cup, 20), metal, at);
        const float high = k.rng.uniform(0.09f, 0.115f);
        k.rod(wax, at + Vec3f{0, 0.012f, 0}, at + Vec3f{0, high, 0}, 0.0105f, 0.0095f, 14);
        wick.burn(at + Vec3f{0, high - 0.001f, 0}, 0.03f);
    };
    light({0, 0.3f, 0});
    for (int i = 0; i < 4; ++i) {
        const Vec3f out = i % 2 == 0 ? Vec3f{i == 0 ? 1.f : -1.f, 0, 0.18f} : Vec3f{i == 1 ? 1.f : -1.f, 0, -0.18f};
        const float far = i % 2 == 0 ? 0.15f : 0.085f, rise = i % 2 == 0 ? 0.255f : 0.285f;
        std::vector<Vec3f> arm;
        for (int j = 0; j <= 14; ++j) {
            const float t = static_cast<float>(j) / 14.f;
            arm.push_back(
                out * (far * (0.06f + 0.94f * std::sin(0.5f * kPi * t))) +
                Vec3f{0, 0.18f - 0.05f * std::sin(kPi * std::min(1.f, 1.5f * t)) + (rise - 0.18f) * t * t, 0});
        }
        k.add(shapes::tube(arm, 0.006f, 8), metal);
        light(arm.back());
    }
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
