// What a partial panorama lacks is filled before its range is estimated.
#include "fastscene/pipeline/fill_missing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fastscene {
namespace {

// A room of stripes: another gray for each of 32 directions, a dark floor and a bright ceiling.
ImageColor striped() {
    ImageColor out(256, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x) {
            const float wall = 0.3f + 0.1f * static_cast<float>(x / 8 % 4);
            out.at(x, y) = y < 30   ? Vec3f{0.8f, 0.8f, 0.8f}
                           : y > 90 ? Vec3f{0.1f, 0.1f, 0.1f}
                                    : Vec3f{wall, wall, wall};
        }
    return out;
}
ImageMask outside(int left, int right, int top, int bottom) {
    ImageMask out(256, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x) out.at(x, y) = x < left || x >= right || y < top || y >= bottom ? 255 : 0;
    return out;
}

TEST(FillMissing, SidesAreMirroredFloorsAndCeilingsContinued) {
    const ImageColor whole = striped();
    const ImageMask missing = outside(64, 192, 20, 108);  // half of the way around
    const ImageColor out = with_missing_filled(whole, missing, *make_inpainter("harmonic"), {});
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x) {
            ASSERT_TRUE(std::isfinite(out.at(x, y).x) && out.at(x, y).x > 0.05f) << x << ' ' << y;
            if (!missing.at(x, y)) ASSERT_EQ(out.at(x, y), whole.at(x, y));
        }
    EXPECT_EQ(out.at(60, 60), whole.at(67, 60));    // mirrored at the left edge, 64
    EXPECT_EQ(out.at(195, 60), whole.at(188, 60));  // and at the right one, 192
    EXPECT_NEAR(out.at(100, 10).x, 0.8f, 0.05f);
    EXPECT_NEAR(out.at(100, 120).x, 0.1f, 0.05f);
}

// Paints the column's share of the width everywhere, so that what it saw shows.
struct Ramp final : Inpainter {
    ImageColor fill(const ImageColor& color, const ImageMask& hole, const Run&) const override {
        ImageColor out = color;
        width = color.width;
        for (int y = 0; y < color.height; ++y)
            for (int x = 0; x < color.width; ++x)
                if (hole.at(x, y)) out.at(x, y) = {static_cast<float>(x), 0, 0};
        return out;
    }
    bool invents() const override { return true; }
    mutable int width = 0;
};

TEST(FillMissing, ANetworkThatInventsSeesTheSeamClosed) {
    const ImageMask missing = outside(0, 256, 20, 108);
    const Ramp ramp;
    const ImageColor out = with_missing_filled(striped(), missing, ramp, {});
    EXPECT_EQ(ramp.width, 256 + 2 * 32);
    EXPECT_EQ(out.at(0, 5).x, 32);
    EXPECT_EQ(out.at(255, 120).x, 287);
    EXPECT_EQ(out.at(100, 60), striped().at(100, 60));
}

}  // namespace
}  // namespace fastscene
