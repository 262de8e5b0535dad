// Butterfly chair.
#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/openings/blind_parts.h"

namespace fastscene::furniture {

// A sheet of hide or canvas hung by its four corners in a frame of bent rod.
void build_butterfly_chair(Kit& k) {
    const int hide = k.main(k.style.of(k.style.made_of.butterfly_chair)),
              metal = k.material(plain("black metal", {0.035f, 0.035f, 0.037f}, 0.45f));
    const Vec3f back{0.37f, 0.93f, -0.4f}, front{0.4f, 0.63f, 0.34f};
    const auto mirrored = [](Vec3f p, float s) { return Vec3f{s * p.x, p.y, p.z}; };
    for (const float s : {-1.f, 1.f}) {
        // From the corner down to the other end, along the floor, and up to the other corner.
        std::vector<Vec3f> loop;
        const Vec3f b = mirrored(back, s), f = mirrored(front, -s);
        const auto bend = [&](Vec3f a, Vec3f corner, Vec3f c) {
            for (int i = 0; i <= 6; ++i) {
                const float t = static_cast<float>(i) / 6.f;
                loop.push_back(lerp(lerp(a, corner, t), lerp(corner, c, t), t));
            }
        };
        const Vec3f low_front{s * 0.31f, 0.011f, 0.33f}, low_back{-s * 0.31f, 0.011f, -0.33f};
        loop.push_back(b);
        bend(lerp(b, low_front, 0.93f), low_front, lerp(low_front, low_back, 0.08f));
        bend(lerp(low_front, low_back, 0.92f), low_back, lerp(low_back, f, 0.07f));
        loop.push_back(f);
        k.add(shapes::tube(loop, 0.0075f, 8), metal);
    }
    k.add(shapes::slab(26, 30, 0.007f,
                       [=](float u, float v) {
                           const float x = 2 * u - 1, hang = std::sin(kPi * v);
                           const Vec3f left = lerp(mirrored(back, -1), mirrored(front, -1), 1 - v),
                                       right = lerp(back, front, 1 - v);
                           Vec3f p = lerp(left, right, u);
                           p.x *= 1.f - 0.3f * hang * std::fabs(x);
                           // It sags into a seat, whose edges are drawn tight between the corners.
                           const float deep = std::max(0.f, std::sin(kPi * std::pow(1 - v, 0.8f)));
                           p.y -= 0.47f * std::pow(deep, 0.9f) * (1.f - 0.3f * x * x) +
                                  0.1f * (1.f - x * x) * (1.f - hang);
                           p.z += (0.1f * deep - 0.03f) * (1.f - x * x) * (1 - v);
                           return p;
                       }),
          hide);
    for (const float s : {-1.f, 1.f})
        for (const Vec3f c : {back, front}) k.add(shapes::ball(mirrored(c, s), {0.022f, 0.02f, 0.022f}, 10), hide);
    k.top(0.34f, 0, 0.06f, 0.14f, 0.12f);
    k.piece.clearance_front_m = 0.5f;
}

}  // namespace fastscene::furniture
