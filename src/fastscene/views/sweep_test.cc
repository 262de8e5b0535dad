// Points for captures without any: they lie on visible surfaces, or are absent.
#include "fastscene/views/sweep.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/base/random.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/scene/synthetic.h"

namespace fastscene {
namespace {

constexpr EquirectSize kSphere{256, 128};

ViewSet spheres(const SyntheticWorld& world, float spread_m) {
    ViewSet set;
    Random rng(3, "places");
    for (int i = 0; i < 12; ++i) {
        const Vec3f place{rng.uniform(-spread_m, spread_m), rng.uniform(-spread_m, spread_m),
                          rng.uniform(-spread_m, spread_m)};
        View view;
        view.camera.width = kSphere.width, view.camera.height = kSphere.height;
        view.model = CameraModel::equirectangular;
        view.world_from_camera.translation = place;
        view.color = srgb8_from_linear(render_synthetic(world, place, kSphere).color);
        set.views.push_back(std::move(view));
    }
    return set;
}

TEST(Sweep, PointsLieOnWhatTheViewsShow) {
    const SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::planks, SyntheticPaint::planks);
    const std::vector<SurfacePoint> points = swept_points(spheres(world, 0.35f), 3000, 0.15f, 30, {});
    ASSERT_GT(points.size(), 1500u);
    const ImageF range = render_synthetic(world, {}, kSphere).range;
    int near = 0;
    for (const SurfacePoint& p : points) {
        EXPECT_GT(p.radius_m, 0);
        const Vec2f at = pixel_of_direction(p.position_m, kSphere);
        const float wanted = range.at(std::min(static_cast<int>(at.x), kSphere.width - 1),
                                      std::min(static_cast<int>(at.y), kSphere.height - 1));
        near += std::abs(std::log(length(p.position_m) / wanted)) < 0.15f;
    }
    EXPECT_GT(near, 0.7 * static_cast<double>(points.size()));  // uniform in the logarithm it would be a twentieth
}

TEST(Sweep, ViewsOfOnePlaceTellNoDistance) {
    const SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::planks, SyntheticPaint::planks);
    EXPECT_TRUE(swept_points(spheres(world, 0), 500, 0.15f, 30, {}).empty());
}

TEST(Sweep, PicturesOfNothingTellNoDistance) {
    ViewSet set = spheres(SyntheticWorld::furnished(SyntheticPaint::smooth, SyntheticPaint::smooth), 0.35f);
    for (View& view : set.views) std::fill(view.color.pixels.begin(), view.color.pixels.end(), Rgb8{90, 90, 90});
    EXPECT_TRUE(swept_points(set, 500, 0.15f, 30, {}).empty());
}

}  // namespace
}  // namespace fastscene
