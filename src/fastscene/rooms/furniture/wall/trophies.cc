// Antlers and heads on wooden shields.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {
namespace {

// ---- antlers

// Turns triangles and normals about, if they look inward.
Mesh outward(Mesh m) {
    if (shapes::signed_volume(m) >= 0) return m;
    for (std::size_t t = 0; t < m.triangles.size(); t += 3) std::swap(m.triangles[t + 1], m.triangles[t + 2]);
    for (Vec3f& n : m.normals) n = -n;
    return m;
}

// A body about a line in the plane x = 0: at each point half its width and half its height.
Mesh limb(const std::vector<Vec3f>& line, const std::vector<Vec2f>& half, int sides) {
    const auto last = static_cast<float>(line.size() - 1);
    const auto smooth = [&](const auto& points, float t) {
        const auto i = std::min(static_cast<std::size_t>(t), points.size() - 2);
        const float f = t - static_cast<float>(i);
        const auto a = points[i > 0 ? i - 1 : 0], b = points[i], c = points[i + 1],
                   d = points[std::min(i + 2, points.size() - 1)];
        return (b * 2.f + (c - a) * f + (a * 2.f - b * 5.f + c * 4.f - d) * (f * f) +
                (b * 3.f - a - c * 3.f + d) * (f * f * f)) *
               0.5f;
    };
    return outward(shapes::sheet(sides, 4 * static_cast<int>(last), [&](float u, float v) {
        const float t = v * last;
        const Vec3f at = smooth(line, t),
                    along = normalize(smooth(line, std::min(last, t + 0.05f)) - smooth(line, std::max(0.f, t - 0.05f)));
        const Vec3f side{1, 0, 0}, up = normalize(cross(along, side));
        const Vec2f r = smooth(half, t);
        const float a = kTau * u;
        return at + side * (std::max(r.x, 0.001f) * std::cos(a)) + up * (std::max(r.y, 0.001f) * std::sin(a));
    }));
}

// A pair of antlers that rise from the roots at +-root.x.
void antler_pair(Kit& k, int horn, Vec3f root, float size) {
    for (const float sx : {-1.f, 1.f}) {
        const auto beam = [&](float t) {  // out, back and up, then in again
            return Vec3f{sx * (root.x + size * (0.5f * t + 0.12f * std::sin(kPi * t) - 0.12f * t * t * t)),
                         root.y + size * (0.95f * t - 0.1f * std::sin(kPi * t)),
                         root.z + size * (0.1f * std::sin(kPi * t) + 0.12f * t * t)};
        };
        constexpr int kSteps = 9;
        for (int i = 0; i < kSteps; ++i) {
            const float a = static_cast<float>(i) / kSteps, b = static_cast<float>(i + 1) / kSteps,
                        thick = 0.021f * size / 0.55f;
            k.rod(horn, beam(a), beam(b + 0.01f), thick * (1.f - 0.8f * a), thick * (1.f - 0.8f * b), 10);
        }
        for (const auto& [t, long_, lean] :
             {std::tuple{0.08f, 0.26f, 0.9f}, {0.34f, 0.3f, 0.5f}, {0.58f, 0.27f, 0.28f}, {0.78f, 0.2f, 0.12f}}) {
            const Vec3f from = beam(t), bend = from + Vec3f{-sx * 0.02f, 0.3f * long_, lean * long_} * size,
                        tip = bend + Vec3f{-sx * 0.03f, 0.62f * long_, 0.12f * long_} * size;
            const float thick = 0.0125f * size / 0.55f;
            k.rod(horn, from, bend, thick, 0.72f * thick, 8);
            k.rod(horn, bend, tip, 0.72f * thick, 0.12f * thick, 8);
        }
        k.add(shapes::ball(beam(0.01f), Vec3f{0.03f, 0.018f, 0.03f} * (size / 0.55f), 12), horn);
    }
}

// A shield of wood.
void shield_of_wood(Kit& k, int wood, float half, float low, float high, float thick) {
    std::vector<Vec2f> o;
    for (int i = 0; i < 40; ++i) {
        const float a = kTau * static_cast<float>(i) / 40.f, y = std::sin(a);
        const float x = half * std::cos(a) * (y > 0 ? 1.f : 1.f - 0.35f * y * y);
        o.push_back({x, -(0.5f * (low + high) + 0.5f * (high - low) * y)});
    }
    Mesh m = shapes::prism(o, 0.f, thick, 0.006f);
    shapes::turn(m, {1, 0, 0}, 90);
    k.add(std::move(m), wood);
}

}  // namespace

