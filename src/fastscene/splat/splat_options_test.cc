// Training options: strategies, SH degrees, held-out views, checkpoints, equirectangular views.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>

#include <unistd.h>

#include "bench/textured_room.h"
#include "fastscene/base/file.h"
#include "fastscene/base/memory.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/splat/classic.h"
#include "fastscene/splat/coarse.h"
#include "fastscene/splat/relocate.h"
#include "fastscene/splat/splat.h"

namespace fastscene {
namespace {

const bench::RoomSet& room() {
    static const bench::RoomSet set = bench::room_set(48, 2, 3000, 2, 1);
    return set;
}
SplatParams short_run(int count, int steps) {
    SplatParams params;
    params.count = count;
    params.steps = steps;
    return params;
}
double psnr_of(const SplatPicture& picture, const View& truth) {
    double sum = 0;
    for (std::size_t i = 0; i < truth.color.size(); ++i) {
        const Vec3f d = picture.color.pixels[i] - unit_from_srgb8(truth.color.pixels[i]);
        sum += dot(d, d);
    }
    return -10 * std::log10(sum / (3.0 * static_cast<double>(truth.color.size())));
}

class SplatOptions : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() / ("fastscene-splat-options-" + std::to_string(::getpid()));
        std::filesystem::remove_all(folder_);
        make_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::filesystem::path folder_;
};

TEST_F(SplatOptions, EveryStrategyLearnsAndNoneExceedsTheCap) {
    ViewSet sparse = room().train;
    sparse.points.resize(600);
    for (const char* strategy : {"mcmc", "classic", "none"}) {
        SplatParams params = short_run(1500, 400);
        params.strategy = strategy;
        const FittedSplats fitted = fit_splats(sparse, params, fastscene::Run{});
        EXPECT_LE(fitted.splats.size(), 1500u) << strategy;
        EXPECT_GT(fitted.curve.back().psnr, fitted.curve.front().psnr + 1) << strategy;
        if (std::string(strategy) == "none") {
            EXPECT_EQ(fitted.splats.size(), 600u);
        } else {
            EXPECT_GT(fitted.splats.size(), 650u) << strategy;
        }
    }
}

// A pixel of the half-size view shows the mean of its four pixels, through an equivalent camera.
TEST_F(SplatOptions, HalfViewsSeeTheSame) {
    const View whole = room().train.views[3], half = splat::half_view(whole);
    ASSERT_EQ(half.camera.width, 24);
    const Vec3f a = whole.camera.direction_at({20, 30}), b = half.camera.direction_at({10, 15});
    EXPECT_NEAR(length(a - b), 0, 1e-6);
    const Splats splats = initial_splats(room().train.points, 3000, fastscene::Run{});
    const auto fit = [&](const View& v) { return psnr_of(render_splats(splats, v.camera, v.world_from_camera), v); };
    EXPECT_GT(fit(half),
              fit(whole) - 0.5);  // a camera off by half a pixel would be worse; less detail is easier to fit
    View masked = whole;
    masked.weight = ImageMask(48, 48);
    masked.weight.at(0, 0) = 200;
    EXPECT_EQ(splat::half_view(masked).color.at(0, 0), whole.color.at(0, 0));
    EXPECT_EQ(splat::half_view(masked).weight.at(0, 0), 50);
    EXPECT_EQ(splat::half_view(half).camera.width, 24);  // too small to be halved
}

// A coarse start costs less and loses little; a run interrupted during it resumes to the same bytes.
TEST_F(SplatOptions, CoarseBeginning) {
    SplatParams params = short_run(2000, 200), coarse = params;
    coarse.coarse = 0.4f;
    const FittedSplats whole = fit_splats(room().train, coarse, fastscene::Run{});
    EXPECT_GT(whole.curve.back().psnr, fit_splats(room().train, params, fastscene::Run{}).curve.back().psnr - 0.7f);
    coarse.checkpoint = folder_ / "coarse.checkpoint";
    coarse.until = 50;
    fit_splats(room().train, coarse, fastscene::Run{});
    coarse.until = 0;
    EXPECT_TRUE(fit_splats(room().train, coarse, fastscene::Run{}).splats == whole.splats);
}

// Interrupted anywhere, training resumes to the same bytes; it can also be extended beyond its end.
TEST_F(SplatOptions, CheckpointGoesOnToTheSameBytes) {
    for (const char* strategy : {"mcmc", "classic"}) {
        SplatParams params = short_run(1200, 130);
        params.strategy = strategy;
        params.sh_degree = 1;
        params.checkpoint = folder_ / (std::string(strategy) + ".checkpoint");
        SplatParams whole = params;
        whole.checkpoint.clear();
        params.until = 57;
        EXPECT_EQ(fit_splats(room().train, params, fastscene::Run{}).steps, 57);
        params.until = 0;
        const FittedSplats resumed = fit_splats(room().train, params, fastscene::Run{}),
                           straight = fit_splats(room().train, whole, fastscene::Run{});
        EXPECT_EQ(resumed.steps, 130);
        EXPECT_TRUE(resumed.splats == straight.splats) << strategy;
        ASSERT_EQ(resumed.curve.size(), straight.curve.size());
        for (std::size_t i = 0; i < resumed.curve.size(); ++i) EXPECT_EQ(resumed.curve[i].loss, straight.curve[i].loss);
        params.until = 160;
        const FittedSplats more = fit_splats(room().train, params, fastscene::Run{});
        EXPECT_EQ(more.steps, 160);
        EXPECT_FALSE(more.splats == straight.splats);
    }
}

TEST_F(SplatOptions, CheckpointOfSomethingElseIsRefused) {
    SplatParams params = short_run(500, 20);
    params.checkpoint = folder_ / "a.checkpoint";
    fit_splats(room().train, params, fastscene::Run{});
    SplatParams other = params;
    other.lambda_dssim = 0.3f;
    EXPECT_THROW(fit_splats(room().train, other, fastscene::Run{}), Error);
    std::string bytes = read_file(params.checkpoint);
    for (const std::size_t cut :
         {std::size_t{0}, std::size_t{10}, std::size_t{70}, bytes.size() / 2, bytes.size() - 1}) {
        write_file(params.checkpoint, std::string_view(bytes).substr(0, cut));
        EXPECT_THROW(fit_splats(room().train, params, fastscene::Run{}), Error) << cut;
    }
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    write_file(params.checkpoint, std::string_view(bytes));
    EXPECT_THROW(fit_splats(room().train, params, fastscene::Run{}), Error);
}

// A disk that fills up during training costs the checkpoint, not the training; a path that cannot be written is
// reported before training starts.
TEST_F(SplatOptions, TrainingOutlivesItsCheckpoint) {
    struct Listener : EventSink {
        std::vector<std::string> warnings;
        std::function<void()> at_half;
        void tell(const Event& event) override {
            if (const auto* w = std::get_if<WarningEvent>(&event)) warnings.push_back(w->text);
            if (const auto* p = std::get_if<ProgressEvent>(&event); p && p->done == p->total / 2 && at_half)
                std::exchange(at_half, nullptr)();
        }
    } listener;
    SplatParams params = short_run(500, 20);
    const Splats wanted = fit_splats(room().train, params, fastscene::Run{}).splats;
    params.checkpoint = folder_ / "gone" / "c.checkpoint";
    EXPECT_THROW(fit_splats(room().train, params, fastscene::Run{}), Error);
    std::filesystem::create_directories(folder_ / "gone");
    listener.at_half = [&] { std::filesystem::remove_all(folder_ / "gone"); };
    EXPECT_TRUE(fit_splats(room().train, params, {0, &listener, {}}).splats == wanted);
    ASSERT_EQ(listener.warnings.size(), 1u);
    EXPECT_NE(listener.warnings[0].find("c.checkpoint"), std::string::npos);
}

TEST_F(SplatOptions, CheckpointsKnowWhoseTheyAre) {
    SplatParams params = short_run(500, 20);
    params.checkpoint = folder_ / "whose.checkpoint";
    EXPECT_FALSE(is_checkpoint_of(params.checkpoint, room().train, params, 0));
    fit_splats(room().train, params, fastscene::Run{});
    EXPECT_TRUE(is_checkpoint_of(params.checkpoint, room().train, params, 0));
    EXPECT_FALSE(is_checkpoint_of(params.checkpoint, room().train, params, 1));
    params.until = 30;
    EXPECT_TRUE(is_checkpoint_of(params.checkpoint, room().train, params, 0));
    params.sh_degree = 1;
    EXPECT_FALSE(is_checkpoint_of(params.checkpoint, room().train, params, 0));
}

TEST_F(SplatOptions, WhatCannotBeIsSaidAtOnce) {
    SplatParams params = short_run(500, 20);
    params.patience = 3;
    EXPECT_THROW(fit_splats(room().train, params, fastscene::Run{}), UsageError);
    params.patience = 0, params.sh_degree = 3, params.count = 20000000;  // 16 GiB and more
    if (available_memory() == 0 || available_memory() > (std::int64_t{15} << 30)) return;
    try {
        fit_splats(room().train, params, fastscene::Run{});
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("--splat-count"), std::string::npos) << e.what();
    }
}

