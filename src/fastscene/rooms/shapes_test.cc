#include "fastscene/rooms/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace fastscene::shapes {
namespace {

// A closed skin meets every edge (by place) as often in one direction as in the other.
bool is_closed(const Mesh& m) {
    using Place = std::tuple<long, long, long>;
    const auto place = [&](std::uint32_t i) {
        return Place{std::lround(m.positions[i].x * 2e4f), std::lround(m.positions[i].y * 2e4f),
                     std::lround(m.positions[i].z * 2e4f)};
    };
    std::map<std::pair<Place, Place>, int> balance;
    for (std::size_t t = 0; t < m.triangles.size(); t += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const Place a = place(m.triangles[t + k]), b = place(m.triangles[t + (k + 1) % 3]);
            if (a == b) continue;
            if (a < b) ++balance[{a, b}];
            else --balance[{b, a}];
        }
    for (const auto& [edge, count] : balance)
        if (count != 0) return false;
    return true;
}

constexpr std::array<Vec2f, 4> kProfile{Vec2f{0.1f, 0}, {0.2f, 0.1f}, {0.15f, 0.3f}, {0.1f, 0.4f}};

TEST(Shapes, SolidsAreClosedAndFaceOutward) {
    const std::array<Vec3f, 3> path{Vec3f{0, 0, 0}, {0, 0.5f, 0}, {0.3f, 0.8f, 0.1f}};
    const std::vector<std::pair<const char*, Mesh>> solids{
        {"box", box({0.5f, 0.3f, 0.2f}, 0.01f)},
        {"soft", soft_box({0.6f, 0.2f, 0.5f}, {})},
        {"pillow", pillow({0.5f, 0.4f, 0.15f}, 3)},
        {"lathe", lathe(kProfile)},
        {"smooth lathe", lathe(kProfile, 20, true)},
        {"vessel", vessel(kProfile, 0.01f)},
        {"rod", rod({0, 0, 0}, {0.3f, 0.4f, 0.5f}, 0.02f, 0.01f)},
        {"ball", ball({1, 2, 3}, {0.2f, 0.3f, 0.1f})},
        {"tube", tube(path, 0.02f)},
        {"ring", ring(0.3f, 0.04f)},
        {"prism", prism(rounded_rectangle(1.f, 0.6f, 0.1f), 0.f, 0.05f)},
        {"disc", prism(circle(0.5f), 0.f, 0.02f)},
        {"slab", slab(8, 6, 0.02f, [](float u, float v) {
             return Vec3f{u, 0.1f * std::sin(4 * u), -v};
         })}};
    const std::array<Limb, 3> limbs{{{{0, 0.1f, 0}, {0, 0.1f, 0.4f}, 0.1f, 0.06f},
                                     {{0.05f, 0.1f, 0.1f}, {0.2f, 0.02f, 0.1f}, 0.04f, 0.03f},
                                     {{0, 0.1f, 0.4f}, {0, 0.2f, 0.5f}, 0.03f, 0.f}}};
    std::vector<std::pair<const char*, Mesh>> all = solids;
    all.emplace_back("skin", skin(limbs, 0.03f, 0.013f));
    for (const auto& [name, m] : all) {
        EXPECT_TRUE(is_closed(m)) << name;
        Mesh at_origin = m;
        EXPECT_GT(signed_volume(at_origin), 0.f) << name;
        for (std::size_t t = 0; t < m.triangles.size(); t += 3) {
            const Vec3f a = m.positions[m.triangles[t]], b = m.positions[m.triangles[t + 1]],
                        c = m.positions[m.triangles[t + 2]];
            ASSERT_FALSE(a == b || b == c || a == c) << name << ": a triangle without area";
        }
        for (const Vec3f n : m.normals) ASSERT_NEAR(length(n), 1.f, 1e-3f) << name;
        EXPECT_EQ(m.coords.size(), m.positions.size()) << name;
    }
}

TEST(Shapes, BoxesKeepTheirSizeAndLoseOnlyTheirEdges) {
    const Mesh m = box({0.5f, 0.3f, 0.2f}, 0.01f);
    const Box b = bounds(m);
    EXPECT_NEAR(b.high.x - b.low.x, 0.5f, 1e-5f);
    EXPECT_NEAR(b.high.y - b.low.y, 0.3f, 1e-5f);
    EXPECT_NEAR(signed_volume(m), 0.03f, 0.0004f);
    const Box soft = bounds(soft_box({0.6f, 0.2f, 0.5f}, {}));
    EXPECT_NEAR(soft.high.x - soft.low.x, 0.6f, 0.03f);
    EXPECT_NEAR(soft.high.y - soft.low.y, 0.2f, 0.03f);
}

TEST(Shapes, GrainRunsAlongTheLongSide) {
    for (const Vec3f size : {Vec3f{2, 0.1f, 0.3f}, Vec3f{0.1f, 2, 0.3f}, Vec3f{0.1f, 0.3f, 2}}) {
        const Mesh m = box(size);
        float low = 1e9f, high = -1e9f;
        for (const Vec3f c : m.coords) {
            low = std::min(low, c.y);
            high = std::max(high, c.y);
        }
        EXPECT_NEAR(high - low, 2.f, 1e-4f);
    }
}

}  // namespace
}  // namespace fastscene::shapes
