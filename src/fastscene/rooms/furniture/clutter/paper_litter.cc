// Paper litter.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Sheets that slid apart, some balled up.
void build_paper_litter(Kit& k) {
    const bool old = k.style.yellowed_paper;
    const int paper = k.main(plain("paper", old ? Vec3f{0.58f, 0.5f, 0.36f} : Vec3f{0.72f, 0.71f, 0.67f}, 0.95f)),
              ink = k.material(plain("ink", {0.12f, 0.12f, 0.13f}, 0.95f));
    const int sheets = 9 + k.rng.index(4);
    for (int i = 0; i < sheets; ++i) {
        const float turn = k.rng.uniform(0.f, 360.f), curl = k.rng.chance(0.4f) ? k.rng.uniform(0.008f, 0.03f) : 0.f,
                    far = std::sqrt(k.rng.uniform()) * 0.62f, a = k.rng.uniform(0.f, kTau);
        const float level = 0.001f + 0.0009f * static_cast<float>(i);
        Mesh m = shapes::slab(8, 8, 0.0004f, [=](float u, float v) {
            return Vec3f{(u - 0.5f) * 0.21f, curl * std::pow(std::max(0.f, u + v - 0.8f), 2.f), (0.5f - v) * 0.297f};
        });
        shapes::turn(m, {0, 1, 0}, turn);
        const Vec3f at{far * std::cos(a), level, 0.8f * far * std::sin(a)};
        k.add(std::move(m), paper, at);
        // Lines of writing on those that lie flat.
        for (int line = 0; curl == 0.f && line < 7; ++line) {
            Mesh words = shapes::box({0.15f - 0.05f * k.rng.uniform(), 0.0003f, 0.005f}, 0.0001f);
            shapes::move(words, {0, 0.0006f, -0.1f + 0.03f * static_cast<float>(line)});
            shapes::turn(words, {0, 1, 0}, turn);
            k.add(std::move(words), ink, at);
        }
    }
    for (int i = 0; i < 4; ++i) {
        const std::uint32_t seed = k.seed();
        const float r = k.rng.uniform(0.028f, 0.042f);
        Mesh ball = shapes::ball({}, {r, r, r}, 20);
        for (Vec3f& p : ball.positions) p = p * (1.f + 0.16f * shapes::wobble(p * (3.2f / r), seed));
        shapes::smooth_normals(ball);
        const float a = k.rng.uniform(0.f, kTau), far = k.rng.uniform(0.25f, 0.65f);
        k.add(std::move(ball), paper, {far * std::cos(a), 0.9f * r, 0.8f * far * std::sin(a)});
    }
}

}  // namespace fastscene::furniture
