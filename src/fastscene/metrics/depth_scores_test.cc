#include "fastscene/metrics/depth_scores.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fastscene/base/error.h"
#include "fastscene/base/random.h"

namespace fastscene {
namespace {

ImageF some_range() {
    ImageF range(64, 32);
    for (std::size_t i = 0; i < range.size(); ++i) range.pixels[i] = Random(3, "range", i).uniform(1.f, 6.f);
    return range;
}

TEST(DepthScores, ItselfIsPerfect) {
    for (const auto alignment : {DepthAlignment::none, DepthAlignment::scale, DepthAlignment::affine}) {
        const DepthScores s = depth_scores(some_range(), some_range(), {.alignment = alignment});
        EXPECT_NEAR(s.abs_rel, 0, 1e-6);
        EXPECT_NEAR(s.rmse, 0, 1e-5);
        EXPECT_EQ(s.delta[0], 1);
        EXPECT_EQ(s.pixels, 2048u);
    }
}

TEST(DepthScores, WhatIsNotEstimatedIsCounted) {
    const ImageF truth = some_range();
    ImageF found = truth;
    for (std::size_t i = 0; i < 100; ++i)
        found.pixels[i] = i % 2 ? std::numeric_limits<float>::infinity() : std::nanf("");
    const DepthScores s = depth_scores(found, truth);
    EXPECT_EQ(s.missing, 100u);
    EXPECT_EQ(s.pixels, 1948u);
    EXPECT_THROW(depth_scores(ImageF(64, 32, 0.f), truth), Error);  // nothing was estimated
    EXPECT_THROW(depth_scores(ImageF(64, 32, std::nanf("")), truth), Error);
}

TEST(DepthScores, ErrorsNameTheMapThatIsUnusable) {
    const auto said = [](const ImageF& found, const ImageF& truth) {
        DepthScoreOptions options;
        options.found_name = "a.exr", options.truth_name = "b.png";
        try {
            depth_scores(found, truth, options);
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    const ImageF good(64, 32, 2.f);
    EXPECT_EQ(said(good, ImageF(64, 32)),
              "b.png: expected pixels with a range above 0 and up to 10 m, found no finite one above 0");
    EXPECT_EQ(said(good, ImageF(64, 32, 2500.f)),
              "b.png: expected pixels with a range above 0 and up to 10 m, found ranges from 2500 to 2500");
    EXPECT_EQ(said(ImageF(64, 32), good), "a.exr: expected estimates above 0 where b.png is measured, found none");
    EXPECT_EQ(said(ImageF(32, 16), good), "a.exr: expected the size of b.png, 64 x 32, found 32 x 16");
}

TEST(DepthScores, AlignmentTakesOutWhatItSays) {
    const ImageF truth = some_range();
    ImageF scaled = truth, affine = truth;
    for (std::size_t i = 0; i < truth.size(); ++i)
        scaled.pixels[i] = truth.pixels[i] / 8, affine.pixels[i] = (truth.pixels[i] - 0.5f) / 8;
    EXPECT_NEAR(depth_scores(scaled, truth, {.alignment = DepthAlignment::none}).abs_rel, 7. / 8, 1e-5);
    EXPECT_NEAR(depth_scores(scaled, truth, {.alignment = DepthAlignment::scale}).abs_rel, 0, 1e-5);
    EXPECT_GT(depth_scores(affine, truth, {.alignment = DepthAlignment::scale}).abs_rel, 0.02);
    const DepthScores s = depth_scores(affine, truth, {.alignment = DepthAlignment::affine});
    EXPECT_NEAR(s.abs_rel, 0, 1e-5);
    EXPECT_NEAR(s.scale, 8, 1e-3);
    EXPECT_NEAR(s.shift, 0.5, 1e-3);
}

TEST(DepthScores, KnownValues) {
    // Half of the pixels 10 % too far, half 50 % too far, all at 2 m.
    ImageF truth(8, 4, 2.f), found = truth;
    for (std::size_t i = 0; i < truth.size(); ++i) found.pixels[i] = i % 2 ? 2.2f : 3.f;
    const DepthScores s = depth_scores(found, truth, {.alignment = DepthAlignment::none});
    EXPECT_NEAR(s.abs_rel, 0.3, 1e-6);
    EXPECT_NEAR(s.sq_rel, (0.04 / 2 + 1. / 2) / 2, 1e-6);
    EXPECT_NEAR(s.rmse, std::sqrt((0.04 + 1) / 2), 1e-6);
    EXPECT_NEAR(s.delta[0], 0.5, 1e-9);
    EXPECT_NEAR(s.delta[1], 1, 1e-9);
}

TEST(DepthScores, LeavesOutWhatNobodyMeasured) {
    ImageF truth = some_range(), found = truth;
    truth.at(0, 0) = 0;
    truth.at(1, 0) = std::numeric_limits<float>::infinity();
    truth.at(2, 0) = 50;
    found.at(3, 0) = std::nanf("");
    EXPECT_EQ(depth_scores(found, truth).pixels, 2044u);
    EXPECT_THROW(depth_scores(found, ImageF(64, 32)), Error);
    EXPECT_THROW(depth_scores(found, ImageF(32, 16, 1.f)), Error);
    // A constant map carries no information; aligned, it is the mean.
    EXPECT_NEAR(depth_scores(ImageF(64, 32, 1.f), some_range()).shift, 3.5, 0.1);
}

}  // namespace
}  // namespace fastscene
