// The renderer on graphics cards against the reference. Without a card it runs on Mesa's lavapipe. The validation layer
// watches all of it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "bench/textured_room.h"
#include "fastscene/splat/relocate.h"
#include "fastscene/splat/splat.h"
#include "fastscene/splat/test_scene.h"
#include "fastscene/splat/vulkan/engine.h"

namespace fastscene::splat::vulkan {
namespace {

const Vec3f kBackground{0.2f, 0.4f, 0.6f};

class VulkanSplat : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        setenv("FASTSCENE_VULKAN_VALIDATION", "1", 0);
        engine_ = new VulkanEngine(gpu::has_card() ? "auto" : "llvmpipe");
    }
    static void TearDownTestSuite() { delete engine_; }
    void TearDown() override { EXPECT_EQ(engine_->device().validation_messages(), std::vector<std::string>{}); }
    static VulkanEngine& engine() { return *engine_; }

  private:
    static inline VulkanEngine* engine_ = nullptr;
};

// What a step may be asked for.
struct Case {
    const char* name;
    int degree = 0;
    bool antialias = false;
    CameraModel model = CameraModel::pinhole;
    bool weighted = false, depth = false, open = false, outside = false;
    float low_pass_px2 = FootprintFilter{}.low_pass_px2;
    FootprintFilter filter() const { return {low_pass_px2, antialias}; }
};
const Case kCases[] = {
    {"pinhole"},
    {"weighted", 0, false, CameraModel::pinhole, true},
    {"degree 1", 1},
    {"sharp", 1, false, CameraModel::pinhole, false, false, false, false, kLeastLowPassPx2},
    {"degree 3, antialiased", 3, true},
    {"depth and transmittance", 2, false, CameraModel::pinhole, true, true, true},
    {"outside", 0, false, CameraModel::pinhole, false, false, false, true},
    {"panorama", 2, false, CameraModel::equirectangular, true},
    {"panorama, everything", 1, true, CameraModel::equirectangular, true, true, true, true},
};

struct Scene {
    Splats splats;
    Pinhole camera;
    View view;
    ImageF depth;
    StepPlan plan;
};
Scene scene_of(const Case& c, int count, std::uint64_t seed) {
    Scene s{random_splats(count, seed), test_camera(75, 58), {}, {}, {}};
    if (c.model == CameraModel::equirectangular) {
        s.camera = Pinhole{96, 48, 0, 0, 0, 0};
        // All around the camera, some across the seam.
        Random r(seed, "test.around");
        for (Vec3f& m : s.splats.mean_m) {
            const float angle = r.uniform(0.f, 6.3f), far = r.uniform(1.f, 4.f);
            m = {far * std::sin(angle), r.uniform(-1.f, 1.f) * far, far * std::cos(angle)};
        }
    }
    s.splats.sh_degree = c.degree, s.splats.filter = c.filter();
    s.splats.resize(s.splats.size());
    Random r(seed, "test.rest");
    for (float& x : s.splats.sh_rest) x = r.uniform(-0.2f, 0.2f);
    s.view = noise_view(s.camera, test_pose(), 5, c.weighted);
    s.view.model = c.model;
    s.depth = ImageF(s.camera.width, s.camera.height);
    for (float& d : s.depth.pixels) d = r.uniform(-0.5f, 4.f);  // some unknown
    s.plan.background = kBackground;
    s.plan.depth_strength = c.depth ? 0.3f : 0, s.plan.alpha_strength = c.open ? 0.2f : 0;
    if (c.outside) s.plan.outside_m = 2.5f;
    return s;
}
const ImageF* depth_of(const Case& c, const Scene& s) { return c.depth ? &s.depth : nullptr; }

