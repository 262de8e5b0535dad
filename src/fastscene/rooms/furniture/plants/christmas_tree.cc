// Christmas tree.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {
namespace {

// A needle-like solid of four triangles from `base`, `wide` across, to a point.
void spike(Mesh& into, Vec3f base, Vec3f tip, float wide) {
    const Vec3f along = normalize(tip - base),
                side = normalize(cross(along, std::abs(along.y) < 0.9f ? Vec3f{0, 1, 0} : Vec3f{1, 0, 0})),
                up = cross(side, along);
    Mesh m;
    for (int i = 0; i < 3; ++i) {
        const float a = kTau * static_cast<float>(i) / 3.f;
        m.positions.push_back(base + (side * std::cos(a) + up * std::sin(a)) * wide);
    }
    m.positions.push_back(tip);
    m.triangles = {0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 2, 1};
    m.normals.assign(4, Vec3f{0, 1, 0});
    if (shapes::signed_volume(m) < 0)
        for (std::size_t t = 0; t < m.triangles.size(); t += 3) std::swap(m.triangles[t + 1], m.triangles[t + 2]);
    shapes::smooth_normals(m);
    shapes::lay_grain(m);
    shapes::append(into, m);
}

}  // namespace

// A fir on a stand: tiers of twigs that hang outward, baubles, small lights, a star, presents below.
void build_christmas_tree(Kit& k) {
    const float high = (k.request.size_m.y > 0.6f ? k.request.size_m.y : 1.85f * k.request.size_factor),
                wide = 0.3f * high, bare = 0.14f * high;
    k.sized = true;
    Material needles = plain("fir needles", {0.03f, 0.095f, 0.045f}, 0.85f);
    const int green = k.main(needles), trunk = k.material(plain("trunk", {0.12f, 0.07f, 0.04f}, 0.9f)),
              metal = k.material(k.style.metal);
    k.rod(trunk, {0, 0.02f, 0}, {0, 0.92f * high, 0}, 0.03f, 0.008f, 10);
    for (int i = 0; i < 3; ++i) {
        const float a = 2.0944f * static_cast<float>(i);
        k.rod(metal, {0.22f * std::sin(a), 0.012f, 0.22f * std::cos(a)}, {0, 0.1f, 0}, 0.012f, -1, 8);
    }
    // Each tier: boughs all around, fuller and lower at their tips, that reach below the tier under it.
    constexpr int kTiers = 11;
    Mesh boughs;
    for (int tier = 0; tier < kTiers; ++tier) {
        const float t = static_cast<float>(tier) / (kTiers - 1), y = bare + (0.93f * high - bare) * (0.1f + 0.9f * t),
                    r = wide * (1.02f - 0.93f * t);
        const int around = 9 + static_cast<int>(14.f * (1.f - t));
        for (int i = 0; i < around; ++i) {
            const float a = kTau *
                            (static_cast<float>(i) + 0.5f * static_cast<float>(tier % 2) + k.rng.uniform(-0.2f, 0.2f)) /
                            static_cast<float>(around),
                        reach = r * k.rng.uniform(0.86f, 1.08f), drop = 0.34f * reach + k.rng.uniform(0.f, 0.03f),
                        c = std::cos(a), s = std::sin(a);
            const Vec3f tip{reach * c, y - drop, reach * s}, root{0.06f * reach * c, y + 0.05f, 0.06f * reach * s},
                out = normalize(tip - root);
            const Vec3f side = normalize(cross(out, Vec3f{0, 1, 0}));
            spike(boughs, root, tip, 0.05f);
            // Twigs to both sides, a flat spray.
            for (int j = 0; j < 6; ++j) {
                const float at = 0.25f + 0.13f * static_cast<float>(j), twig = (0.3f - 0.18f * at) * reach + 0.03f;
                for (const float way : {-1.f, 1.f}) {
                    const Vec3f from = lerp(root, tip, at);
                    spike(boughs, from,
                          from + out * (0.7f * twig) + side * (way * 0.75f * twig) - Vec3f{0, 0.2f * twig, 0}, 0.024f);
                }
            }
        }
    }
    k.add(std::move(boughs), green);
    // Baubles at the tips in the colors of the feast, lights between them.
    static constexpr std::array<Vec3f, 3> kBaubles{Vec3f{0.5f, 0.02f, 0.03f}, {0.6f, 0.4f, 0.1f}, {0.62f, 0.6f, 0.56f}};
    std::array<int, 3> baubles{};
    for (std::size_t i = 0; i < 3; ++i) baubles[i] = k.material(plain("bauble", kBaubles[i], 0.12f));
    Material bulb = glow("tree light", Vec3f{13.f, 7.4f, 2.6f} * 1.5f);
    bulb.pattern = Pattern::screen;  // lit at any hour
    const int light = k.material(bulb);
    constexpr int kThings = 92;
    for (int i = 0; i < kThings; ++i) {
        // Evenly over the cone: more where it is wide.
        const float t = 1.f - std::sqrt((static_cast<float>(i) + 0.5f) / kThings), a = 2.39996f * static_cast<float>(i),
                    y = bare + (0.9f * high - bare) * t - 0.04f,
                    r = wide * (1.f - 0.93f * t) * k.rng.uniform(0.84f, 0.97f);
        const Vec3f at{r * std::cos(a), y - 0.2f * r, r * std::sin(a)};
        const float size = i % 3 == 0 ? 0.024f + 0.012f * k.rng.uniform() : 0.013f;
        k.add(shapes::ball(at, {size, size, size}, i % 3 == 0 ? 12 : 6),
              i % 3 == 0 ? baubles[static_cast<std::size_t>(i / 3) % 3] : light);
    }
    // The star: five points, front and back.
    const int gold = k.material(*material_named("brass"));
    Mesh points = shapes::prism(star(0.085f, 0.036f), -0.012f, 0.012f, 0.003f);
    shapes::turn(points, {1, 0, 0}, 90);
    k.add(std::move(points), gold, {0, high - 0.075f, 0});
    // Presents, tied with ribbons.
    static constexpr std::array<Vec3f, 4> kPaper{
        Vec3f{0.45f, 0.03f, 0.04f}, {0.05f, 0.2f, 0.1f}, {0.62f, 0.58f, 0.5f}, {0.12f, 0.16f, 0.36f}};
    for (int i = 0; i < 4; ++i) {
        const float a = 0.7f + 1.5f * static_cast<float>(i) + k.rng.uniform(-0.2f, 0.2f), far = 0.62f * wide;
        const Vec3f size{k.rng.uniform(0.16f, 0.26f), k.rng.uniform(0.08f, 0.18f), k.rng.uniform(0.13f, 0.2f)},
            at{far * std::sin(a), 0, far * std::cos(a)};
        const int paper = k.material(plain("wrapping paper", kPaper[static_cast<std::size_t>(i)], 0.35f)),
                  ribbon = k.material(plain("ribbon", i % 2 ? kBaubles[0] : kBaubles[1], 0.3f));
        k.board(paper, at, size, 0.003f);
        k.board(ribbon, at, {0.02f, size.y + 0.002f, size.z + 0.003f}, 0.001f);
        k.board(ribbon, at, {size.x + 0.003f, size.y + 0.002f, 0.02f}, 0.001f);
        for (const float s : {-1.f, 1.f})
            k.add(shapes::ball(at + Vec3f{s * 0.022f, size.y + 0.014f, 0}, {0.024f, 0.014f, 0.01f}, 8), ribbon);
    }
    k.piece.clearance_front_m = 0.3f;
}

}  // namespace fastscene::furniture
