#include "fastscene/pipeline/earlier_splats.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/pipeline/run_files.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr EquirectSize kSize{64, 32};
constexpr float kWall_m = 2;

// A run whose only panorama shows a gray sphere, with the left half of `color`.
void write_run(const RunFolder& run, Rgb8 color) {
    make_directories(run.walk() / "000");
    make_directories(run.stage("panorama"));
    ImageRgb8 picture(kSize.width, kSize.height, {128, 128, 128});
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width / 2; ++x) picture.at(x, y) = color;
    save_png(run.walk() / "000" / "color.png", picture);
    save_exr(run.walk() / "000" / "range.exr", ImageF(kSize.width, kSize.height, kWall_m));
    save_viewpoints(run.walk() / "poses.json", {{"000", {}}});
    write_json(run.stage("panorama") / kAboutName, {{"kept_pixels", 0.5}});
}

// Of what a viewpoint sees change, and of what stands before it, no splat is kept; what is hidden behind it stays.
TEST(EarlierSplats, LeaveNoTraceOfWhatChanged) {
    const fs::path root = fs::temp_directory_path() / ("fastscene-earlier-splats-" + std::to_string(::getpid()));
    const RunFolder before{root / "before"}, now{root / "now"};
    write_run(before, {200, 30, 30});
    write_run(now, {128, 128, 128});
    const Vec3f left = direction_of_pixel(16, 16, kSize), right = direction_of_pixel(48, 16, kSize);
    Splats splats;
    splats.mean_m = {left * kWall_m, left * 1.f, left * 3.f, right * kWall_m, right * 1.f};
    splats.resize(splats.mean_m.size());
    for (std::size_t i = 0; i < splats.size(); ++i) splats.opacity_logit[i] = 2, splats.rotation[i] = {1, 0, 0, 0};
    make_directories(before.scene_ply().parent_path());
    save_splat_ply(before.scene_ply(), splats);
    SurfacePoint point;
    point.position_m = left * kWall_m;
    point.color = {128, 128, 128};
    point.radius_m = 0.05f;

    const auto kept = earlier_splats({before, nullptr, {}}, now, {point}, {}, fastscene::Run{});
    ASSERT_TRUE(kept.has_value());
    const auto has = [&](Vec3f place, float logit) {
        for (std::size_t i = 0; i < kept->size(); ++i)
            if (length(kept->mean_m[i] - place) < 1e-4f && kept->opacity_logit[i] == logit) return true;
        return false;
    };
    EXPECT_FALSE(has(left * kWall_m, 2)) << "was red";
    EXPECT_FALSE(has(left * 1.f, 2)) << "stood before it";
    EXPECT_TRUE(has(left * 3.f, 2) && has(right * kWall_m, 2) && has(right * 1.f, 2));
    EXPECT_EQ(kept->size(), 4u) << "and one at the new point";
    fs::remove_all(root);
}

}  // namespace
}  // namespace fastscene
