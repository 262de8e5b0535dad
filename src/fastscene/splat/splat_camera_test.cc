// Beyond 14 parameters and a pinhole: higher SH degrees, the equirectangular camera, antialiasing. Gradients are tested
// against Jet, kernels against the reference.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "fastscene/geometry/sphere.h"
#include "fastscene/splat/jet.h"
#include "fastscene/splat/splat.h"
#include "fastscene/splat/test_scene.h"

namespace fastscene::splat {
namespace {

struct Case {
    const char* name;
    CameraModel model;
    bool antialias;
    int degree;
    float low_pass_px2 = FootprintFilter{}.low_pass_px2;
    FootprintFilter filter() const { return {low_pass_px2, antialias}; }
};
std::ostream& operator<<(std::ostream& o, const Case& c) { return o << c.name; }

// All around the camera for the sphere, some across the seam; in front of it for the pinhole.
Splats splats_of(const Case& c, int count, std::uint64_t seed) {
    Splats s = random_splats(count, seed);
    s.sh_degree = c.degree, s.filter = c.filter();
    s.resize(s.size());
    Random r(seed, "test.rest");
    for (float& x : s.sh_rest) x = r.uniform(-0.4f, 0.4f);
    if (c.model == CameraModel::equirectangular)
        for (std::size_t i = 0; i < s.size(); ++i) {
            const float lon = i % 4 == 0 ? 3.14f + r.uniform(-0.1f, 0.1f) : r.uniform(-3.f, 3.f),
                        lat = r.uniform(-1.2f, 1.2f), range = r.uniform(1.f, 4.f);
            s.mean_m[i] = Vec3f{std::cos(lat) * std::sin(lon), -std::sin(lat), std::cos(lat) * std::cos(lon)} * range;
        }
    return s;
}
Pinhole camera_of(const Case& c, int width) {
    return c.model == CameraModel::pinhole ? test_camera(width, width * 3 / 4) : Pinhole{width, width / 2, 0, 0, 0, 0};
}
Lens<float> lens_of_case(const Case& c, const Pinhole& camera) {
    return lens_of(camera, test_pose(), c.model, c.filter());
}

class SplatCamera : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(All, SplatCamera,
                         ::testing::Values(Case{"bands", CameraModel::pinhole, false, 3},
                                           Case{"bands1", CameraModel::pinhole, false, 1},
                                           Case{"antialias", CameraModel::pinhole, true, 0},
                                           Case{"sharp", CameraModel::pinhole, false, 1, kLeastLowPassPx2},
                                           Case{"sphere", CameraModel::equirectangular, false, 0},
                                           Case{"everything", CameraModel::equirectangular, true, 2}),
                         [](const auto& i) { return std::string(i.param.name); });

TEST_P(SplatCamera, GradientIsTheSlopeOfTheJet) {
    const Case c = GetParam();
    const Pinhole camera = camera_of(c, 32);
    const Splats s = splats_of(c, 12, 8);
    const auto lens = lens_over<double>(lens_of_case(c, camera));
    const auto jet_lens = lens_over<Jet>(lens_of_case(c, camera));
    const auto v = random_color_gradient(camera, 2);
    const Vec3d background{0.2, 0.4, 0.6};
    const auto picture = render_reference(gaussians_of<double>(s), lens, camera.width, camera.height, background,
                                          rest_of<double>(s));
    std::vector<double> rest_gradient;
    auto gradient = gradients_reference(gaussians_of<double>(s), lens, picture, v, rest_of<double>(s), &rest_gradient);
    auto jets = gaussians_of<Jet>(s);
    auto rest = rest_of<Jet>(s);
    const auto slope = [&] {
        const auto moved = render_reference(jets, jet_lens, camera.width, camera.height, Vec3<Jet>{0.2, 0.4, 0.6},
                                            rest);
        double sum = 0;
        for (std::size_t k = 0; k < v.size(); ++k)
            for (std::size_t i = 0; i < 3; ++i) sum += v[k][i] * moved.pixels[k].color[i].slope;
        return sum;
    };
    for (int p = 0; p < kParameters; ++p) {
        Distance distance;
        for (std::size_t i = 0; i < jets.size(); ++i) {
            parameter(jets[i], p).slope = 1;
            distance.add(parameter(gradient[i], p), slope());
            parameter(jets[i], p).slope = 0;
        }
        EXPECT_GT(distance.size2, 0) << p;
        EXPECT_LT(distance.relative(), 1e-5) << p;
    }
    if (c.degree == 0) return;
    Distance distance;
    for (std::size_t i = 0; i < rest.values.size(); i += 7) {
        rest.values[i].slope = 1;
        distance.add(rest_gradient[i], slope());
        rest.values[i].slope = 0;
    }
    EXPECT_GT(distance.size2, 0);
    EXPECT_LT(distance.relative(), 1e-9);
}

TEST_P(SplatCamera, KernelsAreTheReference) {
    const Case c = GetParam();
    const Pinhole camera = camera_of(c, 96);
    const Splats s = splats_of(c, 150, 5);
    const auto lens = lens_over<double>(lens_of_case(c, camera));
    const Vec3d background{0.2f, 0.4f, 0.6f};
    const auto ruler = render_reference(gaussians_of<double>(s), lens, camera.width, camera.height, background,
                                        rest_of<double>(s));
    const auto v = random_color_gradient(camera, 3);
    std::vector<double> rest_ruler;
    auto gradient = gradients_reference(gaussians_of<double>(s), lens, ruler, v, rest_of<double>(s), &rest_ruler);
    std::vector<Vec3f> vf;
    for (const Vec3d& x : v) vf.push_back({static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z)});
    for (const char* name : {"avx512", "avx2", "baseline"}) {
        const Kernel* kernel = nullptr;
        try {
            kernel = &choose_kernel(name);
        } catch (const UsageError&) {
            continue;
        }
        Cloud cloud(s, true);
        Engine engine(*kernel);
        engine.render(cloud, camera, test_pose(), {0.2f, 0.4f, 0.6f}, false, c.model);
        Distance color;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x)
                for (std::size_t i = 0; i < 3; ++i)
                    color.add(engine.color(x, y)[i],
                              ruler.pixels[static_cast<std::size_t>(y * camera.width + x)].color[i]);
        EXPECT_LT(color.relative(), 2e-4) << name;
        engine.set_color_gradient(vf);
        AlignedFloats rest;
        const AlignedFloats mine = engine.gradients(cloud, &rest);
        for (int p = 0; p < kParameters; ++p) {
            Distance distance;
            for (std::int64_t i = 0; i < cloud.count; ++i)
                distance.add(mine[cloud.at(i, p)], parameter(gradient[static_cast<std::size_t>(i)], p));
            EXPECT_LT(distance.relative(), 6e-4) << name << ' ' << p;  // kernels differ from each other by up to 6e-5
        }
        Distance distance;
        const int n = 3 * rest_functions(c.degree);
        for (std::int64_t i = 0; i < cloud.count; ++i)
            for (int k = 0; k < n; ++k)
                distance.add(rest[cloud.rest_at(i, k)], rest_ruler[static_cast<std::size_t>(i * n + k)]);
        if (n > 0) {
            EXPECT_LT(distance.relative(), 2e-4) << name;
        }
    }
}

