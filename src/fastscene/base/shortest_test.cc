#include "fastscene/base/shortest.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "fastscene/base/json.h"
#include "fastscene/base/random.h"

namespace fastscene {
namespace {

TEST(Shortest, FloatsAreWrittenAsPeopleWriteThem) {
    EXPECT_EQ(Json(shortest(0.42f)).dump(), "0.42");
    EXPECT_EQ(Json(shortest(-0.1f)).dump(), "-0.1");
    EXPECT_EQ(Json(shortest(3.f)).dump(), "3.0");
    EXPECT_EQ(Json(shortest(0.70710678f)).dump(), "0.70710677");
    EXPECT_TRUE(std::isinf(shortest(std::numeric_limits<float>::infinity())));
    EXPECT_TRUE(std::isnan(shortest(std::numeric_limits<float>::quiet_NaN())));
}

TEST(Shortest, ReadBackEveryFloatIsTheSame) {
    Random random(1, "floats");
    for (int i = 0; i < 200000; ++i) {
        const auto bits = static_cast<std::uint32_t>(random.index(1 << 16)) << 16 |
                          static_cast<std::uint32_t>(random.index(1 << 16));
        const float value = std::bit_cast<float>(bits);
        if (!std::isfinite(value)) continue;
        const auto back = static_cast<float>(Json::parse(Json(shortest(value)).dump()).get<double>());
        ASSERT_EQ(std::bit_cast<std::uint32_t>(back), bits) << value;
    }
}

}  // namespace
}  // namespace fastscene
