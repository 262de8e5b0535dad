#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/base/random.h"
#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"

namespace fastscene {
namespace {

ImageRgb8 noise(int width, int height, std::uint64_t seed) {
    Random random(seed, "noise");
    ImageRgb8 image(width, height);
    for (Rgb8& p : image.pixels)
        p = {static_cast<std::uint8_t>(random.index(256)), static_cast<std::uint8_t>(random.index(256)),
             static_cast<std::uint8_t>(random.index(256))};
    return image;
}

TEST(Color, EveryByteSurvivesTheWayToLinearAndBack) {
    for (int v = 0; v < 256; ++v) {
        const Rgb8 c{static_cast<std::uint8_t>(v), static_cast<std::uint8_t>(255 - v), 7};
        EXPECT_EQ(srgb8_from_linear(linear_from_srgb8(c)), c);
    }
}

TEST(Color, ValuesOutsideAreClampedAndNanIsBlack) { EXPECT_EQ(srgb8_from_linear({-1.f, 2.f, NAN}), (Rgb8{0, 255, 0})); }

TEST(Psnr, KnownDifference) {
    const ImageRgb8 a(8, 4, Rgb8{100, 100, 100}), b(8, 4, Rgb8{110, 110, 110});
    EXPECT_NEAR(psnr(a, b), 20 * std::log10(255.0 / 10.0), 1e-4);
    EXPECT_TRUE(std::isinf(psnr(a, a)));
}

TEST(Psnr, MaskSelectsPixels) {
    ImageRgb8 a(4, 1), b(4, 1);
    b.at(3, 0) = {255, 255, 255};
    ImageMask mask(4, 1, 1);
    mask.at(3, 0) = 0;
    EXPECT_EQ(mean_squared_error(a, b, mask), 0);
    EXPECT_NEAR(mean_squared_error(a, b), 0.25, 1e-6);
    EXPECT_TRUE(std::isnan(mean_squared_error(a, b, ImageMask(4, 1, 0))));
}

TEST(Ssim, EqualIsOneSymmetricAndFallsWithNoise) {
    const ImageRgb8 a = noise(40, 30, 1), b = noise(40, 30, 2);
    EXPECT_NEAR(ssim(a, a), 1, 1e-9);
    EXPECT_NEAR(ssim(a, b), ssim(b, a), 1e-12);
    EXPECT_LT(ssim(a, b), 0.3);
    ImageRgb8 near = a;
    for (Rgb8& p : near.pixels) p.r = static_cast<std::uint8_t>(p.r / 2 + 64);
    EXPECT_GT(ssim(a, near), ssim(a, b));
}

// Away from the border, windows of constant pictures are constant: SSIM has a closed form.
TEST(Ssim, ConstantPicturesInTheMiddle) {
    const int n = 64;
    const ImageRgb8 a(n, n, Rgb8{51, 51, 51}), b(n, n, Rgb8{102, 102, 102});
    const double x = 0.2, y = 0.4, expected = (2 * x * y + 1e-4) / (x * x + y * y + 1e-4);
    EXPECT_NEAR(ssim(a, b), expected, 0.05);  // zero padding affects the border
}

}  // namespace
}  // namespace fastscene
