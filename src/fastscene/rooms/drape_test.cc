// Cloth that falls: it stays outside of what it lies on, keeps its size, hangs down, comes to rest.
#include "fastscene/rooms/drape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/rooms/shapes.h"

namespace fastscene {
namespace {

const DrapeSolid kBox{{0, 0.25f, 0}, {0.5f, 0.25f, 0.7f}, 0.05f};

Cloth over_box(std::uint32_t seed = 1) {
    Cloth cloth;
    cloth.low = {-0.75f, -0.4f}, cloth.high = {0.75f, 0.95f};
    cloth.from_y = 0.52f;
    cloth.seed = seed;
    return cloth;
}

float distance_from(const DrapeSolid& s, Vec3f p) {
    Vec3f q;
    for (std::size_t a = 0; a < 3; ++a) q[a] = std::fabs(p[a] - s.center[a]) - (s.half[a] - s.round_m);
    const Vec3f outside{std::max(q.x, 0.f), std::max(q.y, 0.f), std::max(q.z, 0.f)};
    return length(outside) + std::min(0.f, std::max({q.x, q.y, q.z})) - s.round_m;
}

TEST(Drape, ClothStaysOutsideOfSolidsAndAboveTheFloor) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        const Cloth cloth = over_box(seed);
        for (const Vec3f p : drape(cloth, {&kBox, 1}).points) {
            EXPECT_GT(distance_from(kBox, p), cloth.clear_m - 1e-3f);
            EXPECT_GE(p.y, cloth.clear_m);
        }
    }
}

TEST(Drape, ClothLiesOnTopAndHangsAtTheSides) {
    const DrapedCloth cloth = drape(over_box(), {&kBox, 1});
    EXPECT_NEAR(cloth.at(0.5f, 0.3f).y, 0.5f, 0.06f) << "on the box";
    for (const float u : {0.f, 1.f}) {
        const Vec3f hem = cloth.at(u, 0.3f);
        EXPECT_LT(hem.y, 0.36f) << "a quarter of a metre of cloth is beyond the edge";
        EXPECT_NEAR(std::fabs(hem.x), 0.55f, 0.08f) << "and hangs down along the side";
    }
    EXPECT_LT(cloth.at(0.5f, 1).y, 0.36f) << "so does the foot";
}

TEST(Drape, ClothKeepsItsSize) {
    const DrapedCloth cloth = drape(over_box(), {&kBox, 1});
    const float cell = cloth.size_m.x / static_cast<float>(cloth.columns);
    std::vector<float> stretched;
    for (int j = 0; j <= cloth.rows; ++j)
        for (int i = 0; i < cloth.columns; ++i) {
            const auto k = static_cast<std::size_t>(j * (cloth.columns + 1) + i);
            stretched.push_back(length(cloth.points[k + 1] - cloth.points[k]) / cell);
        }
    std::sort(stretched.begin(), stretched.end());
    const std::size_t count = stretched.size();
    EXPECT_NEAR(stretched[count / 2], 1, 0.03f);
    EXPECT_LT(stretched[count * 95 / 100], 1.3f) << "but for edges, where it resists bending";
    EXPECT_GT(stretched[count / 20], 0.85f);
}

TEST(Drape, ClothIsTuckedInWhereItMayNotReach) {
    Cloth cloth = over_box();
    cloth.most = {0.56f, 0.76f};
    for (const Vec3f p : drape(cloth, {&kBox, 1}).points) {
        EXPECT_LE(std::fabs(p.x), cloth.most.x);
        EXPECT_LE(std::fabs(p.z), cloth.most.y);
    }
}

TEST(Drape, SameSeedSameCloth) {
    const DrapedCloth one = drape(over_box(4), {&kBox, 1}), same = drape(over_box(4), {&kBox, 1}),
                      other = drape(over_box(5), {&kBox, 1});
    EXPECT_EQ(one.points, same.points);
    EXPECT_NE(one.points, other.points);
}

TEST(Drape, MeshIsClosedAndAsThickAsCloth) {
    const DrapedCloth cloth = drape(over_box(), {&kBox, 1});
    const float area = cloth.size_m.x * cloth.size_m.y, thick = 0.02f;
    EXPECT_NEAR(shapes::signed_volume(cloth_mesh(cloth, thick)), area * thick, 0.25f * area * thick);
}

}  // namespace
}  // namespace fastscene
