// What every backend of splats must do, whichever there are (splat_backends/).
#include <gtest/gtest.h>

#include "fastscene/gpu/device.h"
#include "fastscene/splat/backend.h"
#include "fastscene/splat/test_scene.h"

namespace fastscene::splat {
namespace {

std::string device_of(const SplatBackendEntry&) { return gpu::has_card() ? "auto" : "llvmpipe"; }

class SplatBackends : public ::testing::TestWithParam<SplatBackendEntry> {};
INSTANTIATE_TEST_SUITE_P(All, SplatBackends, ::testing::ValuesIn(registered<SplatBackendEntry>()),
                         [](const auto& i) { return i.param.name; });

TEST_P(SplatBackends, IsListed) {
    const auto names = splat_backend_names();
    EXPECT_NE(std::find(names.begin(), names.end(), GetParam().name), names.end());
    EXPECT_NE(about_splat_backends().find(GetParam().name + ": " + GetParam().about), std::string::npos);
}

TEST_P(SplatBackends, RendersTheReferencesPictures) {
    const Splats s = random_splats(200, 4);
    const Pinhole camera = test_camera(64, 48);
    const auto picture = SplatRenderer(s, {GetParam().name, device_of(GetParam())}).picture(camera, test_pose()),
               truth = SplatRenderer(s, {"reference"}).picture(camera, test_pose());
    Distance color, depth;
    for (std::size_t i = 0; i < truth.color.pixels.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) color.add(picture.color.pixels[i][k], truth.color.pixels[i][k]);
        depth.add(picture.depth_z.pixels[i], truth.depth_z.pixels[i]);
    }
    EXPECT_LT(color.relative(), 1e-3);
    EXPECT_LT(depth.relative(), 1e-2);
}

// Views may change between steps, the splats too; losses come in the order of the steps.
TEST_P(SplatBackends, TrainsLikeTheReference) {
    const Splats start = random_splats(80, 7);
    const View a = noise_view(test_camera(80, 64), test_pose(), 5, false),
               b = noise_view(test_camera(48, 32), test_pose(), 6, true);
    const auto run = [&](const SplatBackend& backend) {
        const auto stepper = make_stepper(backend);
        Cloud cloud(start, true);
        std::vector<LossSums> losses;
        StepPlan plan;
        plan.rates.rates.fill(1e-3f);
        stepper->load(cloud);
        for (int step = 1; step <= 6; ++step) {
            if (step == 1) stepper->set_views({&a, &b}, {});
            if (step == 4) stepper->set_views({&b}, {});
            if (step == 5) {
                stepper->store(cloud);
                cloud.parameters[cloud.at(3, kLogit)] += 1;
                stepper->load(cloud);
            }
            plan.rates.adam_step = step;
            stepper->step(cloud, step < 4 ? static_cast<std::size_t>(step % 2) : 0, plan);
        }
        stepper->store(cloud);
        EXPECT_FALSE(stepper->device().empty());
        return std::pair(stepper->losses(), cloud.splats());
    };
    const auto mine = run({GetParam().name, device_of(GetParam())}), truth = run({"reference"});
    ASSERT_EQ(mine.first.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(mine.first[i].loss, truth.first[i].loss, 1e-4) << i;
    Distance moved;
    for (std::size_t i = 0; i < start.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            moved.add(mine.second.mean_m[i][k] - start.mean_m[i][k], truth.second.mean_m[i][k] - start.mean_m[i][k]);
    EXPECT_LT(moved.relative(), 0.05);  // Adam's steps are signs where gradients are small
}

TEST(SplatBackend, UnknownOnesAreNamedWithThoseThatThereAre) {
    try {
        make_stepper({"cuda"});
        ADD_FAILURE();
    } catch (const UsageError& e) {
        EXPECT_STREQ(e.what(), "--splat-backend: expected cpu, reference or vulkan, found \"cuda\"");
    }
}

}  // namespace
}  // namespace fastscene::splat
