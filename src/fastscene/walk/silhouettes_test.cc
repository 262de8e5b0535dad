#include "fastscene/walk/silhouettes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/geometry/range_edges.h"
#include "fastscene/scene/synthetic.h"
#include "fastscene/walk/coarse_view.h"

namespace fastscene {
namespace {

constexpr int kWidth = 128, kHeight = 64;
const Vec3f kNear{0.6f, 0.2f, 0.1f}, kFar{0.1f, 0.3f, 0.8f};

// A near surface left of a slanted line, a far one right of it; a second line at `kBack` leads back to the near one.
constexpr float kBack = 100.5f;
float line_at(float y) { return 40.f + 0.37f * y; }

struct TwoSurfaces {
    ImageColor color{kWidth, kHeight};
    ImageF range{kWidth, kHeight};
};
TwoSurfaces two_surfaces(Vec3f near_color, Vec3f far_color) {
    constexpr int kFine = 16;
    TwoSurfaces out;
    const auto is_near = [](float x, float y) { return x < line_at(y) || x > kBack; };
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            Vec3f sum;
            for (int j = 0; j < kFine; ++j)
                for (int i = 0; i < kFine; ++i)
                    sum += is_near(static_cast<float>(x) + (static_cast<float>(i) + 0.5f) / kFine,
                                   static_cast<float>(y) + (static_cast<float>(j) + 0.5f) / kFine)
                               ? near_color
                               : far_color;
            out.color.at(x, y) = sum / static_cast<float>(kFine * kFine);
            out.range.at(x, y) = is_near(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f) ? 1.f : 4.f;
        }
    return out;
}

// Mean absolute error of the cut's position per row, in pixels.
double mean_miss(const Silhouettes& found, const ImageMask& cuts) {
    double miss = 0;
    int rows = 0;
    for (int y = 4; y < kHeight - 4; ++y)
        for (int x = 30; x < 80; ++x) {
            if (!(cuts.at(x, y) & kCutRight)) continue;
            const float place = static_cast<float>(x) + 1.f + own_share(found.share.at(x, y)) -
                                own_share(found.share.at(x + 1, y));
            miss += std::fabs(place - line_at(static_cast<float>(y) + 0.5f));
            ++rows;
        }
    EXPECT_EQ(rows, kHeight - 8);
    return miss / rows;
}

TEST(Silhouettes, RunWhereTheColorsSay) {
    const TwoSurfaces seen = two_surfaces(kNear, kFar);
    const ImageMask cuts = range_edges(seen.range);
    const Silhouettes found = find_silhouettes(seen.color, cuts);
    EXPECT_LT(mean_miss(found, cuts), 0.05);  // cutting at the midpoint between pixels is off by a quarter of a pixel
}

TEST(Silhouettes, RunMidwayWhereColorsSayNothing) {
    const TwoSurfaces seen = two_surfaces(kNear, kNear);
    const ImageMask cuts = range_edges(seen.range);
    const Silhouettes found = find_silhouettes(seen.color, cuts);
    for (const std::uint8_t share : found.share.pixels) ASSERT_EQ(share, kUsualShare);
    const double miss = mean_miss(found, cuts);
    EXPECT_GT(miss, 0.2);
    EXPECT_LT(miss, 0.3);
}

TEST(Silhouettes, EachPixelHasTheColorOfItsOwnSurface) {
    const TwoSurfaces seen = two_surfaces(kNear, kFar);
    const Silhouettes found = find_silhouettes(seen.color, range_edges(seen.range));
    for (int y = 4; y < kHeight - 4; ++y)
        for (int x = 0; x < kWidth; ++x)
            EXPECT_LT(length(found.color.at(x, y) - (seen.range.at(x, y) < 2 ? kNear : kFar)), 0.01f) << x << ' ' << y;
}

// The quarter samples equal the pixels of a view of twice the resolution.
TEST(Silhouettes, QuartersAreTheFinerView) {
    const SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::smooth, SyntheticPaint::smooth);
    const EquirectSize size{256, 128}, fine{512, 256};
    const Panorama first = render_synthetic(world, {}, size, 2);
    const std::vector<WarpSource> sources{make_warp_source(first.color, first.range, {}, {}, {})};
    const Vec3f position{0.3f, -0.1f, 0.2f};
    ImageMask marked(size.width, size.height);
    for (std::size_t i = 0; i < marked.size(); i += 3) marked.pixels[i] = 1;
    const CoarseView quarters = quarters_view(sources, marked, position), wanted = coarse_view(sources, fine, position);
    std::size_t quarter = 0, different = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (!marked.at(x, y)) continue;
            for (int k = 0; k < 4; ++k, ++quarter) {
                const int fx = 2 * x + k % 2, fy = 2 * y + k / 2;
                different += quarters.cover.pixels[quarter] != wanted.cover.at(fx, fy) ||
                             length(quarters.color.pixels[quarter] - wanted.color.at(fx, fy)) > 1e-3f;
            }
        }
    EXPECT_EQ(quarter, quarters.color.size());
    EXPECT_GT(quarter, 40000u);
    EXPECT_LT(different, quarter / 1000);
}

}  // namespace
}  // namespace fastscene
