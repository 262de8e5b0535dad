#include "fastscene/depth/depth.h"

#include <gtest/gtest.h>

#include <limits>

namespace fastscene {
namespace {

Panorama gray() {
    Panorama p;
    p.color = ImageColor(32, 16);
    return p;
}

TEST(WithRange, KeepsWhatIsKnownAndFillsWhatIsNot) {
    ImageF range(32, 16, 2.f);
    range.at(5, 5) = 3.f;
    range.at(9, 9) = std::numeric_limits<float>::infinity();
    for (int x = 14; x < 24; ++x) range.at(x, 0) = range.at(x, 1) = 0;
    const Panorama p = with_range(gray(), range);
    for (std::size_t i = 0; i < range.size(); ++i) {
        if (range.pixels[i] > 0) EXPECT_EQ(p.range.pixels[i], range.pixels[i]);
        else EXPECT_NEAR(p.range.pixels[i], 2, 0.3);
    }
}

TEST(WithRange, RefusesNonsenseByName) {
    EXPECT_THROW(with_range(gray(), ImageF(16, 16, 1.f)), Error);
    EXPECT_THROW(with_range(gray(), ImageF(32, 16, 0.f)), Error);
    EXPECT_THROW(with_range(gray(), ImageF(32, 16, -1.f)), Error);
    ImageF range(32, 16, 1.f);
    range.at(3, 7) = std::nanf("");
    try {
        with_range(gray(), range, "map.exr");
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("map.exr"), std::string::npos);
        EXPECT_NE(std::string(e.what()).find("(3, 7)"), std::string::npos);
    }
}

}  // namespace
}  // namespace fastscene
