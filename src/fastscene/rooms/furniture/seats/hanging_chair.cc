// Hanging chair.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/seats/upholstery.h"

namespace fastscene::furniture {

// A basket like an egg, open to the front, that hangs by a chain from its own stand.
void build_hanging_chair(Kit& k) {
    const int cane = woven_main(k);
    if (k.request.color_name.empty() && !k.request.color && k.style.black_cane) {
        Material& m = k.piece.materials[static_cast<std::size_t>(cane)];
        m.color_a = m.color_c = {0.075f, 0.07f, 0.066f}, m.color_b = {0.03f, 0.028f, 0.027f};
    }
    const int metal = k.material(plain("black metal", {0.035f, 0.035f, 0.037f}, 0.45f)),
              cloth = k.material(tinted(k.style.fabric, lerp(k.style.fabric.color_a, {0.72f, 0.69f, 0.63f}, 0.4f))),
              second = accent_cloth(k);
    const Vec3f middle{0, 1.04f, 0.06f};
    constexpr float kWide = 0.46f, kHigh = 0.62f, kDeep = 0.42f;
    // Closed below the seat and above the head.
    const auto gap = [](float v) { return 1.02f * eased(0.24f, 0.46f, v) * (1.f - eased(0.74f, 0.97f, v)); };
    const auto on_egg = [=](float a, float v) {
        const float polar = kPi * (0.02f + 0.96f * v), r = std::sin(polar) * (1.f - 0.13f * eased(0.4f, 1.f, v));
        return middle + Vec3f{kWide * r * std::sin(a), -kHigh * std::cos(polar), kDeep * r * std::cos(a)};
    };
    k.add(shapes::slab(48, 30, 0.016f,
                       [=](float u, float v) {
                           const float open = gap(v);
                           return on_egg(open + (kTau - 2 * open) * u, v);
                       }),
          cane);
    // Its rim, and hoops that bear the weave.
    std::vector<Vec3f> rim;
    constexpr int kRim = 26;
    for (int i = 0; i <= kRim; ++i)
        rim.push_back(
            on_egg(gap(0.25f + 0.71f * static_cast<float>(i) / kRim), 0.25f + 0.71f * static_cast<float>(i) / kRim));
    for (int i = kRim; i-- > 0;)
        rim.push_back(
            on_egg(-gap(0.25f + 0.71f * static_cast<float>(i) / kRim), 0.25f + 0.71f * static_cast<float>(i) / kRim));
    k.add(shapes::tube(rim, 0.02f, 8), cane);
    // Cushions: a round seat, a tall back, one more.
    const std::array<Vec2f, 8> seat{Vec2f{0.1f, 0.f}, {0.25f, 0.008f}, {0.305f, 0.04f}, {0.32f, 0.085f},
                                    {0.3f, 0.13f},    {0.22f, 0.155f}, {0.1f, 0.163f},  {0.f, 0.158f}};
    Mesh round = shapes::lathe(seat, 36, true);
    const std::uint32_t seed = k.seed();
    for (Vec3f& p : round.positions)
        p.y += 0.008f * shapes::wobble(p * 12.f, seed) * (p.y > 0.05f ? 1.f : 0.f), p.z *= 0.94f;
    shapes::smooth_normals(round);
    k.add(std::move(round), cloth, middle + Vec3f{0, -0.44f, 0.01f});
    put_pillow(k, cloth, middle + Vec3f{0, -0.34f, -0.19f}, {0.6f, 0.66f, 0.19f}, 5.f);
    put_pillow(k, second, middle + Vec3f{k.rng.uniform(-0.05f, 0.05f), -0.29f, -0.01f}, {0.42f, 0.3f, 0.14f}, 24.f,
               k.rng.uniform(-8, 8));
    // The stand: a ring on the floor, a mast that bends over the basket.
    const float r = 0.5f;
    k.add(shapes::ring(r, 0.045f, 48), metal, {0, 0.0225f, 0});
    for (const float turn : {-0.5f, 0.5f})
        k.rod(metal, {r * std::sin(turn), 0.024f, r * std::cos(turn)}, {0, 0.03f, -r}, 0.016f, -1, 10);
    const auto mast = curve_through({{-r, 0.03f},
                                     {-r - 0.09f, 0.5f},
                                     {-r - 0.11f, 1.1f},
                                     {-r - 0.02f, 1.65f},
                                     {-0.3f, 1.97f},
                                     {-0.05f, 2.02f},
                                     {0.06f, 1.98f}},
                                    [](Vec2f p) {
                                        return Vec3f{0, p.y, p.x};
                                    });
    std::vector<Vec3f> bent;
    for (int i = 0; i <= 36; ++i) bent.push_back(mast(static_cast<float>(i) / 36.f));
    k.add(shapes::tube(bent, 0.024f, 12), metal);
    const float top = middle.y + kHigh - 0.005f;
    for (int i = 0; top + 0.045f * static_cast<float>(i) < 1.95f; ++i) {
        Mesh link = shapes::ring(0.024f, 0.009f, 12);
        shapes::turn(link, i % 2 ? Vec3f{1, 0, 0} : Vec3f{0, 0, 1}, 90);
        k.add(std::move(link), metal, {0, top + 0.02f + 0.045f * static_cast<float>(i), 0.06f});
    }
    k.top(middle.y - 0.27f, 0, 0.14f, 0.16f, 0.1f);
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture
