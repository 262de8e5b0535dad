// The fast renderer against the reference, for every instruction set that this processor supports.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "fastscene/base/parallel.h"
#include "fastscene/splat/splat.h"
#include "fastscene/splat/test_scene.h"

namespace fastscene::splat {
namespace {

const Vec3f kBackground{0.2f, 0.4f, 0.6f};

std::vector<Vec3f> as_floats(const std::vector<Vec3d>& v) {
    std::vector<Vec3f> out;
    for (const Vec3d& x : v) out.push_back({static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z)});
    return out;
}

class SplatKernel : public ::testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        try {
            kernel_ = &choose_kernel(GetParam());
        } catch (const UsageError& e) {
            GTEST_SKIP() << e.what();
        }
    }
    const Kernel* kernel_ = nullptr;
};
INSTANTIATE_TEST_SUITE_P(All, SplatKernel, ::testing::Values("avx512", "avx2", "baseline"),
                         [](const auto& i) { return std::string(i.param); });

TEST_P(SplatKernel, PictureIsTheReference) {
    const Pinhole camera = test_camera(93, 70);
    const Splats s = random_splats(300, 3);
    const Cloud cloud(s, false);
    Engine engine(*kernel_);
    engine.render(cloud, camera, test_pose(), kBackground, true);
    const auto ruler = render_reference(gaussians_of<double>(s), lens_over<double>(lens_of(camera, test_pose())),
                                        camera.width, camera.height, Vec3d{0.2f, 0.4f, 0.6f});
    Distance color, transmittance, depth;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const auto i = static_cast<std::size_t>(y * camera.width + x);
            for (std::size_t c = 0; c < 3; ++c) color.add(engine.color(x, y)[c], ruler.pixels[i].color[c]);
            transmittance.add(engine.transmittance(x, y), ruler.pixels[i].transmittance);
            depth.add(engine.depth_sum(x, y), ruler.depth_sum[i]);
        }
    EXPECT_LT(color.relative(), 1e-4);
    EXPECT_LT(transmittance.relative(), 1e-3);  // blending stops at kOpaque
    EXPECT_LT(depth.relative(), 2e-4);
}

TEST_P(SplatKernel, GradientsAreTheReference) {
    const Pinhole camera = test_camera(75, 58);
    const Splats s = random_splats(60, 11);
    Cloud cloud(s, true);
    Engine engine(*kernel_);
    engine.render(cloud, camera, test_pose(), kBackground, false);
    const auto v = random_color_gradient(camera, 3);
    engine.set_color_gradient(as_floats(v));
    const AlignedFloats mine = engine.gradients(cloud);
    const auto g = gaussians_of<double>(s);
    const auto lens = lens_over<double>(lens_of(camera, test_pose()));
    auto ruler = gradients_reference(
        g, lens, render_reference(g, lens, camera.width, camera.height, Vec3d{0.2f, 0.4f, 0.6f}), v);
    for (int p = 0; p < kParameters; ++p) {
        Distance distance;
        for (std::int64_t i = 0; i < cloud.count; ++i)
            distance.add(mine[cloud.at(i, p)], parameter(ruler[static_cast<std::size_t>(i)], p));
        EXPECT_GT(distance.size2, 0) << p;
        EXPECT_LT(distance.relative(), 1e-4) << p;
    }
}

TEST_P(SplatKernel, TheOutsideIsTrainedOnlyWhereItIsVisible) {
    const Pinhole camera = test_camera(75, 58);
    const Splats s = random_splats(60, 11);
    const auto g = gaussians_of<double>(s);
    const auto lens = lens_over<double>(lens_of(camera, test_pose()));
    std::vector<double> depths;
    for (const auto& x : g) depths.push_back((lens.rotation * x.mean + lens.translation).z);
    std::vector<double> sorted = depths;
    std::sort(sorted.begin(), sorted.end());
    const double outside_m = 0.5 * (sorted[30] + sorted[31]);
    Cloud cloud(s, true);
    Engine engine(*kernel_);
    engine.set_outside(static_cast<float>(outside_m));
    engine.render(cloud, camera, test_pose(), kBackground, false);
    const auto v = random_color_gradient(camera, 3);
    engine.set_color_gradient(as_floats(v));
    const AlignedFloats mine = engine.gradients(cloud);
    const auto picture = render_reference(g, lens, camera.width, camera.height, Vec3d{0.2f, 0.4f, 0.6f});
    std::vector<double> no_bands;
    auto ruler = gradients_reference(g, lens, picture, v, {}, &no_bands, {}, {}, outside_m),
         all = gradients_reference(g, lens, picture, v);
    Distance distance, held_back;
    for (std::int64_t i = 0; i < cloud.count; ++i)
        for (int p = 0; p < kParameters; ++p) {
            const auto k = static_cast<std::size_t>(i);
            distance.add(mine[cloud.at(i, p)], parameter(ruler[k], p));
            if (depths[k] < outside_m) EXPECT_EQ(parameter(ruler[k], p), parameter(all[k], p));
            else held_back.add(parameter(ruler[k], p), parameter(all[k], p));
        }
    EXPECT_LT(distance.relative(), 1e-3);  // a pixel at the threshold may fall to either side
    EXPECT_GT(held_back.relative(), 0.05);
}

// Adam's first step has the length of the learning rate; beyond the reach, position steps (only those) grow in
// proportion to the distance.
TEST_P(SplatKernel, FarSplatsStepFarther) {
    const Pinhole camera = test_camera(75, 58);
    const Splats s = random_splats(60, 11);
    const auto stepped = [&](float reach_m) {
        Cloud cloud(s, true);
        Engine engine(*kernel_);
        engine.render(cloud, camera, test_pose(), kBackground, false);
        engine.differentiate(noise_view(camera, test_pose(), 4, false), 0.2f);
        StepRates rates;
        rates.rates.fill(1e-3f), rates.middle = {0.1f, 0, 0.2f}, rates.reach_m = reach_m;
        engine.step(cloud, rates);
        return cloud.splats();
    };
    const Splats same = stepped(1e9f), far = stepped(0.5f);
    int moved = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const float stride = std::max(1.f, length(s.mean_m[i] - Vec3f{0.1f, 0, 0.2f}) / 0.5f),
                    step = length(same.mean_m[i] - s.mean_m[i]);
        EXPECT_NEAR(length(far.mean_m[i] - s.mean_m[i]), stride * step, 1e-5f + 1e-3f * stride * step);
        EXPECT_EQ(std::memcmp(&far.log_scale[i], &same.log_scale[i], sizeof(Vec3f)), 0);
        moved += step > 0 && stride > 1.5f;
    }
    EXPECT_GT(moved, 5);
}

TEST_P(SplatKernel, LossAndItsGradientAreTheReference) {
    for (const bool weighted : {false, true})
        for (const int width : {45, 64}) {
            const Pinhole camera = test_camera(width, 39);
            const View view = noise_view(camera, test_pose(), 2, weighted);
            const Splats s = random_splats(80, 21);
            Cloud cloud(s, true);
            Engine engine(*kernel_);
            engine.render(cloud, camera, test_pose(), {}, false);
            std::vector<Vec3d> picture;
            for (int y = 0; y < camera.height; ++y)
                for (int x = 0; x < camera.width; ++x) {
                    const Vec3f c = engine.color(x, y);
                    picture.push_back({c.x, c.y, c.z});
                }
            const LossSums mine = engine.differentiate(view, 0.2f);
            const ReferenceLoss ruler = loss_reference(picture, view, 0.2);
            EXPECT_NEAR(mine.loss, ruler.loss, 1e-6);
            EXPECT_NEAR(mine.squared_error, ruler.squared_error, 1e-6);
            Distance distance;
            for (int y = 0; y < camera.height; ++y)
                for (int x = 0; x < camera.width; ++x)
                    for (std::size_t c = 0; c < 3; ++c)
                        distance.add(engine.color_gradient(x, y)[c],
                                     ruler.v[static_cast<std::size_t>(y * camera.width + x)][c]);
            EXPECT_LT(distance.relative(), 1e-4);
        }
}

// Invalid splats (from a file or a diverged run) are drawn or skipped, but never affect the others.
TEST_P(SplatKernel, PoisonStaysWhereItIs) {
    const Pinhole camera = test_camera(64, 48);
    const Splats clean = random_splats(40, 17);
    constexpr std::int64_t kVictim = 18;
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    Splats without = clean;
    without.opacity_logit[kVictim] = -100;
    const auto render = [&](const Splats& s) {
        const Cloud cloud(s, false);
        Engine engine(*kernel_);
        engine.render(cloud, camera, test_pose(), {}, false);
        std::vector<Vec3f> out;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) out.push_back(engine.color(x, y));
        return out;
    };
    const std::vector<Vec3f> hole = render(without);
    for (const float poison : {nan, inf, -inf, 1e38f, -1e38f, 1e-42f}) {
        for (int p = 0; p < kParameters; ++p) {
            Cloud cloud(clean, true);
            cloud.parameters[cloud.at(kVictim, p)] = poison;
            const std::vector<Vec3f> picture = render(cloud.splats());
            for (const Vec3f& c : picture) ASSERT_TRUE(std::isfinite(c.x + c.y + c.z)) << p << ' ' << poison;
            if (std::isnan(poison)) {
                EXPECT_EQ(picture, hole) << p;
            }
            Engine engine(*kernel_);
            engine.render(cloud, camera, test_pose(), {}, false);
            engine.differentiate(noise_view(camera, test_pose(), 5, false), 0.2f);
            engine.step(
                cloud,
                {1e-3f, 1e-3f, 1e-3f, 1e-3f, 1e-3f, 1e-3f, 1e-3f, 1e-3f, 1e-3f, 1e-3f, 1e-3f, 1e-3f, 1e-3f, 1e-3f}, 1);
            for (std::int64_t i = 0; i < cloud.count; ++i)
                for (int q = 0; q < kParameters; ++q)
                    if (i != kVictim) {
                        ASSERT_TRUE(std::isfinite(cloud.parameters[cloud.at(i, q)]))
                            << p << ' ' << poison << ' ' << i << ' ' << q;
                    }
        }
    }
    Splats zero = clean;
    zero.rotation[kVictim] = {0, 0, 0, 0};
    EXPECT_EQ(render(zero), hole);
}

TEST_P(SplatKernel, OrderOfTheSplatsDoesNotMatter) {
    const Pinhole camera = test_camera(64, 48);
    const Splats s = random_splats(100, 23);
    Splats reversed = s;
    std::reverse(reversed.mean_m.begin(), reversed.mean_m.end());
    std::reverse(reversed.log_scale.begin(), reversed.log_scale.end());
    std::reverse(reversed.rotation.begin(), reversed.rotation.end());
    std::reverse(reversed.opacity_logit.begin(), reversed.opacity_logit.end());
    std::reverse(reversed.sh0.begin(), reversed.sh0.end());
    Engine a(*kernel_), b(*kernel_);
    a.render(Cloud(s, false), camera, test_pose(), kBackground, false);
    b.render(Cloud(reversed, false), camera, test_pose(), kBackground, false);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) ASSERT_EQ(a.color(x, y), b.color(x, y));
}

TEST(Splat, MovingWorldAndCameraTogetherChangesNothing) {
    const Pinhole camera = test_camera(64, 48);
    const Splats s = random_splats(80, 29);
    const Quatf turn{0.8f, 0.3f, -0.4f, 0.33f};
    const Rigid move{matrix_of(turn), {3.f, -2.f, 1.f}};
    Splats moved = s;
    for (std::size_t i = 0; i < s.size(); ++i)
        moved.mean_m[i] = move * s.mean_m[i], moved.rotation[i] = turn * s.rotation[i];
    const SplatPicture a = render_splats(s, camera, test_pose()), b = render_splats(moved, camera, move * test_pose());
    double worst = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        worst = std::max(worst, static_cast<double>(length(a.color.pixels[i] - b.color.pixels[i])));
    EXPECT_LT(worst, 5e-3);  // an alpha near 1/255 may fall on either side
}

TEST_P(SplatKernel, NumberOfThreadsDoesNotChangeAByte) {
    const Pinhole camera = test_camera(130, 3 * kLossRows + 5);  // enough rows for several bands
    const int before = thread_count();
    std::vector<AlignedFloats> results;
    std::vector<double> losses;
    for (const int threads : {1, 2, 3}) {
        set_threads(threads);
        Cloud cloud(random_splats(5000, 31), true);
        Engine engine(*kernel_);
        for (int step = 1; step <= 4; ++step) {
            engine.render(cloud, camera, test_pose(), {}, false);
            losses.push_back(engine.differentiate(noise_view(camera, test_pose(), 7, false), 0.2f).loss);
            engine.step(
                cloud,
                {1e-3f, 1e-3f, 1e-3f, 1e-2f, 1e-2f, 1e-2f, 1e-3f, 1e-3f, 1e-3f, 1e-3f, 1e-2f, 1e-2f, 1e-2f, 1e-2f},
                step);
        }
        results.push_back(cloud.parameters);
    }
    set_threads(before);
    for (std::size_t i = 1; i < results.size(); ++i) {
        ASSERT_EQ(results[0].size(), results[i].size());
        EXPECT_EQ(std::memcmp(results[0].data(), results[i].data(), results[0].size() * sizeof(float)), 0) << i;
    }
    for (std::size_t i = 0; i < losses.size(); ++i) EXPECT_EQ(losses[i], losses[i % 4]) << i;
}

}  // namespace
}  // namespace fastscene::splat
