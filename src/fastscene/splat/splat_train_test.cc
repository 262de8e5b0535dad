// Training on a small analytic room.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "bench/textured_room.h"
#include "fastscene/base/parallel.h"
#include "fastscene/splat/relocate.h"
#include "fastscene/splat/splat.h"
#include "fastscene/splat/train.h"

namespace fastscene {
namespace {

using Context = Run;  // inside a test, Run is a member function of GoogleTest

Context seeded(std::uint64_t seed) {
    Context run;
    run.seed = seed;
    return run;
}

double psnr(const SplatPicture& picture, const View& truth) {
    double sum = 0;
    for (std::size_t i = 0; i < truth.color.size(); ++i) {
        const Vec3f d = picture.color.pixels[i] - unit_from_srgb8(truth.color.pixels[i]);
        sum += dot(d, d);
    }
    return -10 * std::log10(sum / (3.0 * static_cast<double>(truth.color.size())));
}
double mean_psnr(const Splats& splats, const std::vector<View>& views) {
    double sum = 0;
    for (const View& v : views) sum += psnr(render_splats(splats, v.camera, v.world_from_camera), v);
    return sum / static_cast<double>(views.size());
}
const bench::RoomSet& small_room() {
    static const bench::RoomSet set = bench::room_set(64, 3, 6000, 4, 2);
    return set;
}

TEST(SplatTrain, RaisesPsnrAtPosesNeverSeen) {
    const bench::RoomSet& set = small_room();
    SplatParams params;
    params.count = 5000;
    params.steps = 300;
    const Context run = seeded(3);
    const double before = mean_psnr(initial_splats(set.train.points, params.count, run), set.held_out);
    const FittedSplats fitted = fit_splats(set.train, params, run);
    EXPECT_GT(mean_psnr(fitted.splats, set.held_out), before + 5);
    ASSERT_GE(fitted.curve.size(), 3u);
    EXPECT_EQ(fitted.curve.back().step, 300);
    EXPECT_LT(fitted.curve.back().loss, 0.7f * fitted.curve.front().loss);
    EXPECT_GT(fitted.curve.back().psnr, fitted.curve.front().psnr + 2);
    EXPECT_EQ(fitted.splats.sh_degree, 0);
    EXPECT_LE(fitted.splats.size(), 5000u);
}

TEST(SplatTrain, SameSeedSameBytesForAnyNumberOfThreads) {
    SplatParams params;
    params.count = 2000;
    params.steps = 30;
    const int before = thread_count();
    set_threads(1);
    const Splats one = fit_splats(small_room().train, params, seeded(5)).splats;
    set_threads(2);
    const Splats two = fit_splats(small_room().train, params, seeded(5)).splats;
    const Splats other = fit_splats(small_room().train, params, seeded(6)).splats;
    set_threads(before);
    EXPECT_TRUE(one == two);
    EXPECT_FALSE(one == other);
}

// The first steps of both backends agree up to rounding.
TEST(SplatTrain, BackendsTakeTheSameSteps) {
    ViewSet set = small_room().train;
    set.views.resize(2);
    SplatParams params;
    params.count = 400;
    params.steps = 3;
    const FittedSplats fast = fit_splats(set, params, Context{});
    params.backend.name = "reference";
    const FittedSplats slow = fit_splats(set, params, Context{});
    EXPECT_NEAR(fast.curve.back().loss, slow.curve.back().loss, 1e-4f);
    double far = 0, moved = 0;
    const Splats start = initial_splats(set.points, params.count, Context{});
    for (std::size_t i = 0; i < start.size(); ++i) {
        far += length(fast.splats.mean_m[i] - slow.splats.mean_m[i]);
        moved += length(slow.splats.mean_m[i] - start.mean_m[i]);
    }
    EXPECT_GT(moved, 0);
    EXPECT_LT(far, 0.05 * moved);
}

TEST(SplatTrain, PixelsOfNoWeightTeachNothing) {
    ViewSet set = small_room().train;
    set.views.resize(1);
    View& view = set.views[0];
    view.weight = ImageMask(view.color.width, view.color.height, 0);
    SplatParams params;
    params.count = 500;
    params.steps = 5;
    const Context run{};
    EXPECT_TRUE(fit_splats(set, params, run).splats == initial_splats(set.points, params.count, run));
}

TEST(SplatTrain, StopsWhenAsked) {
    std::stop_source source;
    source.request_stop();
    Context run;
    run.stop = source.get_token();
    EXPECT_THROW(fit_splats(small_room().train, SplatParams{}, run), Stopped);
}

TEST(SplatTrain, SaysWhatIsWrongWithTheViews) {
    EXPECT_THROW(fit_splats({}, SplatParams{}, Context{}), Error);
    ViewSet set = small_room().train;
    set.points.clear();
    EXPECT_THROW(fit_splats(set, SplatParams{}, Context{}), Error);
    set = small_room().train;
    set.views[1].camera.width += 1;
    EXPECT_THROW(fit_splats(set, SplatParams{}, Context{}), Error);
}

TEST(SplatInit, DiscsLieOnTheirSurface) {
    const auto& points = small_room().train.points;
    const Splats s = initial_splats(points, 1000, seeded(1));
    ASSERT_EQ(s.size(), 1000u);
    for (std::size_t i = 0; i < s.size(); ++i) {
        const auto p = std::find_if(points.begin(), points.end(),
                                    [&](const SurfacePoint& q) { return q.position_m == s.mean_m[i]; });
        ASSERT_NE(p, points.end());
        EXPECT_GT(std::fabs(dot(matrix_of(s.rotation[i]).column(2), p->normal)), 0.999f);
        EXPECT_LT(s.log_scale[i].z, s.log_scale[i].x - 1.f);
        EXPECT_NEAR(0.5f + kSh0 * s.sh0[i].x, static_cast<float>(p->color.r) / 255.f, 1e-5);
    }
    EXPECT_EQ(initial_splats(points, 1 << 20, Context{}).size(), points.size());
}

TEST(SplatInit, DiscsAreLongAlongEdgesAndCoverTheSameArea) {
    const Vec3f edge = normalize(Vec3f{3, 1, 0});
    std::vector<SurfacePoint> points(3, {{0, 0, 2}, {0, 0, -1}, {9, 9, 9}, 0.01f});
    points[1].edge = edge * 0.5f, points[2].edge = edge;
    points[1].position_m.x = 1, points[2].position_m.x = 2;
    const Splats s = initial_splats(points, 3, Context{});
    ASSERT_EQ(s.size(), 3u);
    float longer = 1;
    for (std::size_t i = 1; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(
            std::find_if(s.mean_m.begin(), s.mean_m.end(), [&](Vec3f m) { return m == points[i].position_m; }) -
            s.mean_m.begin());
        const Mat3f axes = matrix_of(s.rotation[k]);
        EXPECT_GT(std::fabs(dot(axes.column(0), edge)), 0.999f);
        EXPECT_GT(std::fabs(axes.column(2).z), 0.999f);
        EXPECT_NEAR(s.log_scale[k].x + s.log_scale[k].y, 2 * std::log(0.6f * 0.01f), 1e-4f);
        const float ratio = std::exp(s.log_scale[k].x - s.log_scale[k].y);
        EXPECT_GT(ratio, 1.5f * longer);  // the clearer the edge, the longer
        longer = ratio;
    }
}

// A dead splat and the one with all the error become two neighbours along the latter's longest axis.
TEST(SplatRelocate, TheDeadMoveToWhereTheErrorIs) {
    Splats s = initial_splats(small_room().train.points, 200, Context{});
    s.opacity_logit[3] = -9;
    s.log_scale[100].y += 1;
    splat::Cloud cloud(s, true);
    cloud.seen_error[100] = 7.f;
    EXPECT_EQ(splat::relocate(cloud, {.useless_fraction = 0}, 1, 100), 1);
    const Splats moved = cloud.splats();
    EXPECT_LT(length((moved.mean_m[3] + moved.mean_m[100]) * 0.5f - s.mean_m[100]), 1e-5f);
    const Vec3f apart = normalize(moved.mean_m[3] - moved.mean_m[100]);
    EXPECT_GT(std::fabs(dot(apart, matrix_of(s.rotation[100]).column(1))), 0.999f);
    EXPECT_LT(moved.opacity_logit[100], s.opacity_logit[100]);
    EXPECT_EQ(moved.opacity_logit[3], moved.opacity_logit[100]);
    EXPECT_EQ(moved.mean_m[150], s.mean_m[150]);
    EXPECT_EQ(cloud.seen_error[100], 0.f);
}

TEST(SplatRelocate, SplittingHardlyChangesThePicture) {
    const Splats s = initial_splats(small_room().train.points, 3000, Context{});
    splat::Cloud cloud(s, true);
    for (std::int64_t i = 0; i < cloud.count; ++i) {
        cloud.seen_error[static_cast<std::size_t>(i)] = 1;
        cloud.seen_weight[static_cast<std::size_t>(i)] = i % 60 ? 1.f : 0.f;
    }
    EXPECT_GT(splat::relocate(cloud, {.useless_fraction = 0.03}, 1, 100), 40);
    const View& view = small_room().train.views[0];
    View before = view;
    const SplatPicture picture = render_splats(s, view.camera, view.world_from_camera);
    for (std::size_t i = 0; i < before.color.size(); ++i) {
        const Vec3f c = picture.color.pixels[i];
        before.color.pixels[i] = {byte_from_unit(c.x), byte_from_unit(c.y), byte_from_unit(c.z)};
    }
    EXPECT_GT(psnr(render_splats(cloud.splats(), view.camera, view.world_from_camera), before), 30);
}

// A hall needs more splats than a bathroom, within the limit; each point of the scenery outside is one.
TEST(SplatCount, FollowsTheSurface) {
    SplatParams params;
    params.count = 500'000;
    params.per_m2 = 2000;
    std::vector<SurfacePoint> points(1000, {{1, 0, 2}, {0, 0, -1}, {}, 0.3f});  // 90 m2
    EXPECT_NEAR(count_for(points, params), 180'000, 10);
    for (int i = 0; i < 5000; ++i) points.push_back({{0, 0, 600}, {0, 0, -1}, {}, 50.f});
    EXPECT_NEAR(count_for(points, params), 185'000, 10);
    params.count = 100'000;
    EXPECT_EQ(count_for(points, params), 100'000);
    params.per_m2 = 0;
    EXPECT_EQ(count_for(points, params), 100'000);
}

}  // namespace
}  // namespace fastscene
