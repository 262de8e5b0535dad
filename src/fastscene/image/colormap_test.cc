#include "fastscene/image/colormap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fastscene {
namespace {

TEST(Colormap, GoesFromBlueToRed) {
    const Rgb8 low = turbo(0.15f), middle = turbo(0.5f), high = turbo(0.9f);
    EXPECT_TRUE(low.b > low.r && low.b > low.g);
    EXPECT_TRUE(middle.g > middle.r && middle.g > middle.b);
    EXPECT_TRUE(high.r > high.g && high.r > high.b);
    EXPECT_EQ(turbo(-3), turbo(0));
    EXPECT_EQ(turbo(9), turbo(1));
}

TEST(Colormap, WhatIsUnknownIsBlack) {
    ImageF values(4, 1, 2.f);
    values.at(0, 0) = 0;
    values.at(1, 0) = std::nanf("");
    values.at(2, 0) = std::numeric_limits<float>::infinity();
    const ImageRgb8 picture = colored(values, 0, 4);
    for (int x = 0; x < 3; ++x) EXPECT_EQ(picture.at(x, 0), Rgb8{});
    EXPECT_EQ(picture.at(3, 0), turbo(0.5f));
}

}  // namespace
}  // namespace fastscene
