#include "fastscene/splat/continued.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace fastscene {
namespace {

// A square of surface, its points `apart` metres from each other, around x.
std::vector<SurfacePoint> square(float x, float apart, Rgb8 color) {
    std::vector<SurfacePoint> out;
    for (float u = -0.5f; u < 0.5f; u += apart)
        for (float v = -0.5f; v < 0.5f; v += apart) {
            SurfacePoint p;
            p.position_m = {x + u, v, 2.f};
            p.normal = {0, 0, -1};
            p.color = color;
            p.radius_m = apart;
            out.push_back(p);
        }
    return out;
}

std::vector<SurfacePoint> joined(std::vector<SurfacePoint> a, const std::vector<SurfacePoint>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

SplatParams as_many(std::size_t count) {
    SplatParams params;
    params.count = static_cast<int>(count);
    return params;
}

// Three squares: the first stays, the second changes its color, the third was covered before.
TEST(ContinuedSplats, AreKeptRenewedAndAdded) {
    const Rgb8 gray{128, 128, 128}, red{200, 20, 20}, green{20, 200, 20};
    const auto stays = square(0, 0.02f, gray), old = square(2, 0.02f, red), renewed = square(2, 0.02f, green),
               bare = square(4, 0.02f, gray);
    Splats earlier = initial_splats(joined(stays, old), as_many(stays.size() + old.size()), fastscene::Run{});
    for (float& logit : earlier.opacity_logit) logit = 1.5f;  // as training left them
    const auto points = joined(joined(stays, renewed), bare);
    const Splats splats = continued_splats(
        earlier, points, [](Vec3f p) { return p.x > 1.4f && p.x < 2.6f; }, as_many(points.size()), fastscene::Run{});
    std::array<std::size_t, 3> count{};
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const auto which = static_cast<std::size_t>(std::lround(splats.mean_m[i].x / 2));
        ++count.at(which);
        EXPECT_EQ(splats.opacity_logit[i] == 1.5f, which == 0) << i;
        if (which == 1) {
            EXPECT_GT(splats.sh0[i].y, splats.sh0[i].x) << "green";
        }
    }
    EXPECT_EQ(count[0], stays.size());
    EXPECT_NEAR(static_cast<double>(count[1]), static_cast<double>(renewed.size()), 2);
    EXPECT_NEAR(static_cast<double>(count[2]), static_cast<double>(bare.size()), 120) << "but for its rim";
}

TEST(ContinuedSplats, KeepTheDensityAskedFor) {
    const auto points = square(0, 0.01f, {128, 128, 128});
    const Splats none;
    const Splats splats = continued_splats(
        none, points, [](Vec3f) { return false; }, as_many(points.size() / 4), fastscene::Run{});
    EXPECT_NEAR(static_cast<double>(splats.size()), static_cast<double>(points.size()) / 4, 2);
}

}  // namespace
}  // namespace fastscene
