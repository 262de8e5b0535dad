#include <gtest/gtest.h>

#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"
#include "fastscene/scene/synthetic.h"
#include "fastscene/walk/published_inpaint.h"
#include "fastscene/walk/published_warp.h"
#include "fastscene/walk/walk.h"

namespace fastscene {
namespace {

Panorama furnished(EquirectSize size) {
    return render_synthetic(SyntheticWorld::furnished(SyntheticPaint::smooth, SyntheticPaint::planks), {}, size, 1);
}

TEST(PublishedWarp, LandsWhereTheOfficialFrameSays) {
    // One near pixel in front of a far sphere; moves by half its distance towards the center, the zenith and the right.
    const int w = 64, h = 32;
    const Image<double> range(w, h, 1.0);
    const ImageRgb8 color(w, h, Rgb8{10, 20, 30});
    const PublishedWarp ahead = published_warp(color, range, {0.5, 0, 0});
    // Moving towards the picture's center, everything spreads away from it.
    EXPECT_EQ(ahead.source.at(w / 2, h / 2), ahead.source.at(w / 2, h / 2));
    int left = 0;
    for (int x = 1; x < w / 2; ++x)
        if (ahead.source.at(x, h / 2) != kNoSource) left = std::max(left, ahead.source.at(x, h / 2) % w - x);
    EXPECT_GT(left, 2);  // from closer to the center
    EXPECT_NEAR(ahead.range.at(w / 2, h / 2), 0.5, 0.02);
    const PublishedWarp up = published_warp(color, range, {0, 0.5, 0});
    EXPECT_NEAR(up.range.at(5, 1), 0.5, 0.02);
    const PublishedWarp right = published_warp(color, range, {0, 0, 0.5});
    EXPECT_NEAR(right.range.at(3 * w / 4, h / 2), 0.5, 0.02);
    EXPECT_EQ(world_from_published(Vec3f{1, 0, 0}), (Vec3f{0, 0, 1}));
    EXPECT_EQ(world_from_published(Vec3f{0, 1, 0}), (Vec3f{0, -1, 0}));
    EXPECT_EQ(world_from_published(Vec3f{0, 0, 1}), (Vec3f{1, 0, 0}));
}

TEST(PublishedWarp, NeverWritesTheFirstRowAndColumnAndTheNearestWins) {
    const Panorama first = furnished({256, 128});
    const Image<double> range = published_units(in_double(first.range));
    const PublishedWarp warp = published_warp(srgb8_from_linear(first.color), range, {0.05, 0, 0.03});
    for (int x = 0; x < 256; ++x) EXPECT_EQ(warp.source.at(x, 0), kNoSource);
    for (int y = 0; y < 128; ++y) EXPECT_EQ(warp.source.at(0, y), kNoSource);
    EXPECT_GT(warp.hole_ratio(), 0.02);
    EXPECT_LT(warp.hole_ratio(), 0.4);
    for (std::size_t i = 0; i < warp.source.size(); ++i) {
        EXPECT_EQ(warp.source.pixels[i] == kNoSource, warp.range.pixels[i] == 0);
        if (warp.source.pixels[i] == kNoSource) {
            EXPECT_EQ(warp.color.pixels[i], (Rgb8{255, 255, 255}));
        }
    }
}

TEST(PublishedWarp, HolesGrowWithTheStep) {
    const Panorama first = furnished({256, 128});
    const Image<double> range = published_units(in_double(first.range));
    double before = 0;
    for (const double step : {0.02, 0.06, 0.12, 0.2}) {
        const double ratio = published_warp(srgb8_from_linear(first.color), range, {step, 0, 0}).hole_ratio();
        EXPECT_GT(ratio, before) << step;
        before = ratio;
    }
}

TEST(PublishedInpaint, OnlyHolesAreReplaced) {
    const ImageRgb8 color = srgb8_from_linear(furnished({256, 128}).color);
    ImageMask hole(256, 128);
    for (int y = 40; y < 70; ++y)
        for (int x = 100; x < 180; ++x) hole.at(x, y) = 255;
    const Painter gray = [](const ImageRgb8& face, const ImageMask&) {
        return ImageRgb8(face.width, face.height, Rgb8{90, 91, 92});
    };
    const ImageRgb8 out = published_inpaint(color, hole, 64, gray);
    for (std::size_t i = 0; i < out.size(); ++i)
        if (!hole.pixels[i]) {
            ASSERT_EQ(out.pixels[i], color.pixels[i]);
        } else {
            ASSERT_NEAR(out.pixels[i].r, 90, 1);
        }
}

TEST(PublishedWalk, WalksEightWaysAtTheStepsItSays) {
    const Panorama first = furnished({256, 128});
    float most = 0;
    for (const float r : first.range.pixels) most = std::max(most, r);
    for (const char* kind : {"paper", "paper-direct", "paper-far"}) {
        WalkParams params;
        params.kind = kind;
        params.steps = 2;
        const Walked walked = walked_through(first, params, {});
        const bool far = params.kind == "paper-far";
        ASSERT_EQ(walked.panoramas.size(), far ? 9u : 17u);
        const Panorama& last = walked.panoramas[far ? 1 : 2];  // towards the picture's center
        EXPECT_NEAR(last.world_from_pano.translation.z, 2 * params.step * most, 0.02f * most * 0.1f);
        EXPECT_EQ(walked.about.at("kind"), kind);
        EXPECT_NE(walked.about.at("depth").get<std::string>().find("no estimator"), std::string::npos);
        int original = 0, carried = 0, invented = 0;
        for (const Known k : last.known.pixels) {
            original += k == Known::original;
            carried += k == Known::carried;
            invented += k == Known::invented;
        }
        EXPECT_GT(original, 256 * 128 / 2);
        EXPECT_GT(invented, 500);
        EXPECT_EQ(carried > 0, !far);
        // Still the same room: a published step is imprecise, but not wrong.
        const Panorama truth = render_synthetic(
            SyntheticWorld::furnished(SyntheticPaint::smooth, SyntheticPaint::planks), last.world_from_pano.translation,
            {256, 128}, 1);
        EXPECT_GT(psnr(srgb8_from_linear(last.color), srgb8_from_linear(truth.color)), 18) << kind;
    }
}

TEST(PublishedWalk, AsksTheEstimatorAfterEachStep) {
    const Panorama first = furnished({128, 64});
    WalkParams params;
    params.kind = "paper";
    params.steps = 2;
    int asked = 0;
    const Walked walked = walked_through(first, params, {},
                                         {[&](const ImageColor& color, const fastscene::Run&) {
                                              ++asked;
                                              return ImageF(color.width, color.height, 2.f);
                                          },
                                          {}});
    EXPECT_EQ(asked, 16);
    EXPECT_EQ(walked.panoramas[1].range.at(5, 5), 2.f);
    EXPECT_NE(walked.about.at("depth").get<std::string>().find("estimated"), std::string::npos);
}

}  // namespace
}  // namespace fastscene
