#include "fastscene/depth/painted_room.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr EquirectSize kSmall{128, 64};

DepthExample room(std::uint64_t i) {
    Random rng(11, "painted", i);
    return painted_room(kSmall, rng);
}

TEST(PaintedRoom, DependsOnTheGeneratorOnly) {
    EXPECT_EQ(room(3).color, room(3).color);
    EXPECT_EQ(room(3).range, room(3).range);
    EXPECT_NE(room(3).range, room(4).range);
}

TEST(PaintedRoom, IsARoomAroundTheCamera) {
    for (std::uint64_t i = 0; i < 40; ++i) {
        const DepthExample e = room(i);
        double unknown = 0, light = 0;
        for (std::size_t k = 0; k < e.range.size(); ++k) {
            ASSERT_TRUE(std::isfinite(e.range.pixels[k]) && e.range.pixels[k] >= 0 && e.range.pixels[k] < 12) << i;
            ASSERT_TRUE(e.range.pixels[k] == 0 || e.range.pixels[k] > 0.2f) << i;  // nothing touches the camera
            unknown += e.range.pixels[k] == 0;
            light += luminance(linear_from_srgb8(e.color.pixels[k]));
        }
        EXPECT_LT(unknown / static_cast<double>(e.range.size()), 0.5) << i;  // windows
        light /= static_cast<double>(e.range.size());
        EXPECT_TRUE(light > 0.1 && light < 0.5) << i << ": " << light;
        // Straight down is the floor or something on it; the floor is at most 2 m below.
        EXPECT_LT(e.range.at(5, kSmall.height - 1), 2.01f);
    }
}

// The room is a box: along a wall, range times the cosine to its normal is constant. Most neighbouring rays at the
// equator must satisfy that.
TEST(PaintedRoom, SurfacesAreFlatForTheMostPart) {
    int flat = 0, all = 0;
    for (std::uint64_t i = 0; i < 20; ++i) {
        const DepthExample e = room(i);
        for (int x = 1; x + 1 < kSmall.width; ++x) {
            const float a = e.range.at(x - 1, 30), b = e.range.at(x, 30), c = e.range.at(x + 1, 30);
            if (!(a > 0 && b > 0 && c > 0)) continue;
            // For three equally spaced rays to a plane, 1/range is linear up to the cosine of the step.
            const float step = 2 * 3.14159265f / kSmall.width;
            flat += std::abs((1 / a + 1 / c) / (2 * std::cos(step)) - 1 / b) < 0.02f / b;
            ++all;
        }
    }
    EXPECT_GT(flat, 0.75 * all);
}

}  // namespace
}  // namespace fastscene