TEST_F(SplatOptions, HeldOutViewsAreMeasuredAndStopTraining) {
    SplatParams params = short_run(1500, 600);
    params.eval_every = 20;
    params.holdout = 7;
    const FittedSplats all = fit_splats(room().train, params, fastscene::Run{});
    ASSERT_EQ(all.evals.size(), 30u);
    EXPECT_GT(all.evals.back().psnr, all.evals.front().psnr);
    EXPECT_GT(all.evals.back().ssim, 0.5f);
    EXPECT_LE(all.evals.back().ssim, 1.f);
    ASSERT_EQ(all.eval_pictures.size(), 4u);
    EXPECT_EQ(all.eval_pictures[0].view, room().train.views[6].name);
    params.steps = 5000;  // large steps for long: after a while the held-out views stop improving
    params.patience = 3;
    params.learning_rate_mean_m = 0.02f;
    const FittedSplats stopped = fit_splats(room().train, params, fastscene::Run{});
    EXPECT_LT(stopped.steps, 5000);
    params.holdout = 1000;
    EXPECT_THROW(fit_splats(room().train, params, fastscene::Run{}), Error);
}

// Red that varies with viewing angle: degree 0 cannot represent it, degree 1 can.
TEST_F(SplatOptions, HigherBandsLearnWhatHangsOnTheDirection) {
    const bench::TexturedRoom world;
    const Pinhole camera = Pinhole::with_fov(48, 48, 90);
    ViewSet set;
    set.points = room().train.points;
    for (const float x : {-1.4f, -0.5f, 0.5f, 1.4f})
        for (int i = 0; i < 8; ++i) {
            View v = world.view(camera, {bench::looking(45.f * static_cast<float>(i), 0), {x, 0, 0.3f * x}}, 1);
            v.name = std::to_string(set.views.size());
            for (int py = 0; py < 48; ++py)
                for (int px = 0; px < 48; ++px) {
                    const Vec3f d = normalize(
                        v.world_from_camera.rotation *
                        camera.direction_at({static_cast<float>(px) + 0.5f, static_cast<float>(py) + 0.5f}));
                    Rgb8& p = v.color.at(px, py);
                    p.r = static_cast<std::uint8_t>(static_cast<float>(p.r) * (0.6f + 0.4f * d.x));
                }
            set.views.push_back(std::move(v));
        }
    SplatParams params = short_run(1500, 500);
    const float flat = fit_splats(set, params, fastscene::Run{}).curve.back().psnr;
    params.sh_degree = 2;
    const FittedSplats bands = fit_splats(set, params, fastscene::Run{});
    EXPECT_EQ(bands.splats.sh_degree, 2);
    EXPECT_EQ(bands.splats.sh_rest.size(), bands.splats.size() * 24);
    EXPECT_GT(bands.curve.back().psnr, flat + 0.4f);
}

TEST_F(SplatOptions, BackendsAgreeWithHigherBandsAndRegularizers) {
    ViewSet set = room().train;
    set.views.resize(2);
    SplatParams params = short_run(300, 8);
    params.sh_degree = 1;
    params.opacity_reg = 0.1f, params.scale_reg = 1.f;
    params.random_background = true;
    const FittedSplats fast = fit_splats(set, params, fastscene::Run{});
    params.backend.name = "reference";
    const FittedSplats slow = fit_splats(set, params, fastscene::Run{});
    EXPECT_NEAR(fast.curve.back().loss, slow.curve.back().loss, 1e-3f);
    double far = 0, size = 0;
    for (std::size_t i = 0; i < fast.splats.sh_rest.size(); ++i)
        far += std::fabs(fast.splats.sh_rest[i] - slow.splats.sh_rest[i]), size += std::fabs(slow.splats.sh_rest[i]);
    EXPECT_GT(size, 0);
    EXPECT_LT(far, 0.1 * size);
}

TEST_F(SplatOptions, PullsLowerOpacitiesAndSizes) {
    SplatParams params = short_run(1000, 100);
    params.strategy = "none";
    const auto means = [&] {
        const Splats s = fit_splats(room().train, params, fastscene::Run{}).splats;
        double opacity = 0, scale = 0;
        for (std::size_t i = 0; i < s.size(); ++i)
            opacity += 1 / (1 + std::exp(-s.opacity_logit[i])), scale += std::exp(s.log_scale[i].x);
        return std::pair(opacity, scale);
    };
    const auto before = means();
    params.opacity_reg = 1, params.scale_reg = 10;
    const auto after = means();
    EXPECT_LT(after.first, 0.9 * before.first);
    EXPECT_LT(after.second, 0.95 * before.second);
}

