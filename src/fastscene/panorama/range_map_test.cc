#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fastscene/geometry/sphere.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/panorama.h"

namespace fastscene {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
constexpr int kWidth = 256, kHeight = 128;

struct Heard : EventSink {
    std::string warnings;
    void tell(const Event& event) override {
        if (const auto* warning = std::get_if<WarningEvent>(&event)) warnings += warning->text + "\n";
    }
};

TEST(RangeMap, WhatWasNotMeasuredIsFarBackground) {
    for (const float nothing : {0.f, kNan}) {
        ImageF range(kWidth, kHeight, 2.f);
        for (int y = 40; y < 60; ++y)
            for (int x = -15; x < 15; ++x) range.at(wrap_column(x, kWidth), y) = nothing;  // a window across the seam
        range.at(100, 50) = kInf;
        RangeGaps gaps;
        const ImageF out = completed_range(range, gaps);
        EXPECT_EQ(out.at(0, 50), kInf);
        EXPECT_EQ(out.at(kWidth - 10, 50), kInf);
        EXPECT_EQ(out.at(100, 50), kInf);  // the sky is unchanged
        EXPECT_EQ(out.at(20, 50), 2.f);
        EXPECT_EQ(gaps.unmeasured, 600);
        EXPECT_EQ(gaps.far, 600);
        EXPECT_EQ(gaps.closed, 0);
    }
}

TEST(RangeMap, SpecksTakeAfterTheirSurroundings) {
    ImageF range(kWidth, kHeight, 3.f);
    range.at(0, 60) = range.at(kWidth - 1, 60) = range.at(100, 70) = kNan;
    RangeGaps gaps;
    const ImageF out = completed_range(range, gaps);
    for (const float r : out.pixels) EXPECT_EQ(r, 3.f);
    EXPECT_EQ(gaps.closed, 3);
}

TEST(RangeMap, TheFloorGoesOnUnderTheTripod) {
    ImageF range(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Vec3f d = direction_of_pixel(x, y, {kWidth, kHeight});
            range.at(x, y) = d.y > 0.3f ? 1.6f / d.y : 4.f;
            if (y > kHeight * 7 / 8) range.at(x, y) = 0;
        }
    RangeGaps gaps;
    const ImageF out = completed_range(range, gaps);
    EXPECT_NEAR(out.at(7, kHeight - 1), 1.6f, 0.02f);
    EXPECT_NEAR(out.at(7, kHeight - 10), 1.6f / direction_of_pixel(7, kHeight - 10, {kWidth, kHeight}).y, 0.02f);
}

TEST(RangeMap, SaysWhatWasMissing) {
    ImageF range(kWidth, kHeight, 2.f);
    for (int x = 0; x < kWidth; ++x)
        for (int y = 0; y < 30; ++y) range.at(x, y) = kNan;
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "fastscene-range-gaps.pfm";
    save_pfm(path, range);
    Heard heard;
    range_from_file(path, {kWidth, kHeight}, {0, &heard, {}});
    EXPECT_NE(heard.warnings.find("fastscene-range-gaps.pfm: 7680 pixels without a range"), std::string::npos)
        << heard.warnings;
    EXPECT_NE(heard.warnings.find("7680 kept as far background"), std::string::npos) << heard.warnings;
}

TEST(RangeMap, AnotherUnitIsTold) {
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "fastscene-range-unit.pfm";
    const auto heard_of = [&](float metres) {
        ImageF range(kWidth, kHeight, metres);
        range.at(3, 3) = kInf;
        save_pfm(path, range);
        Heard heard;
        // reported, not changed
        EXPECT_EQ(range_from_file(path, {kWidth, kHeight}, {0, &heard, {}}).pixels, range.pixels);
        return heard.warnings;
    };
    for (const float metres : {0.25f, 2.f, 100.f}) EXPECT_EQ(heard_of(metres), "");
    EXPECT_NE(heard_of(2500.f).find("fastscene-range-unit.pfm: half of it is farther than 2.5e+03 m"),
              std::string::npos)
        << heard_of(2500.f);
    EXPECT_NE(heard_of(0.002f).find("half of it is nearer than 0.002 m"), std::string::npos) << heard_of(0.002f);
}

}  // namespace
}  // namespace fastscene
