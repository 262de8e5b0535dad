// The hand-written gradients against central differences and forward differentiation (Jet).
#include <gtest/gtest.h>

#include "fastscene/splat/jet.h"
#include "fastscene/splat/splat.h"
#include "fastscene/splat/test_scene.h"

namespace fastscene::splat {
namespace {

const char* const kKinds[] = {"mean",     "mean",     "mean",     "scale",   "scale", "scale", "rotation",
                              "rotation", "rotation", "rotation", "opacity", "color", "color", "color"};

double objective(const std::vector<Gaussian<double>>& g, const Lens<double>& lens, const Pinhole& camera,
                 const std::vector<Vec3d>& v) {
    const auto picture = render_reference(g, lens, camera.width, camera.height, Vec3d{0.2, 0.4, 0.6});
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += dot(v[i], picture.pixels[i].color);
    return sum;
}

TEST(SplatMath, GradientIsTheCentralDifferenceForEveryKindOfParameter) {
    const Pinhole camera = test_camera(40, 30);
    auto g = gaussians_of<double>(random_splats(30, 5));
    const auto lens = lens_over<double>(lens_of(camera, test_pose()));
    const auto v = random_color_gradient(camera, 1);
    const auto picture = render_reference(g, lens, camera.width, camera.height, Vec3d{0.2, 0.4, 0.6});
    auto gradient = gradients_reference(g, lens, picture, v);
    constexpr double kStep = 1e-6;
    for (int p = 0; p < kParameters; ++p) {
        Distance distance;
        for (std::size_t i = 0; i < g.size(); ++i) {
            double& x = parameter(g[i], p);
            const double before = x;
            x = before + kStep;
            const double up = objective(g, lens, camera, v);
            x = before - kStep;
            const double down = objective(g, lens, camera, v);
            x = before;
            // Where a pixel's alpha crosses a threshold within the step there is no derivative.
            const double slope = (up - down) / (2 * kStep), mine = parameter(gradient[i], p);
            if (std::abs(slope - mine) < 100 + std::abs(mine)) distance.add(mine, slope);
        }
        EXPECT_GT(distance.size2, 0) << kKinds[p];
        EXPECT_LT(distance.relative(), 1e-5) << kKinds[p] << ' ' << p;
    }
}

TEST(SplatMath, GradientIsTheSlopeOfTheJet) {
    const Pinhole camera = test_camera(24, 20);
    const auto g = gaussians_of<double>(random_splats(12, 8));
    const auto lens = lens_over<double>(lens_of(camera, test_pose()));
    const auto v = random_color_gradient(camera, 2);
    const auto picture = render_reference(g, lens, camera.width, camera.height, Vec3d{0.2, 0.4, 0.6});
    auto gradient = gradients_reference(g, lens, picture, v);
    const auto jet_lens = lens_over<Jet>(lens_of(camera, test_pose()));
    auto jets = gaussians_of<Jet>(random_splats(12, 8));
    for (int p = 0; p < kParameters; ++p) {
        Distance distance;
        for (std::size_t i = 0; i < g.size(); ++i) {
            parameter(jets[i], p).slope = 1;
            const auto moved = render_reference(jets, jet_lens, camera.width, camera.height, Vec3<Jet>{0.2, 0.4, 0.6});
            parameter(jets[i], p).slope = 0;
            double slope = 0;
            for (std::size_t k = 0; k < v.size(); ++k)
                for (std::size_t c = 0; c < 3; ++c) slope += v[k][c] * moved.pixels[k].color[c].slope;
            distance.add(parameter(gradient[i], p), slope);
        }
        EXPECT_GT(distance.size2, 0) << kKinds[p];
        EXPECT_LT(distance.relative(), 1e-10) << kKinds[p] << ' ' << p;
    }
}

TEST(SplatMath, LossGradientIsTheCentralDifference) {
    const Pinhole camera = test_camera(19, 17);
    const View view = noise_view(camera, {}, 4, true);
    std::vector<Vec3d> picture;
    Random r(6, "test.picture");
    for (std::size_t i = 0; i < view.color.size(); ++i) picture.push_back({r.uniform(), r.uniform(), r.uniform()});
    const ReferenceLoss at = loss_reference(picture, view, 0.2);
    Distance distance;
    constexpr double kStep = 1e-6;
    for (std::size_t i = 0; i < picture.size(); i += 3)
        for (std::size_t c = 0; c < 3; ++c) {
            auto moved = picture;
            moved[i][c] += kStep;
            const double up = loss_reference(moved, view, 0.2).loss;
            moved[i][c] -= 2 * kStep;
            distance.add(at.v[i][c], (up - loss_reference(moved, view, 0.2).loss) / (2 * kStep));
        }
    EXPECT_LT(distance.relative(), 1e-6);
}

TEST(SplatMath, LossOfThePictureItselfIsNothing) {
    const Pinhole camera = test_camera(23, 21);
    const View view = noise_view(camera, {}, 9, false);
    std::vector<Vec3d> picture;
    for (const Rgb8 p : view.color.pixels) picture.push_back({p.r / 255.0, p.g / 255.0, p.b / 255.0});
    EXPECT_NEAR(loss_reference(picture, view, 0.2).loss, 0, 1e-6);
    EXPECT_GT(loss_reference(std::vector<Vec3d>(picture.size(), {0.5, 0.5, 0.5}), view, 0.2).loss, 0.1);
}

// One isotropic Gaussian on the optical axis: screen variance = (f s / z)^2 + dilation, alpha = o exp(-r^2 / 2 var).
TEST(SplatMath, OneGaussianHasAClosedForm) {
    Splats s;
    s.resize(1);
    s.mean_m[0] = {0, 0, 2};
    s.log_scale[0] = Vec3f{1, 1, 1} * std::log(0.1f);
    s.rotation[0] = {0.3f, -0.5f, 0.7f, 0.1f};
    s.opacity_logit[0] = std::log(0.8f / 0.2f);
    s.sh0[0] = {1.f, 0.f, -0.5f};
    const Pinhole camera{41, 41, 30, 30, 20.5f, 20.5f};
    for (const char* backend : {"cpu", "reference"}) {
        const SplatPicture picture = render_splats({s, {backend}}, camera, {});
        const double variance = 1.5 * 1.5 + 0.3;
        for (int x = 0; x < 41; ++x) {
            const double d = x - 20, alpha = 0.8 * std::exp(-d * d / (2 * variance));
            const double shown = alpha < 1 / 255.0 ? 0 : alpha;
            EXPECT_NEAR(picture.alpha.at(x, 20), shown, 1e-5) << backend;
            EXPECT_NEAR(picture.color.at(x, 20).x, shown * (0.5 + 0.28209479), 1e-5) << backend;
            if (shown > 0) {
                EXPECT_NEAR(picture.depth_z.at(x, 20), 2, 1e-4) << backend;
            }
        }
    }
}

}  // namespace
}  // namespace fastscene::splat
