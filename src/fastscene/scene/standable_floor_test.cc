#include "fastscene/scene/standable_floor.h"

#include <gtest/gtest.h>

#include "fastscene/base/random.h"
#include "fastscene/scene/walkable.h"

namespace fastscene {
namespace {

StandableFloor floor_of(int columns, int rows) {
    StandableFloor floor{.corner_m = {-1, 2}, .columns = columns, .rows = rows};
    floor.standable.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
    return floor;
}

// For any floor, the rings contain exactly the centers of its standable cells.
TEST(StandableFloor, OutlinesHoldItsCellsAndNothingElse) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        StandableFloor floor = floor_of(12, 9);
        Random random(seed, "test.floor");
        for (std::uint8_t& cell : floor.standable) cell = random.chance(0.6f);
        const WalkableArea area{outlines(floor), 0, 0, 0};
        double signed_sum = 0;
        for (const auto& ring : area.rings_m) {
            EXPECT_GE(ring.size(), 4u);
            signed_sum += signed_area(ring);
            for (std::size_t i = 0; i < ring.size(); ++i) {  // no collinear vertices
                const Vec2f a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
                EXPECT_NE((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x), 0.f);
            }
        }
        for (int row = 0; row < floor.rows; ++row)
            for (int column = 0; column < floor.columns; ++column)
                EXPECT_EQ(contains(area, floor.center(column, row)), floor.at(column, row))
                    << seed << ' ' << column << ' ' << row;
        EXPECT_NEAR(std::abs(signed_sum), standable_area_m2(floor), 1e-4) << "outer rings and holes turn opposite ways";
    }
}

TEST(StandableFloor, ARoomWithAnIslandHasTwoRings) {
    StandableFloor floor = floor_of(8, 8);
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 8; ++column)
            floor.standable[static_cast<std::size_t>(8 * row + column)] = !(row > 2 && row < 5 && column > 2 &&
                                                                            column < 6);
    const auto rings = outlines(floor);
    ASSERT_EQ(rings.size(), 2u);
    EXPECT_EQ(rings[0].size(), 4u);
    EXPECT_EQ(rings[1].size(), 4u);
    EXPECT_NEAR(std::abs(signed_area(rings[0])), 0.64, 1e-5);
    EXPECT_NEAR(std::abs(signed_area(rings[1])), 0.06, 1e-5);
    EXPECT_TRUE(outlines(floor_of(3, 3)).empty());
}

}  // namespace
}  // namespace fastscene