// Trained on equirectangular pictures only, measured on perspective ones at other poses.
TEST_F(SplatOptions, EquirectangularPicturesTeachWithoutCuts) {
    const EquirectSize size{160, 80};
    const bench::TexturedRoom world;
    ViewSet set;
    set.points = room().train.points;
    for (const Vec3f at : {Vec3f{0, 0, 0}, Vec3f{0.3f, 0.1f, 0.2f}, Vec3f{-0.3f, 0, 0.2f}, Vec3f{0.1f, -0.2f, -0.3f}}) {
        View v;
        v.name = std::to_string(set.views.size());
        v.model = CameraModel::equirectangular;
        v.camera = {size.width, size.height, 0, 0, 0, 0};
        v.world_from_camera = {bench::looking(40.f * static_cast<float>(set.views.size()), 0), at};
        v.color = ImageRgb8(size.width, size.height);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const Vec3f d = v.world_from_camera.rotation * direction_of_pixel(x, y, size);
                const bench::RoomHit h = world.hit(at, d);
                const Vec3f c = world.color(at + d * h.range, h);
                v.color.at(x, y) = {byte_from_unit(c.x), byte_from_unit(c.y), byte_from_unit(c.z)};
            }
        set.views.push_back(std::move(v));
    }
    const SplatParams params = short_run(3000, 300);
    const Splats before = initial_splats(set.points, params.count, fastscene::Run{}),
                 after = fit_splats(set, params, fastscene::Run{}).splats;
    double gain = 0;
    for (const View& v : room().held_out)
        gain += psnr_of(render_splats(after, v.camera, v.world_from_camera), v) -
                psnr_of(render_splats(before, v.camera, v.world_from_camera), v);
    EXPECT_GT(gain / static_cast<double>(room().held_out.size()), 2);
}

TEST(SplatExtent, CamerasThatLookOutwardAreMeasuredByWhatTheySee) {
    EXPECT_GT(splat::scene_extent(room().train).radius_m, 1.5f);
    ViewSet around = room().train;  // the same with an outlier camera far away
    around.views[0].world_from_camera.translation = {1000, 0, 0};
    EXPECT_LT(splat::scene_extent(around).radius_m, 5.f);
}

TEST(SplatGrow, NewSplatsGrowWhereTheErrorIsUpToTheCap) {
    Splats s = initial_splats(room().train.points, 100, fastscene::Run{});
    splat::Cloud cloud(s, true, 103);
    cloud.seen_error[7] = 1, cloud.seen_error[8] = 1;
    EXPECT_EQ(splat::grow(cloud, 1, 1, 1), 1);
    EXPECT_EQ(cloud.count, 101);
    EXPECT_LT(
        std::min(length(cloud.splats().mean_m[100] - s.mean_m[7]), length(cloud.splats().mean_m[100] - s.mean_m[8])),
        0.5f);
    EXPECT_LE(splat::grow(cloud, 50, 1, 2), 2);
    EXPECT_LE(cloud.count, 103);
}

}  // namespace
}  // namespace fastscene