struct Truth {
    double loss = 0, squared_error = 0;
    ReferencePicture<double> picture;
    std::vector<Gaussian<double>> gradients;
    std::vector<double> rest;
};
Truth truth_of(const Case& c, const Scene& s) {
    Truth t;
    const auto splats = gaussians_of<double>(s.splats);
    const auto rest = rest_of<double>(s.splats);
    const auto lens = lens_over<double>(lens_of(s.camera, test_pose(), c.model, c.filter()));
    const Vec3d background{kBackground.x, kBackground.y, kBackground.z};
    t.picture = render_reference(splats, lens, s.camera.width, s.camera.height, background, rest);
    ReferencePicture<double> picture = t.picture;
    std::vector<Vec3d> colors;
    for (const auto& p : picture.pixels) colors.push_back(p.color);
    const ReferenceLoss loss = loss_reference(colors, s.view, s.plan.lambda_dssim);
    t.loss = loss.loss, t.squared_error = loss.squared_error;
    std::vector<double> v_depth, v_open;
    if (c.depth) t.loss += depth_loss_reference(picture, s.view, s.depth, s.plan.depth_strength, v_depth);
    if (c.open) t.loss += transmittance_loss_reference(picture, s.view, s.plan.alpha_strength, v_open);
    t.gradients = gradients_reference(splats, lens, picture, loss.v, rest, &t.rest, v_depth, v_open,
                                      static_cast<double>(s.plan.outside_m));
    return t;
}

TEST_F(VulkanSplat, PictureIsTheReference) {
    for (const Case& c : kCases) {
        SCOPED_TRACE(c.name);
        const Scene s = scene_of(c, 300, 3);
        const Truth truth = truth_of(c, s);
        engine().load(Cloud(s.splats, false));
        const SplatPicture picture = engine().render(s.camera, test_pose(), kBackground, c.model);
        Distance color, alpha, depth;
        for (std::size_t i = 0; i < truth.picture.pixels.size(); ++i) {
            const double opaque = 1 - truth.picture.pixels[i].transmittance;
            for (std::size_t k = 0; k < 3; ++k) color.add(picture.color.pixels[i][k], truth.picture.pixels[i].color[k]);
            alpha.add(picture.alpha.pixels[i], opaque);
            depth.add(picture.depth_z.pixels[i] * picture.alpha.pixels[i], truth.picture.depth_sum[i]);
        }
        EXPECT_LT(color.relative(), 1e-4);
        EXPECT_LT(alpha.relative(), 1e-3);  // blending stops at kOpaque
        EXPECT_LT(depth.relative(), 3e-4);
    }
}

TEST_F(VulkanSplat, LossAndGradientsAreTheReference) {
    for (const Case& c : kCases) {
        SCOPED_TRACE(c.name);
        const Scene s = scene_of(c, 60, 11);
        const Truth truth = truth_of(c, s);
        const Cloud cloud(s.splats, true);
        const auto mine = engine().gradients(cloud, s.view, depth_of(c, s), s.plan);
        EXPECT_NEAR(mine.loss.loss, truth.loss, 1e-5);
        EXPECT_NEAR(mine.loss.squared_error, truth.squared_error, 1e-5);
        // A pixel whose transmittance is close to the outside's threshold may fall to either side.
        const double tolerance = c.outside ? 2e-3 : 2e-4;
        for (int p = 0; p < kParameters; ++p) {
            Distance distance;
            for (std::int64_t i = 0; i < cloud.count; ++i) {
                Gaussian<double> g = truth.gradients[static_cast<std::size_t>(i)];
                distance.add(mine.parameters[cloud.at(i, p)], parameter(g, p));
            }
            EXPECT_GT(distance.size2, 0) << p;
            EXPECT_LT(distance.relative(), tolerance) << p;
        }
        Distance rest;
        const int n = 3 * rest_functions(c.degree);
        for (std::int64_t i = 0; i < cloud.count; ++i)
            for (int k = 0; k < n; ++k)
                rest.add(mine.rest[cloud.rest_at(i, k)], truth.rest[static_cast<std::size_t>(i * n + k)]);
        EXPECT_TRUE(n == 0 || rest.relative() < tolerance) << rest.relative();
    }
}

// Steps one after the other: Adam, its moments, regularizers and statistics are the reference's.
TEST_F(VulkanSplat, StepsAreTheReference) {
    const Case c{"steps", 2, true, CameraModel::pinhole, true};
    Scene s = scene_of(c, 80, 7);
    s.camera = test_camera(80, 64);  // whole tiles: the CPU's statistics count the pixels beyond, too
    s.view = noise_view(s.camera, test_pose(), 5, c.weighted);
    s.plan.rates.rates = {2e-4f, 2e-4f, 2e-4f, 2e-3f, 2e-3f, 2e-3f, 1e-3f,
                          1e-3f, 1e-3f, 1e-3f, 2e-2f, 2e-3f, 2e-3f, 2e-3f};
    s.plan.rates.reach_m = 2, s.plan.rates.opacity_reg = 1e-5f, s.plan.rates.scale_reg = 1e-5f;
    const auto steppers = {make_stepper({"reference"}), make_stepper({"cpu"})};
    Cloud mine(s.splats, true);
    engine().load(mine);
    engine().set_views({&s.view});
    Cloud truth(s.splats, true), cpu(s.splats, true);
    for (const auto& stepper : steppers) stepper->set_views({&s.view}, {});
    for (int step = 1; step <= 5; ++step) {
        s.plan.rates.adam_step = step, s.plan.rates.rest_rate = step % 2 == 0 ? 1e-3f : 0;
        s.plan.rates.rest_adam_step = std::max(1, step / 2);
        engine().step(0, s.plan);
        (*steppers.begin())->step(truth, 0, s.plan), (*(steppers.begin() + 1))->step(cpu, 0, s.plan);
    }
    const auto losses = engine().finish(), true_losses = (*steppers.begin())->losses();
    ASSERT_EQ(losses.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(losses[i].loss, true_losses[i].loss, 1e-4) << i;
    engine().store(mine);
    const Splats start = s.splats, a = mine.splats(), b = truth.splats();
    Distance means, rest;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            means.add(a.mean_m[i][k] - start.mean_m[i][k], b.mean_m[i][k] - start.mean_m[i][k]);
    for (std::size_t i = 0; i < a.sh_rest.size(); ++i)
        rest.add(a.sh_rest[i] - start.sh_rest[i], b.sh_rest[i] - start.sh_rest[i]);
    EXPECT_LT(means.relative(), 2e-2);  // Adam's steps are signs where gradients are small
    EXPECT_LT(rest.relative(), 2e-2);
    Distance weight, error;
    for (std::int64_t i = 0; i < mine.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        weight.add(mine.seen_weight[k], cpu.seen_weight[k]), error.add(mine.seen_error[k], cpu.seen_error[k]);
    }
    EXPECT_LT(weight.relative(), 1e-3);
    EXPECT_LT(error.relative(), 1e-3);
}

// Sums have a fixed order: the same bytes from run to run, however many steps are recorded ahead.
TEST_F(VulkanSplat, RunsRepeatBitForBit) {
    const Case c{"repeat", 1};
    Scene s = scene_of(c, 500, 5);
    s.plan.rates.rates.fill(1e-3f);
    const auto run = [&](bool ahead) {
        Cloud cloud(s.splats, true);
        engine().load(cloud);
        engine().set_views({&s.view});
        for (int step = 1; step <= 12; ++step) {
            s.plan.rates.adam_step = step;
            engine().step(0, s.plan);
            if (!ahead) engine().finish();
        }
        engine().store(cloud);
        return cloud.parameters;
    };
    const AlignedFloats first = run(true), second = run(true), third = run(false);
    EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(float)), 0);
    EXPECT_EQ(std::memcmp(first.data(), third.data(), first.size() * sizeof(float)), 0);
}

// A step whose pairs do not fit is made again with more room, and so are all that were recorded after it.
TEST_F(VulkanSplat, MemoryForPairsGrows) {
    const Case c{"pairs", 0};
    Scene s = scene_of(c, 500, 5);
    s.plan.rates.rates.fill(1e-3f);
    const auto run = [&](std::int64_t pairs) {
        Cloud cloud(s.splats, true);
        engine().load(cloud);
        engine().set_views({&s.view});
        if (pairs) engine().reserve_pairs(pairs);
        std::vector<double> losses;
        for (int step = 1; step <= 20; ++step) {
            s.plan.rates.adam_step = step;
            engine().step(0, s.plan);
        }
        for (const LossSums& l : engine().finish()) losses.push_back(l.loss);
        engine().store(cloud);
        return std::pair(losses, cloud.splats());
    };
    const auto roomy = run(0), tight = run(64);
    EXPECT_GT(engine().reserved_pairs(), 64);
    EXPECT_EQ(roomy.first.size(), 20u);
    EXPECT_EQ(roomy.first, tight.first);
    EXPECT_EQ(roomy.second, tight.second);
}

// Growth and relocation. A splat that is sampled twice is split once, so somewhat fewer are made than asked for.
TEST_F(VulkanSplat, DensityControlSplitsWhereTheErrorIs) {
    const Case c{"density", 2};
    Scene s = scene_of(c, 1000, 5);
    for (std::size_t i = 0; i < 1000; i += 10) s.splats.opacity_logit[i] = -9;  // dead
    for (Vec3f& scale : s.splats.log_scale) scale = {-3.5f, -3.2f, -3.4f};
    s.splats.mean_m[50].x = std::numeric_limits<float>::quiet_NaN();
    s.plan.judge = true;
    const auto run = [&] {
        Cloud cloud(s.splats, true, 1500);
        engine().load(cloud);
        engine().set_views({&s.view});
        engine().step(0, s.plan);  // rates of zero: only the statistics change
        engine().store(cloud);
        const AlignedFloats error = cloud.seen_error;
        engine().relocate(0.2f, 99);
        engine().store(cloud);
        return std::pair(error, cloud);
    };
    const auto [error, cloud] = run();
    EXPECT_GT(cloud.count, 1120);
    EXPECT_LE(cloud.count, 1200);
    const Splats after = cloud.splats();
    int split = 0, dead = 0;
    for (std::size_t i = 0; i < 1000; ++i) {
        const bool changed = after.mean_m[i] != s.splats.mean_m[i], was_dead = i % 10 == 0;
        EXPECT_EQ(cloud.seen_error[i], 0);
        if (was_dead) dead += !changed || after.opacity_logit[i] < -5;
        if (was_dead || !changed) continue;
        EXPECT_GT(error[i], 0) << i;
        ++split;
    }
    EXPECT_GT(split, 150);
    EXPECT_LT(dead, 40);
    EXPECT_TRUE(std::isfinite(after.mean_m[50].x) || dead > 0);
    // The same choice each time, and another one for another seed.
    EXPECT_EQ(run().second.splats(), after);
    // The first splat that was appended and its other half are what split() makes.
    Cloud expected(s.splats, true, 1500);
    expected.count = 1001;
    std::size_t from = 0;
    for (std::size_t i = 0; i < 1000; ++i)
        if (after.sh0[i] == after.sh0[1000] && after.sh_rest[24 * i] == after.sh_rest[24000]) from = i;
    splat::split(expected, static_cast<std::int64_t>(from), 1000);
    const Splats two = expected.splats();
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(two.mean_m[1000][k], after.mean_m[1000][k], 1e-4f);
    EXPECT_NEAR(two.opacity_logit[1000], after.opacity_logit[1000], 1e-3f);
}

