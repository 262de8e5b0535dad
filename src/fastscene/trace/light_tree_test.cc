#include "fastscene/trace/light_tree.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fastscene/base/random.h"

namespace fastscene {
namespace {

using Corners = std::array<Vec3f, 3>;

Vec3f somewhere(Random& rng, float reach) {
    return {rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)};
}
Vec3f some_way(Random& rng) {
    Vec3f v = somewhere(rng, 1);
    while (length(v) < 0.1f) v = somewhere(rng, 1);
    return normalize(v);
}

// Clusters of small triangles around a room; one in twenty has no power, a third are two-sided.
struct Lamps {
    std::vector<Corners> corners;
    std::vector<LightTree::Emitter> emitters;
    explicit Lamps(int clumps, int each) {
        Random rng(3, "lamps");
        for (int k = 0; k < clumps; ++k) {
            const Vec3f middle = somewhere(rng, 2);
            for (int i = 0; i < each; ++i) {
                Corners c;
                for (Vec3f& p : c) p = middle + somewhere(rng, 0.1f);
                LightTree::Emitter e{c[0],
                                     c[0],
                                     (c[0] + c[1] + c[2]) / 3.f,
                                     normalize(cross(c[1] - c[0], c[2] - c[0])),
                                     k % 3 == 0,
                                     i % 20 == 7 ? 0.f : rng.uniform(0.1f, 2)};
                for (const Vec3f p : c)
                    for (std::size_t a = 0; a < 3; ++a)
                        e.low[a] = std::min(e.low[a], p[a]), e.high[a] = std::max(e.high[a], p[a]);
                corners.push_back(c);
                emitters.push_back(e);
            }
        }
    }
};

TEST(LightTree, ChancesAreThoseOfDrawing) {
    const Lamps lamps(40, 30);
    const LightTree tree(lamps.emitters);
    Random rng(4, "places");
    for (int k = 0; k < 20; ++k) {
        const Vec3f at = somewhere(rng, 2), normal = some_way(rng);
        double sum = 0;
        for (std::size_t i = 0; i < lamps.emitters.size(); ++i)
            sum += tree.probability(static_cast<int>(i), at, normal);
        int found = 0;
        constexpr int kDraws = 400;
        for (int s = 0; s < kDraws; ++s) {
            const LightTree::SampledEmitter drawn = tree.draw(at, normal, rng.uniform());
            if (drawn.emitter < 0) continue;  // a node may overestimate: no emitter in it reaches the point
            ++found;
            ASSERT_GT(lamps.emitters[static_cast<std::size_t>(drawn.emitter)].power, 0);
            ASSERT_NEAR(tree.probability(drawn.emitter, at, normal) / drawn.probability, 1, 1e-3);
        }
        ASSERT_NEAR(sum, found / static_cast<double>(kDraws), 0.1);
    }
}

// A light that can reach a point must never have probability 0, or the point would be too dark.
TEST(LightTree, WhatShinesHasAChance) {
    const Lamps lamps(30, 40);
    const LightTree tree(lamps.emitters);
    Random rng(5, "places");
    int shining = 0;
    for (int k = 0; k < 60'000; ++k) {
        const auto i = static_cast<std::size_t>(rng.index(static_cast<int>(lamps.emitters.size())));
        const LightTree::Emitter& e = lamps.emitters[i];
        const Vec3f at = k % 2 ? somewhere(rng, 2) : e.center + somewhere(rng, 0.15f), normal = some_way(rng);
        const float u = rng.uniform(), v = rng.uniform() * (1 - u);
        const Vec3f to = lamps.corners[i][0] * (1 - u - v) + lamps.corners[i][1] * u + lamps.corners[i][2] * v - at;
        const float there = -dot(e.normal, normalize(to)), here = dot(normal, normalize(to));
        if (!(e.power > 0 && here > 0.01f && (e.two_sided ? std::abs(there) : there) > 0.01f)) continue;
        ++shining;
        ASSERT_GT(tree.probability(static_cast<int>(i), at, normal), 0) << k;
    }
    EXPECT_GT(shining, 10'000);
}

TEST(LightTree, OfNothingNothingIsDrawn) {
    EXPECT_LT(LightTree({}).draw({}, {0, 1, 0}, 0.5f).emitter, 0);
    // Many at one position, all facing the same wall.
    const LightTree::Emitter e{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}, false, 1};
    const LightTree same(std::vector(5000, e));
    EXPECT_GE(same.draw({}, {0, 0, 1}, 0.3f).emitter, 0);
    EXPECT_LT(same.draw({}, {0, 0, -1}, 0.3f).emitter, 0);
    EXPECT_NEAR(same.probability(17, {}, {0, 0, 1}), 1 / 5000., 1e-6);
}

}  // namespace
}  // namespace fastscene
