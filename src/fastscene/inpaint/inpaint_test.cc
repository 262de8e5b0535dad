#include "fastscene/inpaint/inpaint.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"

namespace fastscene {
namespace {

struct Picture {
    ImageColor color;
    ImageMask hole;
};
Picture noisy_picture(int w, int h) {
    Picture p{ImageColor(w, h), ImageMask(w, h)};
    Random r(3, "inpaint");
    for (Vec3f& c : p.color.pixels) c = {r.uniform(0.2f, 0.4f), r.uniform(), 0.5f};
    for (int y = h / 4; y < h / 2; ++y)
        for (int x = w / 3; x < w; ++x) p.hole.at(x, y) = 255;
    return p;
}

TEST(Inpainters, AllKeepTheContract) {
    const Picture p = noisy_picture(97, 61);
    for (const std::string& name : inpainters()) {
        const auto inpainter = make_inpainter(name);
        const ImageColor out = inpainter->fill(p.color, p.hole, {});
        ASSERT_TRUE(out.same_size(p.color)) << name;
        for (std::size_t i = 0; i < out.size(); ++i) {
            if (!p.hole.pixels[i]) {
                ASSERT_EQ(out.pixels[i], p.color.pixels[i]) << name;
            }
            ASSERT_TRUE(std::isfinite(out.pixels[i].x + out.pixels[i].y + out.pixels[i].z)) << name;
        }
        EXPECT_EQ(out, inpainter->fill(p.color, p.hole, {})) << name;
        // What lies under the mask must not matter.
        ImageColor other = p.color;
        for (std::size_t i = 0; i < other.size(); ++i)
            if (p.hole.pixels[i]) other.pixels[i] = {9, 9, 9};
        EXPECT_EQ(out, inpainter->fill(other, p.hole, {})) << name;
        EXPECT_EQ(p.color, inpainter->fill(p.color, ImageMask(97, 61), {})) << name;
        (void)inpainter->fill(p.color, ImageMask(97, 61, std::uint8_t{1}), {});   // nothing known: no crash
    }
}

TEST(Harmonic, StaysWithinTheRim) {
    const Picture p = noisy_picture(200, 120);
    const ImageColor out = make_inpainter("harmonic")->fill(p.color, p.hole, {});
    for (std::size_t i = 0; i < out.size(); ++i) {
        EXPECT_GE(out.pixels[i].x, 0.2f);
        EXPECT_LE(out.pixels[i].x, 0.4f);
        EXPECT_EQ(out.pixels[i].z, 0.5f);
    }
}

TEST(Harmonic, ContinuesARampExactly) {
    ImageColor color(128, 128);
    ImageMask hole(128, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            color.at(x, y) = {static_cast<float>(x) / 128.f, static_cast<float>(y) / 128.f, 0};
            hole.at(x, y) = x > 30 && x < 100 && y > 40 && y < 90;
        }
    const ImageColor out = make_inpainter("harmonic")->fill(color, hole, {});
    for (std::size_t i = 0; i < out.size(); ++i) EXPECT_LT(length(out.pixels[i] - color.pixels[i]), 0.02f);
}

TEST(Inpainters, AnUnknownNameIsRefused) { EXPECT_THROW(make_inpainter("crayon"), UsageError); }

}  // namespace
}  // namespace fastscene
