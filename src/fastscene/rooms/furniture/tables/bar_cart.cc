// Bar cart.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Two shelves in a frame of tubes on wheels, with bottles and glasses.
void build_bar_cart(Kit& k) {
    const Vec3f s = k.wanted({0.78f, 0.86f, 0.42f});
    const int frame = k.main(k.style.of(k.style.made_of.bar_cart));
    const int shelf = k.material(k.style.of(k.style.made_of.bar_cart_shelves)),
              tire = k.material(plain("tire", {0.04f, 0.04f, 0.04f}, 0.7f)), clear = k.material(glass());
    const float hx = 0.5f * s.x - 0.05f, hz = 0.5f * s.z - 0.025f, wheel = 0.055f, low = 0.22f, high = 0.72f * s.y;
    for (const float sx : {-1.f, 1.f}) {
        for (const float sz : {-1.f, 1.f}) {
            k.rod(frame, {sx * hx, wheel + 0.015f, sz * hz}, {sx * hx, s.y - 0.035f, sz * hz}, 0.0105f, -1, 12);
            Mesh tread = shapes::prism(shapes::circle(wheel, 28), -0.011f, 0.011f, 0.004f),
                 hub = shapes::prism(shapes::circle(0.4f * wheel, 20), -0.013f, 0.013f, 0.003f);
            for (Mesh* m : {&tread, &hub}) shapes::turn(*m, {1, 0, 0}, 90), shapes::move(*m, {sx * hx, wheel, sz * hz});
            k.add(std::move(tread), tire);
            k.add(std::move(hub), frame);
        }
        // Bows that one pushes it by.
        std::vector<Vec3f> bow_path;
        for (int i = 0; i <= 14; ++i) {
            const float a = kPi * static_cast<float>(i) / 14.f;
            bow_path.push_back(
                {sx * (hx + 0.04f * std::sin(a)), s.y - 0.035f + 0.025f * std::sin(a), hz * std::cos(a)});
        }
        k.add(shapes::tube(bow_path, 0.0105f, 12), frame);
    }
    for (const float y : {low, high}) {
        k.board(shelf, {0, y, 0}, {2 * hx - 0.01f, 0.014f, 2 * hz - 0.01f}, 0.003f);
        for (const float sz : {-1.f, 1.f})
            for (const float dy : {0.f, 0.06f})
                k.rod(frame, {-hx, y + dy, sz * hz}, {hx, y + dy, sz * hz}, 0.006f, -1, 10);
        for (const float sx : {-1.f, 1.f})
            for (const float dy : {0.f, 0.06f})
                k.rod(frame, {sx * hx, y + dy, -hz}, {sx * hx, y + dy, hz}, 0.006f, -1, 10);
    }
    static constexpr std::array<Vec3f, 5> kDrinks{Vec3f{0.3f, 0.13f, 0.03f},
                                                  {0.04f, 0.12f, 0.05f},
                                                  {0.62f, 0.6f, 0.52f},
                                                  {0.2f, 0.03f, 0.03f},
                                                  {0.42f, 0.27f, 0.08f}};
    const int label = k.material(plain("label", {0.68f, 0.64f, 0.54f}, 0.7f)),
              cap = k.material(plain("cap", {0.05f, 0.045f, 0.04f}, 0.4f));
    const auto bottle = [&](float x, float y, float z, std::size_t kind) {
        const float h = k.rng.uniform(0.24f, 0.31f), r = k.rng.uniform(0.033f, 0.042f);
        const std::array<Vec2f, 6> p{
            Vec2f{r, 0},          {r, 0.58f * h}, {0.9f * r, 0.65f * h}, {0.36f * r, 0.76f * h}, {0.34f * r, 0.93f * h},
            {0.3f * r, 0.93f * h}};
        k.add(shapes::lathe(p, 22, false), k.material(plain("bottle", kDrinks[kind % 5], 0.08f)), {x, y, z});
        k.rod(cap, {x, y + 0.92f * h, z}, {x, y + h, z}, 0.38f * r, -1, 12);
        k.rod(label, {x, y + 0.16f * h, z}, {x, y + 0.46f * h, z}, 1.015f * r, -1, 22);
    };
    for (int i = 0; i < 4; ++i)
        bottle(-hx + 0.09f + 0.105f * static_cast<float>(i), high + 0.014f,
               -0.45f * hz + 0.05f * static_cast<float>(i % 2), static_cast<std::size_t>(i));
    for (int i = 0; i < 3; ++i)
        bottle(-hx + 0.12f + 0.13f * static_cast<float>(i), low + 0.014f, 0.1f * hz * static_cast<float>(i % 2),
               static_cast<std::size_t>(i + 2));
    const std::array<Vec2f, 3> tumbler{Vec2f{0.03f, 0}, {0.034f, 0.045f}, {0.036f, 0.09f}};
    for (int i = 0; i < 4; ++i)
        k.add(shapes::vessel(tumbler, 0.002f, 20), clear,
              {hx - 0.07f - 0.085f * static_cast<float>(i % 2), high + 0.014f, (i < 2 ? 0.5f : -0.05f) * hz});
    // A bucket of ice below.
    const std::array<Vec2f, 4> bucket{Vec2f{0.06f, 0}, {0.068f, 0.01f}, {0.085f, 0.15f}, {0.09f, 0.16f}};
    k.add(shapes::vessel(bucket, 0.004f, 28), frame, {hx - 0.14f, low + 0.014f, 0});
    k.piece.clearance_front_m = 0.3f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