void build_antlers(Kit& k) {
    const int horn = k.main(plain("antler", {0.36f, 0.25f, 0.15f}, 0.6f)), wood = k.material(k.style.wood),
              bone = k.material(plain("bone", {0.66f, 0.6f, 0.48f}, 0.7f));
    shield_of_wood(k, wood, 0.11f, 0.f, 0.27f, 0.022f);
    k.add(shapes::ball({0, 0.17f, 0.035f}, {0.058f, 0.05f, 0.03f}, 20), bone);
    antler_pair(k, horn, {0.032f, 0.205f, 0.045f}, 0.5f);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.5f;
}

void build_deer_head(Kit& k) {
    const int coat = k.main(plain("deer hide", {0.27f, 0.16f, 0.085f}, 0.95f)), wood = k.material(k.style.wood),
              horn = k.material(plain("antler", {0.4f, 0.3f, 0.19f}, 0.6f)),
              dark = k.material(plain("muzzle", {0.035f, 0.03f, 0.028f}, 0.35f)),
              pale = k.material(plain("pale hide", {0.5f, 0.4f, 0.29f}, 0.95f));
    shield_of_wood(k, wood, 0.15f, 0.f, 0.42f, 0.024f);
    // The neck out of the shield and up; the head forward from it.
    k.add(limb({{0, 0.17f, 0.012f}, {0, 0.18f, 0.07f}, {0, 0.26f, 0.16f}, {0, 0.36f, 0.21f}, {0, 0.4f, 0.22f}},
               {{0.12f, 0.15f}, {0.115f, 0.145f}, {0.085f, 0.1f}, {0.062f, 0.075f}, {0.05f, 0.05f}}, 24),
          coat);
    k.add(limb({{0, 0.425f, 0.14f},
                {0, 0.42f, 0.17f},
                {0, 0.405f, 0.235f},
                {0, 0.375f, 0.31f},
                {0, 0.345f, 0.375f},
                {0, 0.335f, 0.4f}},
               {{0.012f, 0.012f}, {0.06f, 0.05f}, {0.072f, 0.07f}, {0.05f, 0.053f}, {0.038f, 0.037f}, {0.008f, 0.008f}},
               24),
          coat);
    k.add(shapes::ball({0, 0.345f, 0.392f}, {0.026f, 0.019f, 0.018f}, 14), dark);
    k.add(shapes::ball({0, 0.318f, 0.37f}, {0.027f, 0.016f, 0.03f}, 14), pale);
    for (const float sx : {-1.f, 1.f}) {
        k.add(shapes::ball({sx * 0.061f, 0.417f, 0.262f}, {0.011f, 0.013f, 0.015f}, 12), dark);
        // Ears: out and up a little, hollow to the front.
        Mesh ear = shapes::ball({0, 0, 0}, {0.032f, 0.078f, 0.013f}, 16),
             hollow = shapes::ball({0, 0.002f, 0.006f}, {0.021f, 0.062f, 0.011f}, 14);
        for (Mesh* m : {&ear, &hollow})
            shapes::turn(*m, {0, 0, 1}, -sx * 62.f), shapes::move(*m, {sx * 0.118f, 0.455f, 0.175f});
        k.add(std::move(ear), coat);
        k.add(std::move(hollow), pale);
    }
    antler_pair(k, horn, {0.03f, 0.46f, 0.19f}, 0.52f);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.3f;
}

}  // namespace fastscene::furniture
