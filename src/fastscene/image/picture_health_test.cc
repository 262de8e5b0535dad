// Pictures that are broken on purpose.
#include "fastscene/image/picture_health.h"

#include <gtest/gtest.h>

#include <limits>

namespace fastscene {
namespace {

// Something to see: a gradient.
ImageRgb8 picture(int width = 64, int height = 32) {
    ImageRgb8 out(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            out.at(x, y) = {static_cast<std::uint8_t>(40 + 2 * x), static_cast<std::uint8_t>(60 + 3 * y), 90};
    return out;
}
// The first `share` of its rows in one color.
ImageRgb8 covered(double share, Rgb8 color) {
    ImageRgb8 out = picture();
    std::fill_n(out.pixels.begin(), static_cast<std::ptrdiff_t>(share * static_cast<double>(out.size())), color);
    return out;
}
ImageColor floats(const ImageRgb8& bytes) {
    ImageColor out(bytes.width, bytes.height);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        out.pixels[i] = Vec3f{float(bytes.pixels[i].r), float(bytes.pixels[i].g), float(bytes.pixels[i].b)} *
                        (1 / 255.f);
    return out;
}

TEST(PictureHealth, GoodOnesPass) {
    EXPECT_EQ(complaint(health_of(picture())), "");
    // A room at night, a window full of snow.
    EXPECT_EQ(complaint(health_of(covered(0.6, {1, 0, 2}))), "");
    EXPECT_EQ(complaint(health_of(covered(0.4, {255, 255, 255}))), "");
    EXPECT_EQ(complaint(health_of(floats(picture()), ImageF(64, 32, 1.f)), 0.05), "");
}

TEST(PictureHealth, BlackAndWhiteOnesAreFound) {
    EXPECT_EQ(complaint(health_of(covered(0.875, {3, 3, 3}))), "87 % of it is black");
    EXPECT_EQ(complaint(health_of(covered(0.75, {252, 255, 253}))), "75 % of it is white");
    EXPECT_EQ(complaint(health_of(ImageRgb8(64, 32))), "100 % of it is black");
}

TEST(PictureHealth, OneColorIsNoPicture) {
    EXPECT_EQ(complaint(health_of(covered(1, {90, 120, 40}))), "it shows one color alone");
}

TEST(PictureHealth, NumbersThatAreNoneAreFound) {
    ImageColor encoded = floats(picture());
    encoded.at(5, 6).y = std::numeric_limits<float>::quiet_NaN();
    encoded.at(5, 7).z = std::numeric_limits<float>::infinity();
    const PictureHealth health = health_of(encoded, ImageF(64, 32, 1.f));
    EXPECT_DOUBLE_EQ(health.not_finite, 2.0 / (64 * 32));
    EXPECT_EQ(complaint(health), "0.0977 % of its pixels are no numbers");
    ImageF alpha(64, 32, 1.f);
    alpha.at(0, 0) = -std::numeric_limits<float>::infinity();
    EXPECT_NE(complaint(health_of(floats(picture()), alpha)), "");
}

TEST(PictureHealth, HolesAreFoundWhereThereMayBeNone) {
    ImageF alpha(64, 32, 1.f);
    std::fill_n(alpha.pixels.begin(), 64 * 4, 0.4f);
    const PictureHealth health = health_of(floats(picture()), alpha);
    EXPECT_EQ(complaint(health, 0.05), "12 % of it is transparent, expected at most 5 %");
    EXPECT_EQ(complaint(health, 0.2), "");
}

TEST(PictureHealth, NoPixelsAreNoPicture) { EXPECT_EQ(complaint(health_of(ImageRgb8())), "it shows one color alone"); }

}  // namespace
}  // namespace fastscene
