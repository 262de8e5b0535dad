#include "fastscene/inpaint/harmonic_sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fastscene {
namespace {

TEST(HarmonicSphere, FillsACapWithoutStreaksAndAcrossTheSeam) {
    // Known above 30 degrees below the horizon; the floor is missing. Its rim is red on one side, blue on the other.
    ImageColor color(128, 64);
    ImageMask hole(128, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 128; ++x) {
            const float side = 0.5f +
                               0.4f * std::cos((static_cast<float>(x) + 0.5f) / 128 * 2 * std::numbers::pi_v<float>);
            color.at(x, y) = {side, 0.3f, 1 - side};
            if (y > 42) hole.at(x, y) = 255, color.at(x, y) = {};
        }
    const ImageColor out = filled_on_sphere(color, hole, {});
    for (int x = 0; x < 128; ++x) {
        EXPECT_EQ(out.at(x, 10), color.at(x, 10));
        EXPECT_NEAR(out.at(x, 63).x, 0.5f, 0.03f) << x;  // the pole is one color: the mean
        EXPECT_NEAR(out.at(x, 50).y, 0.3f, 1e-3f) << x;
        EXPECT_LT(std::fabs(out.at(x, 43).x - color.at(x, 42).x), 0.05f) << x;  // continues
    }
    EXPECT_LT(std::fabs(out.at(0, 50).x - out.at(127, 50).x), 0.02f);
    EXPECT_GT(out.at(0, 50).x, out.at(64, 50).x);
}

TEST(HarmonicSphere, NothingOrEverythingMissing) {
    const ImageColor color(32, 16, Vec3f{0.2f, 0.4f, 0.6f});
    EXPECT_EQ(filled_on_sphere(color, ImageMask(32, 16), {}), color);
    EXPECT_EQ(filled_on_sphere(color, ImageMask(32, 16, 255), {}), ImageColor(32, 16));
    ImageMask odd(32, 16, 255);
    odd.at(3, 3) = 0;
    const ImageColor out = filled_on_sphere(color, odd, {});
    EXPECT_NEAR(out.at(20, 12).z, 0.6f, 1e-3f);
}

}  // namespace
}  // namespace fastscene