// A small round splat appears where geometry/sphere.h says, and its two halves meet at the seam.
TEST(SplatSphere, SplatsLandWhereTheSphereSays) {
    const EquirectSize size{128, 64};
    for (const Vec3f p : {Vec3f{0, 0, 2}, Vec3f{1, -0.5f, 1.5f}, Vec3f{-0.3f, 1.f, -2.f}, Vec3f{0.001f, 0, -2}}) {
        Splats s;
        s.resize(1);
        s.mean_m[0] = p;
        s.log_scale[0] = Vec3f{1, 1, 1} * std::log(0.1f);
        s.opacity_logit[0] = 4;
        s.sh0[0] = {1, 1, 1};
        const SplatPicture picture = render_splats(s, {size.width, size.height, 0, 0, 0, 0}, {}, {},
                                                   CameraModel::equirectangular);
        const Vec2f at = pixel_of_direction(p, size);
        // Mean alpha around the splat's position at the seam.
        double sum = 0, x_sum = 0, y_sum = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const double a = picture.alpha.at(x, y);
                double dx = x + 0.5 - at.x;
                dx -= size.width * std::round(dx / size.width);
                sum += a, x_sum += a * dx, y_sum += a * (y + 0.5 - at.y);
            }
        EXPECT_GT(sum, 5);
        EXPECT_NEAR(x_sum / sum, 0, 0.02);
        EXPECT_NEAR(y_sum / sum, 0, 0.02);
    }
}

// With growing distance, a splat smaller than a pixel fades in proportion to its area.
TEST(SplatAntialias, FarSplatsFade) {
    Splats s;
    s.resize(1);
    s.log_scale[0] = Vec3f{1, 1, 1} * std::log(0.02f);
    s.opacity_logit[0] = 3;
    s.sh0[0] = {1, 1, 1};
    const Pinhole camera{33, 33, 30, 30, 16.5f, 16.5f};
    const auto light = [&](float z, bool antialias) {
        s.mean_m[0] = {0, 0, z};
        s.filter.antialias = antialias;
        const SplatPicture picture = render_splats(s, camera, {});
        return std::accumulate(picture.alpha.pixels.begin(), picture.alpha.pixels.end(), 0.0);
    };
    EXPECT_NEAR(light(2, true) / light(4, true), 4, 0.8);
    EXPECT_LT(light(2, false) / light(4, false), 1.6);
}

}  // namespace
}  // namespace fastscene::splat
