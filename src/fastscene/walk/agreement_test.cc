#include "fastscene/walk/agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/error.h"
#include "fastscene/walk/walk.h"

namespace fastscene {
namespace {

// A box room of 6 x 2.6 x 5 m with stripes, seen from `position`.
Panorama box_from(Vec3f position, EquirectSize size = {128, 64}) {
    const Vec3f low{-3, -1, -2}, high{3, 1.6f, 3};
    Panorama out;
    out.color = ImageColor(size.width, size.height);
    out.range = ImageF(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec3f d = direction_of_pixel(x, y, size);
            float t = 1e9f;
            for (std::size_t a = 0; a < 3; ++a)
                if (std::fabs(d[a]) > 1e-6f) t = std::min(t, ((d[a] > 0 ? high[a] : low[a]) - position[a]) / d[a]);
            const Vec3f p = position + d * t;
            out.range.at(x, y) = t;
            out.color.at(x, y) = Vec3f{0.5f, 0.5f, 0.5f} +
                                 Vec3f{std::sin(3 * p.x), std::sin(3 * p.y), std::sin(3 * p.z)} * 0.3f;
        }
    out.world_from_pano.translation = position;
    return out;
}

TEST(Agreement, FindsByWhatAGuessWasTooLarge) {
    const Panorama first = box_from({});
    for (const float wrong : {0.7f, 1.f, 1.25f}) {
        Panorama other = box_from({1, 0.2f, -0.8f});
        for (float& r : other.range.pixels) r *= wrong;
        EXPECT_NEAR(scale_to_agree(first, other) * wrong, 1, 0.02) << wrong;
    }
}

TEST(Agreement, SaysOneWhereNothingIsShared) {
    Panorama other = box_from({1, 0, 0});
    std::fill(other.range.pixels.begin(), other.range.pixels.end(), std::numeric_limits<float>::infinity());
    EXPECT_EQ(scale_to_agree(box_from({}), other), 1);
}

TEST(WalkWithMore, GivenPanoramasAreObservedAndViewpointsAreShared) {
    const Panorama first = box_from({}), second = box_from({1.2f, 0, -0.5f});
    WalkParams params;
    params.inpainter = "harmonic";
    params.viewpoints = 4;
    const auto walked = walked_through(first, params, {}, {}, {second}).panoramas;
    ASSERT_EQ(walked.size(), 6u);
    EXPECT_EQ(walked[1].world_from_pano.translation, second.world_from_pano.translation);
    EXPECT_EQ(walked[1].color.pixels, second.color.pixels);
    int near_second = 0;
    for (std::size_t i = 2; i < walked.size(); ++i) {
        const Vec3f p = walked[i].world_from_pano.translation;
        near_second += length(p - second.world_from_pano.translation) < length(p);
        const Panorama truth = box_from(p);
        int wrong = 0;  // in corners the coarse pixels of the two differ
        for (std::size_t k = 0; k < truth.range.size(); ++k)
            wrong += std::fabs(walked[i].range.pixels[k] / truth.range.pixels[k] - 1) > 0.05f;
        EXPECT_LT(wrong, 0.002 * static_cast<double>(truth.range.size()));
    }
    EXPECT_EQ(near_second, 2);
    params.kind = "paper";
    EXPECT_THROW(walked_through(first, params, {}, {}, {second}), UsageError);
}

}  // namespace
}  // namespace fastscene
