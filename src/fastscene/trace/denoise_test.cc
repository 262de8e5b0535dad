#include "fastscene/trace/denoise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"

namespace fastscene {
namespace {

constexpr int kWidth = 64, kHeight = 32;
constexpr float kNoise = 0.1f;

// A wall facing the camera, evenly lit, plus noise of known size.
struct Wall {
    NoisyLight light{ImageColor(kWidth, kHeight), ImageF(kWidth, kHeight, kNoise* kNoise)};
    Guides guides{ImageColor(kWidth, kHeight), ImageColor(kWidth, kHeight, {0, 0, -1}), true};
    explicit Wall(float level_right = 1.f) {
        Random random(3, "wall");
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const float v = (x < kWidth / 2 ? 1.f : level_right) + kNoise * random.normal();
                light.value.at(x, y) = {v, v, v};
                guides.position.at(x, y) = {0.01f * static_cast<float>(x), 0.01f * static_cast<float>(y), 2};
            }
    }
};
float spread(const ImageColor& image, float wanted, int x0, int x1) {
    float sum = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = x0; x < x1; ++x) sum += (image.at(x, y).x - wanted) * (image.at(x, y).x - wanted);
    return std::sqrt(sum / static_cast<float>(image.height * (x1 - x0)));
}

TEST(Denoise, EvenLightBecomesEven) {
    Wall wall;
    denoise(wall.light, wall.guides, 4);
    EXPECT_LT(spread(wall.light.value, 1, 0, kWidth), kNoise / 6);
    EXPECT_LT(wall.light.variance.at(20, 16), kNoise * kNoise / 36);
}

TEST(Denoise, ASpeckThatKnowsItselfGoes) {
    Wall wall;
    wall.light.value.at(30, 12) = {9, 9, 9};
    wall.light.variance.at(30, 12) = 64;  // one of sixteen rays hit the lamp
    denoise(wall.light, wall.guides, 4);
    EXPECT_LT(wall.light.value.at(30, 12).x, 1.6f);
}

// Four rays that all missed the lamp agree with each other; the surrounding pixels, with a hundred rays each, know the
// true variance.
TEST(Denoise, AFewRaysThatAgreeAreNotBelieved) {
    Wall wall;
    wall.guides.rays = ImageF(kWidth, kHeight, 100.f);
    wall.guides.rays.at(30, 12) = 4;
    wall.light.value.at(30, 12) = {0.2f, 0.2f, 0.2f};
    wall.light.variance.at(30, 12) = 0;
    const Vec3f beside = wall.light.value.at(31, 12);
    denoise(wall.light, wall.guides, 4);
    EXPECT_GT(wall.light.value.at(30, 12).x, 0.9f);
    EXPECT_NEAR(wall.light.value.at(31, 12).x, 1.f, 0.5f * std::abs(beside.x - 1) + 0.03f);
}

TEST(Denoise, AShadowsEdgeStaysWhereItIs) {
    Wall wall(3.f);  // a step of twenty standard errors
    denoise(wall.light, wall.guides, 4);
    EXPECT_LT(spread(wall.light.value, 1, 2, kWidth / 2), kNoise / 3);
    EXPECT_LT(spread(wall.light.value, 3, kWidth / 2, kWidth - 2), kNoise / 3);
}

TEST(Denoise, NothingCrossesAnEdgeOfTheRoom) {
    Wall wall;
    // The right half is perpendicular to the left one and darker, by so little that the variance test alone would blur
    // across.
    for (int y = 0; y < kHeight; ++y)
        for (int x = kWidth / 2; x < kWidth; ++x) {
            wall.light.value.at(x, y) = {0.9f, 0.9f, 0.9f};
            wall.guides.normal.at(x, y) = {-1, 0, 0};
            wall.guides.position.at(x, y) = {0.32f, 0.01f * static_cast<float>(y),
                                             2 - 0.01f * static_cast<float>(x - kWidth / 2)};
        }
    denoise(wall.light, wall.guides, 4);
    EXPECT_LT(spread(wall.light.value, 0.9f, kWidth / 2, kWidth), 1e-4f);
    EXPECT_LT(spread(wall.light.value, 1, 0, kWidth / 2), kNoise / 5);
}

TEST(Denoise, WhatIsKnownExactlyAndWhatIsNoSurfaceStays) {
    Wall wall;
    std::fill(wall.light.variance.pixels.begin(), wall.light.variance.pixels.end(), 0.f);
    const ImageColor before = wall.light.value;
    denoise(wall.light, wall.guides, 4);
    EXPECT_EQ(wall.light.value, before);
    Wall window;
    window.guides.normal.at(10, 10) = {};
    const Vec3f one = window.light.value.at(10, 10);
    denoise(window.light, window.guides, 4);
    EXPECT_EQ(window.light.value.at(10, 10), one);
}

// Rotating a panorama about the vertical axis must not change the result.
TEST(Denoise, TheSeamIsNoEdge) {
    Wall wall, turned;
    constexpr int kTurn = 20;
    const auto turn = [](auto image) {
        for (int y = 0; y < image.height; ++y)
            std::rotate(image.row(y), image.row(y) + kTurn, image.row(y) + image.width);
        return image;
    };
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float angle = 6.2831853f * static_cast<float>(x) / kWidth;
            wall.guides.normal.at(x, y) = {-std::cos(angle), 0, -std::sin(angle)};
            wall.guides.position.at(x, y) = {std::cos(angle), 0.1f * static_cast<float>(y), std::sin(angle)};
        }
    turned.light.value = turn(wall.light.value);
    turned.guides.normal = turn(wall.guides.normal);
    turned.guides.position = turn(wall.guides.position);
    denoise(wall.light, wall.guides, 4);
    denoise(turned.light, turned.guides, 4);
    EXPECT_EQ(turn(wall.light.value), turned.light.value);
    EXPECT_EQ(turn(wall.light.variance), turned.light.variance);
}

TEST(Denoise, SameBytesForOneAndTwoThreads) {
    Wall one, two;
    set_threads(1);
    denoise(one.light, one.guides, 4);
    set_threads(2);
    denoise(two.light, two.guides, 4);
    set_threads(0);
    EXPECT_EQ(one.light.value, two.light.value);
}

}  // namespace
}  // namespace fastscene
