// The depth regularizer: gradients against Jet, kernels against the reference, and its effect on training.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/textured_room.h"
#include "fastscene/base/error.h"
#include "fastscene/splat/depth_target.h"
#include "fastscene/splat/jet.h"
#include "fastscene/splat/splat.h"
#include "fastscene/splat/test_scene.h"

namespace fastscene::splat {
namespace {

constexpr double kStrength = 0.7;

class SplatDepth : public ::testing::TestWithParam<CameraModel> {
  protected:
    SplatDepth()
        : camera_(GetParam() == CameraModel::pinhole ? test_camera(48, 36) : Pinhole{64, 32, 0, 0, 0, 0}),
          view_(noise_view(camera_, test_pose(), 3, true)),
          target_(camera_.width, camera_.height) {
        view_.model = GetParam();
        Random random(4, "test.depth");
        for (float& d : target_.pixels) d = random.uniform() < 0.2f ? 0.f : random.uniform(0.5f, 5.f);
    }
    Pinhole camera_;
    View view_;
    ImageF target_;
    Splats splats_ = random_splats(60, 8);
    Lens<float> lens_ = lens_of(camera_, test_pose(), GetParam());
};
INSTANTIATE_TEST_SUITE_P(All, SplatDepth, ::testing::Values(CameraModel::pinhole, CameraModel::equirectangular),
                         [](const auto& i) { return i.param == CameraModel::pinhole ? "pinhole" : "sphere"; });

TEST_P(SplatDepth, GradientIsTheSlopeOfTheJet) {
    const auto g = gaussians_of<double>(splats_);
    auto picture = render_reference(g, lens_over<double>(lens_), camera_.width, camera_.height, Vec3d{});
    std::vector<double> v_depth;
    EXPECT_GT(depth_loss_reference(picture, view_, target_, kStrength, v_depth), 0);
    std::vector<double> no_bands;
    auto gradient = gradients_reference(g, lens_over<double>(lens_), picture, std::vector<Vec3d>(v_depth.size()), {},
                                        &no_bands, v_depth);
    auto jets = gaussians_of<Jet>(splats_);
    for (int p = 0; p < kParameters - 3; ++p) {  // color does not affect depth
        Distance distance;
        for (std::size_t i = 0; i < jets.size(); i += 4) {
            parameter(jets[i], p).slope = 1;
            const auto moved = render_reference(jets, lens_over<Jet>(lens_), camera_.width, camera_.height,
                                                Vec3<Jet>{});
            parameter(jets[i], p).slope = 0;
            double slope = 0;
            for (std::size_t k = 0; k < v_depth.size(); ++k)
                slope += v_depth[k] * (moved.depth_sum[k].slope +
                                       moved.pixels[k].transmittance.slope * static_cast<double>(target_.pixels[k]));
            distance.add(parameter(gradient[i], p), slope);
        }
        EXPECT_GT(distance.size2, 0) << p;
        EXPECT_LT(distance.relative(), 1e-5) << p;
    }
}

// The transmittance loss: gradient of every parameter against forward differentiation through the renderer.
TEST_P(SplatDepth, TransmittanceHasTheGradientOfItsJets) {
    const auto g = gaussians_of<double>(splats_);
    const auto picture = render_reference(g, lens_over<double>(lens_), camera_.width, camera_.height, Vec3d{});
    std::vector<double> v, no_bands;
    EXPECT_GT(transmittance_loss_reference(picture, view_, kStrength, v), 0);
    auto gradient = gradients_reference(g, lens_over<double>(lens_), picture, std::vector<Vec3d>(v.size()), {},
                                        &no_bands, {}, v);
    auto jets = gaussians_of<Jet>(splats_);
    for (int p = 0; p < kParameters - 3; ++p) {  // color does not affect transmittance
        Distance distance;
        for (std::size_t i = 0; i < jets.size(); i += 4) {
            parameter(jets[i], p).slope = 1;
            const auto moved = render_reference(jets, lens_over<Jet>(lens_), camera_.width, camera_.height,
                                                Vec3<Jet>{});
            parameter(jets[i], p).slope = 0;
            double slope = 0;
            for (std::size_t k = 0; k < v.size(); ++k) slope += v[k] * moved.pixels[k].transmittance.slope;
            distance.add(parameter(gradient[i], p), slope);
        }
        EXPECT_GT(distance.size2, 0) << p;
        EXPECT_LT(distance.relative(), 1e-5) << p;
    }
}

// Color, depth and transmittance together, as in a training step.
TEST_P(SplatDepth, KernelsAreTheReference) {
    const auto g = gaussians_of<double>(splats_);
    const auto lens = lens_over<double>(lens_);
    auto picture = render_reference(g, lens, camera_.width, camera_.height, Vec3d{});
    std::vector<Vec3d> colors;
    for (const auto& p : picture.pixels) colors.push_back(p.color);
    const ReferenceLoss color_loss = loss_reference(colors, view_, 0.2);
    std::vector<double> v_depth;
    const double loss = depth_loss_reference(picture, view_, target_, kStrength, v_depth);
    std::vector<double> v_transmittance;
    const double open_loss = transmittance_loss_reference(picture, view_, kStrength, v_transmittance);
    std::vector<double> no_bands;
    auto ruler = gradients_reference(g, lens, picture, color_loss.v, {}, &no_bands, v_depth, v_transmittance);
    for (const char* name : {"avx512", "avx2", "baseline"}) {
        const Kernel* kernel = nullptr;
        try {
            kernel = &choose_kernel(name);
        } catch (const UsageError&) {
            continue;
        }
        Cloud cloud(splats_, true);
        Engine engine(*kernel);
        engine.render(cloud, camera_, test_pose(), {}, true, GetParam());
        engine.differentiate(view_, 0.2f);
        EXPECT_NEAR(engine.differentiate_depth(view_, target_, static_cast<float>(kStrength)), loss, 1e-5 * loss)
            << name;
        EXPECT_NEAR(engine.differentiate_transmittance(view_, static_cast<float>(kStrength)), open_loss,
                    1e-5 * open_loss)
            << name;
        const AlignedFloats mine = engine.gradients(cloud);
        for (int p = 0; p < kParameters; ++p) {
            Distance distance;
            for (std::int64_t i = 0; i < cloud.count; ++i)
                distance.add(mine[cloud.at(i, p)], parameter(ruler[static_cast<std::size_t>(i)], p));
            EXPECT_LT(distance.relative(), 5e-4) << name << ' ' << p;
        }
    }
}

// Where pictures constrain depth only weakly, the regularizer keeps splats near the starting points.
TEST(SplatDepthTraining, DepthStaysNearerToThePoints) {
    ViewSet set = bench::room_set(48, 2, 3000, 0, 1).train;
    const auto error = [&](float strength) {
        SplatParams params;
        params.count = 3000, params.steps = 200, params.depth = strength;
        const Splats splats = fit_splats(set, params, fastscene::Run{}).splats;
        DepthTarget target(set, params.count, fastscene::Run{});
        double sum = 0, n = 0;
        for (const View& view : set.views) {
            const SplatPicture shown = render_splats(splats, view.camera, view.world_from_camera);
            const ImageF& depth = target.of(view);
            for (std::size_t i = 0; i < depth.size(); ++i)
                if (depth.pixels[i] > 0) sum += std::fabs(shown.depth_z.pixels[i] / depth.pixels[i] - 1), n += 1;
        }
        EXPECT_GT(n, 0.25 * 48 * 48 * static_cast<double>(set.views.size()));
        return sum / n;
    };
    EXPECT_LT(error(1), 0.8 * error(0));
}

}  // namespace
}  // namespace fastscene::splat