// Training on the card from sentence to splats: as good as on the processor.
TEST_F(VulkanSplat, TrainingIsAsGoodAsOnTheProcessor) {
    const bench::RoomSet set = bench::room_set(64, 1, 2000, 0, 4);
    SplatParams params;
    params.count = 1500, params.steps = 150, params.sh_degree = 1, params.eval_every = 150, params.holdout = 4;
    params.coarse = 0.2f;
    const FittedSplats cpu = fit_splats(set.train, params, fastscene::Run{});
    params.backend = {"vulkan", gpu::has_card() ? "auto" : "llvmpipe"};
    const FittedSplats card = fit_splats(set.train, params, fastscene::Run{});
    EXPECT_EQ(card.splats.size(), cpu.splats.size());
    EXPECT_EQ(card.curve.size(), cpu.curve.size());
    EXPECT_NEAR(card.evals.back().psnr, cpu.evals.back().psnr, 0.02f);
    EXPECT_NEAR(card.evals.back().ssim, cpu.evals.back().ssim, 0.002f);
}

// Stopped at a checkpoint, with the count still growing, and continued: the same bytes as without a stop. So two
// trainings are the same bytes, too.
TEST_F(VulkanSplat, ACheckpointContinuesBitForBit) {
    const bench::RoomSet set = bench::room_set(48, 1, 800, 0, 4);
    SplatParams params;
    params.count = 1500, params.steps = 260, params.sh_degree = 1, params.coarse = 0.2f;
    params.backend = {"vulkan", gpu::has_card() ? "auto" : "llvmpipe"};
    const FittedSplats straight = fit_splats(set.train, params, fastscene::Run{});
    EXPECT_GT(straight.splats.size(), 800u);
    params.checkpoint = (std::filesystem::temp_directory_path() / "fastscene_vulkan_checkpoint").string();
    std::filesystem::remove(params.checkpoint);
    params.until = 130;
    fit_splats(set.train, params, fastscene::Run{});
    params.until = 0;
    const FittedSplats continued = fit_splats(set.train, params, fastscene::Run{});
    std::filesystem::remove(params.checkpoint);
    EXPECT_EQ(continued.splats, straight.splats);
    ASSERT_EQ(continued.curve.size(), straight.curve.size());
    for (std::size_t i = 0; i < straight.curve.size(); ++i) {
        EXPECT_EQ(continued.curve[i].step, straight.curve[i].step);
        EXPECT_EQ(continued.curve[i].loss, straight.curve[i].loss);
    }
}

TEST_F(VulkanSplat, UnknownDevicesAreNamed) {
    for (const std::string name : {"99", "no such card"}) try {
            const VulkanEngine other(name);
            ADD_FAILURE() << name;
        } catch (const UsageError& e) {
            EXPECT_NE(std::string(e.what()).find("--splat-device " + name), std::string::npos) << e.what();
            EXPECT_NE(std::string(e.what()).find(engine().device().info().name), std::string::npos) << e.what();
        }
}

// Sizes at which something could go wrong: fewer pixels than a tile, more tiles than a byte counts, no splat in sight.
TEST_F(VulkanSplat, AnySizeOfPictureAndAnyNumberOfSplats) {
    for (const auto& [width, height, count] : {std::tuple{1, 1, 5}, {17, 3, 40}, {700, 400, 3000}, {64, 64, 1}}) {
        SCOPED_TRACE(width);
        const Pinhole camera = test_camera(width, height);
        const Splats s = random_splats(count, 9);
        engine().load(Cloud(s, false));
        const SplatPicture mine = engine().render(camera, test_pose(), kBackground, CameraModel::pinhole),
                           cpu = render_splats(s, camera, test_pose(), kBackground);
        Distance color;
        for (std::size_t i = 0; i < mine.color.pixels.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) color.add(mine.color.pixels[i][k], cpu.color.pixels[i][k]);
        EXPECT_LT(color.relative(), 1e-3);
    }
    Splats behind = random_splats(20, 1);
    for (Vec3f& m : behind.mean_m) m.z = -m.z;
    engine().load(Cloud(behind, false));
    const SplatPicture empty = engine().render(test_camera(40, 30), {}, kBackground, CameraModel::pinhole);
    for (const auto& p : empty.color.pixels) EXPECT_EQ(p, kBackground);
}

}  // namespace
}  // namespace fastscene::splat::vulkan
