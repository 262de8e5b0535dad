#include "fastscene/geometry/outlook.h"

#include <gtest/gtest.h>

#include <limits>

#include "fastscene/base/random.h"

namespace fastscene {
namespace {

constexpr float kOutside = std::numeric_limits<float>::infinity();

TEST(Outlook, GoesOnAlongTheRows) {
    ImageColor color(64, 32);
    ImageF range(64, 32, 2.f);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) color.at(x, y) = {static_cast<float>(y), 0, x < 20 || x > 44 ? 9.f : 1.f};
    EXPECT_TRUE(outside_picture(color, range).empty());
    for (int y = 8; y < 24; ++y)
        for (int x = 20; x <= 44; ++x) range.at(x, y) = kOutside;
    const ImageColor out = outside_picture(color, range);
    for (int y = 12; y < 20; ++y)
        for (int x = 0; x < 64; ++x) {
            EXPECT_NEAR(out.at(x, y).x, static_cast<float>(y), 1.5f) << x;  // layers are preserved
            EXPECT_FLOAT_EQ(out.at(x, y).z, 1.f);                           // no color of the wall
        }
    EXPECT_FLOAT_EQ(out.at(0, 0).z, 1.f);
    for (const Vec3f& c : out.pixels) EXPECT_TRUE(c.x >= 9.f && c.x <= 22.f);  // pixels surrounded by outside
    EXPECT_EQ(out.at(30, 16), color.at(30, 16));
}

// A hedge behind a window: the part hidden by a curtain is as bright as the hedge, without streaks from the window's
// border.
TEST(Outlook, WhatWasNotSeenIsSmoothAndAsBright) {
    ImageColor color(256, 128, Vec3f{1, 1, 1});
    ImageF range(256, 128, 2.f);
    Random rng(1, "hedge");
    float seen = 0, count = 0;
    for (int y = 40; y < 90; ++y)
        for (int x = 100; x < 140; ++x) {
            range.at(x, y) = kOutside;
            const float v = rng.chance(0.3f) ? 0.02f : rng.uniform(0.2f, 0.4f);
            color.at(x, y) = {v, v, v};
            seen += v;
            ++count;
        }
    const ImageColor out = outside_picture(color, range);
    float mean = 0, step = 0, invented = 0;
    for (int y = 42; y < 88; ++y)
        for (int x = 146; x < 170; ++x) {
            mean += out.at(x, y).x;
            step += std::fabs(out.at(x, y + 1).x - out.at(x, y).x);
            ++invented;
        }
    EXPECT_NEAR(mean / invented, seen / count, 0.1f * seen / count);
    EXPECT_LT(step / invented, 0.02f * seen / count);
}

}  // namespace
}  // namespace fastscene
