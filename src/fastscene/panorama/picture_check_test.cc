#include "fastscene/panorama/picture_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/geometry/sphere.h"

namespace fastscene {
namespace {

// A smooth picture, continuous on the sphere.
ImageColor smooth() {
    const EquirectSize size{256, 128};
    ImageColor color(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec3f d = direction_of_pixel(x, y, size);
            const float v = 0.3f + 0.1f * std::sin(9 * d.x) * std::cos(7 * d.z) + 0.1f * d.y;
            color.at(x, y) = {v, v, 0.9f * v};
        }
    return color;
}

bool says(const ImageColor& color, const std::string& word) {
    for (const std::string& doubt : doubts_about_panorama(color))
        if (doubt.find(word) != std::string::npos) return true;
    return false;
}

TEST(PictureCheck, HasNothingAgainstAClosedPanorama) { EXPECT_TRUE(doubts_about_panorama(smooth()).empty()); }

TEST(PictureCheck, SeesAnOpenSeam) {
    ImageColor color = smooth();
    for (int y = 0; y < color.height; ++y)
        for (int x = 0; x < color.width; ++x)
            color.at(x, y) = color.at(x, y) * (0.6f + 0.8f * static_cast<float>(x) / 256.f);
    EXPECT_TRUE(says(color, "do not meet"));
}

TEST(PictureCheck, SeesAnOrdinaryPhoto) {
    ImageColor color = smooth();
    for (int y = 0; y < color.height; ++y)
        for (int x = 0; x < color.width; ++x)
            color.at(x, y) = (x / 40) % 2 ? Vec3f{0.8f, 0.8f, 0.8f} : Vec3f{0.1f, 0.1f, 0.1f};
    EXPECT_TRUE(says(color, "not one color"));
}

TEST(PictureCheck, OnePoleAloneIsNoProof) {
    ImageColor color = smooth();
    for (int x = 0; x < color.width; ++x)
        color.at(x, color.height - 1) = (x / 40) % 2 ? Vec3f{0.8f, 0.8f, 0.8f} : Vec3f{0.1f, 0.1f, 0.1f};
    EXPECT_FALSE(says(color, "not one color"));
}

TEST(PictureCheck, SeesBlackBorders) {
    ImageColor color = smooth();
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < color.width; ++x) color.at(x, y) = color.at(x, color.height - 1 - y) = {};
    EXPECT_TRUE(says(color, "12 rows at the top"));
}

TEST(PictureCheck, SeesATripod) {
    ImageColor color = smooth();
    for (int y = 122; y < color.height; ++y)
        for (int x = 0; x < color.width; ++x) color.at(x, y) = {0.01f, 0.01f, 0.01f};
    EXPECT_TRUE(says(color, "tripod"));
    for (int y = 122; y < color.height; ++y)
        for (int x = 0; x < color.width; ++x) color.at(x, y) = {0.9f, 0.9f, 0.9f};
    EXPECT_TRUE(says(color, "tripod"));
}

TEST(PictureCheck, SeesALargeTripod) {
    ImageColor color = smooth();
    for (int y = 108; y < color.height; ++y)  // the lowest 28 degrees
        for (int x = 0; x < color.width; ++x) color.at(x, y) = {0.02f, 0.02f, 0.02f};
    EXPECT_TRUE(says(color, "tripod"));
}

TEST(PictureCheck, SeesAPhotoBetweenBlackSides) {
    ImageColor color = smooth();
    for (int y = 0; y < color.height; ++y)
        for (int x = 0; x < 20; ++x) color.at(x, y) = color.at(color.width - 1 - x, y) = {};
    EXPECT_TRUE(says(color, "20 columns at the left, 20 at the right"));
}

// A tiled room with a joint at the seam: equally strong edges exist elsewhere.
TEST(PictureCheck, AnEdgeOfTheRoomMayRunAlongTheSeam) {
    ImageColor color(256, 128);
    for (int y = 0; y < color.height; ++y)
        for (int x = 0; x < color.width; ++x) {
            const float v = y > 16 && y < 100 && (x / 64) % 2 ? 0.5f : 0.3f;
            color.at(x, y) = {v, v, v};
        }
    EXPECT_FALSE(says(color, "do not meet"));
}

TEST(PictureCheck, SeesThatThereIsNothing) {
    EXPECT_TRUE(says(ImageColor(64, 32, Vec3f{0.5f, 0.5f, 0.5f}), "one color throughout"));
}

TEST(PictureCheck, SeesDarkness) { EXPECT_TRUE(says(ImageColor(64, 32), "black")); }

}  // namespace
}  // namespace fastscene
