#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "fastscene/base/random.h"
#include "fastscene/image/ssim.h"
#include "fastscene/metrics/metrics.h"
#include "fastscene/scene/box.h"
#include "fastscene/trace/test_room.h"

namespace fastscene {
namespace {

// A box; `inward`: seen from inside, as a room; else a solid.
Mesh box(Vec3f low, Vec3f high, bool inward, int material, int object = -1) {
    return box_mesh(low, high, material, object, inward);
}

// A 4 x 2.6 x 5 m room with dim emission, and a box half a metre wide, one metre ahead.
Room box_room() {
    Room room;
    room.min_corner = {-2, -1.1f, -2.5f};
    room.max_corner = {2, 1.5f, 2.5f};
    Material wall;
    wall.color_a = {0.5f, 0.4f, 0.3f};
    wall.emission = {0.3f, 0.3f, 0.3f};
    room.materials = {wall, Material{}};
    room.meshes = {box(room.min_corner, room.max_corner, true, 0),
                   box({-0.25f, -0.25f, 1.f}, {0.25f, 0.25f, 1.5f}, false, 1)};
    room.look.automatic = false;
    return room;
}

TEST(TruthPoses, StayInTheBallAndClearOfThings) {
    const TracedRoom room(box_room());
    TruthParams params;
    params.where = "near";
    params.radius_m = 1.2f;
    params.views = 50;
    const std::vector<TruthPose> poses = truth_poses(room, params, 7);
    ASSERT_EQ(poses.size(), 50u);
    for (const TruthPose& pose : poses) {
        const Vec3f p = pose.world_from_camera.translation;
        EXPECT_LE(length(p), 1.2f);
        EXPECT_GE(room.clearance(p, 0.15f), 0.149f);
        EXPECT_LT(std::abs((pose.world_from_camera.rotation * Vec3f{1, 0, 0}).y), 1e-5f) << "no roll";
        EXPECT_LE(std::abs((pose.world_from_camera.rotation * Vec3f{0, 0, 1}).y), 0.5001f) << "pitch within 30 degrees";
    }
    EXPECT_EQ(truth_poses(room, params, 7)[49].world_from_camera, poses[49].world_from_camera);
    EXPECT_NE(truth_poses(room, params, 8)[49].world_from_camera, poses[49].world_from_camera);
}

TEST(TruthPoses, StandAllOverTheRoomAtTheHeightOfEyes) {
    Room box = box_room();
    const float floor = box.max_corner.y;
    box.meshes[1] = fastscene::box_mesh({-0.4f, -0.2f, 0.6f}, {0.4f, floor, 1.6f}, 1, -1,
                                        false);  // a cupboard, too high for some visitors to look over
    const TracedRoom room(std::move(box));
    TruthParams params;
    params.views = 200;
    const std::vector<TruthPose> poses = truth_poses(room, params, 3);
    ASSERT_EQ(poses.size(), 200u);
    int behind = 0;
    for (const TruthPose& pose : poses) {
        const Vec3f p = pose.world_from_camera.translation;
        EXPECT_GE(floor - p.y, 1.2f);
        EXPECT_LE(floor - p.y, 1.8f);
        EXPECT_GE(room.clearance(p, 0.25f), 0.249f);
        // Nobody stands inside the cupboard or too close to a wall.
        EXPECT_FALSE(std::abs(p.x) < 0.55f && p.z > 0.45f && p.z < 1.75f);
        EXPECT_LT(std::abs(p.x), 1.76f);
        behind += p.z > 1.7f;
    }
    EXPECT_GT(behind, 20) << "walked around the cupboard";
}

TEST(TruthPoses, StandOnTiersToo) {
    Room room = box_room();
    room.meshes.pop_back();
    raise_floor(room, {-2, 0.5f}, {2, 2.5f}, 0.36f);
    raise_floor(room, {-1, 0}, {1, 0.5f}, 0.18f, kTierStep);
    const TracedRoom traced(std::move(room));
    TruthParams params;
    params.views = 60;
    int above = 0;
    for (const TruthPose& pose : truth_poses(traced, params, 3)) {
        const Vec3f p = pose.world_from_camera.translation;
        constexpr float kStep = 0.2f;  // poses are spread over a cell, which may lie across an edge
        const float height = floor_at(traced.room(), {p.x, p.z}) - p.y;
        EXPECT_TRUE(height > 1.2f - kStep && height < 1.8f + kStep) << height;
        above += p.z > 0.6f;
    }
    EXPECT_GT(above, 10);
}

TEST(TruthPoses, NoSpaceIsAnError) {
    Room room = box_room();
    room.meshes.push_back(box({-0.1f, -0.1f, -0.1f}, {0.1f, 0.1f, 0.1f}, true, 1));
    TruthParams params;
    params.views = 1;
    params.where = "near";
    EXPECT_THROW(truth_poses(TracedRoom(room), params, 1), Error);
    // Beds from wall to wall: one can look around above them but not stand.
    Room beds = box_room();
    beds.meshes.push_back(fastscene::box_mesh({-2, 1.f, -2.5f}, {2, 1.5f, 2.5f}, 1, -1, false));
    params.where = "room";
    EXPECT_THROW(truth_poses(TracedRoom(beds), params, 1), Error);
}

TEST(TruthPicture, UnseenIsWhatTheBoxHidesFromTheOrigin) {
    TracedRoom room(box_room());
    TraceParams trace;
    trace.cell_m = 0.2f;
    trace.cell_samples = 16;
    trace.outside_detail = 0;
    trace.pixel_samples = 1;
    const fastscene::Run run;
    room.gather_light(trace, run);
    // From the origin nothing is unseen.
    const TruthPicture here = truth_picture(room, {}, 256, run);
    EXPECT_EQ(std::count(here.unseen.pixels.begin(), here.unseen.pixels.end(), 255), 0);
    // From half a metre to the right, parts of the far wall behind the box, and the box's right side, are unseen.
    TruthPose pose;
    pose.world_from_camera.translation = {0.5f, 0, 0};
    const TruthPicture there = truth_picture(room, pose, 256, run);
    const auto unseen = std::count(there.unseen.pixels.begin(), there.unseen.pixels.end(), 255);
    EXPECT_GT(unseen, 500);
    EXPECT_LT(unseen, 15000);
    EXPECT_LT(std::count_if(there.color.pixels.begin(), there.color.pixels.end(),
                            [&, i = std::size_t{0}](const Rgb8& p) mutable { return p == there.again.pixels[i++]; }),
              static_cast<std::ptrdiff_t>(there.color.size()))
        << "the second picture has other rays";
}

// The estimator's key property: noise in the truth does not count, errors of the picture count in full.
TEST(Likeness, IsFreeOfTheTruthsNoise) {
    constexpr int kSize = 256, kError = 6, kNoise = 20;
    Random random(5, "noise");
    const ImageRgb8 picture(kSize, kSize, Rgb8{100 + kError, 100 + kError, 100 + kError});
    TruthPicture truth{ImageRgb8(kSize, kSize), ImageRgb8(kSize, kSize), ImageMask(kSize, kSize)};
    for (ImageRgb8* noisy : {&truth.color, &truth.again})
        for (Rgb8& p : noisy->pixels) {
            const auto level = static_cast<std::uint8_t>(100 - kNoise + random.index(2 * kNoise + 1));
            p = {level, level, level};
        }
    const double exact = 20 * std::log10(255. / kError);
    EXPECT_NEAR(compare(picture, truth).psnr, exact, 0.3);
    EXPECT_LT(psnr(picture, truth.color), exact - 5);
    truth.again = {};
    const Likeness plain = compare(picture, truth);
    EXPECT_NEAR(plain.psnr, psnr(picture, truth.color), 1e-9) << "without a second picture: plain PSNR";
    EXPECT_NEAR(plain.ssim, ssim(picture, truth.color), 1e-9) << "and plain SSIM";
}

// Blurred stripes against sharp ones: SSIM is that of the noise-free truth, whatever noise its two renderings have.
TEST(Likeness, SsimIsFreeOfTheTruthsNoise) {
    constexpr int kSize = 256, kNoise = 12;
    Random random(5, "noise");
    const auto stripes = [](double contrast) {
        ImageRgb8 out(kSize, kSize);
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const auto level = static_cast<std::uint8_t>(std::lround(120 + contrast * std::sin(0.8 * x + 0.2 * y)));
                out.at(x, y) = {level, level, level};
            }
        return out;
    };
    const ImageRgb8 picture = stripes(15), sharp = stripes(30);
    TruthPicture truth{sharp, sharp, ImageMask(kSize, kSize)};
    for (ImageRgb8* noisy : {&truth.color, &truth.again})
        for (Rgb8& p : noisy->pixels) {
            const auto level = static_cast<std::uint8_t>(p.r - kNoise + random.index(2 * kNoise + 1));
            p = {level, level, level};
        }
    const double exact = ssim(picture, sharp);
    EXPECT_NEAR(compare(picture, truth).ssim, exact, 0.01);
    EXPECT_LT(ssim(picture, truth.color), exact - 0.03);
}

TEST(TruthSet, ComesBackFromDiskAsItWas) {
    TruthSet set{{{}, {{rotation_about(Vec3f{0, 1, 0}, 0.7f), {0.1f, -0.2f, 1.f / 3}}}}, {}, 41.25};
    Random random(3, "truth set");
    for (int k = 0; k < 2; ++k) {
        TruthPicture picture{ImageRgb8(20, 20), ImageRgb8(20, 20), ImageMask(20, 20)};
        for (Rgb8& p : picture.color.pixels) p.r = static_cast<std::uint8_t>(random.index(256));
        for (Rgb8& p : picture.again.pixels) p.g = static_cast<std::uint8_t>(random.index(256));
        for (std::uint8_t& v : picture.unseen.pixels) v = random.index(2) ? 255 : 0;
        set.pictures.push_back(picture);
    }
    const std::filesystem::path dir = std::filesystem::path(testing::TempDir()) / "truth-set";
    save_truth_set(dir, set);
    const TruthSet back = load_truth_set(dir);
    ASSERT_EQ(back.poses.size(), 2u);
    EXPECT_EQ(back.poses[1].world_from_camera, set.poses[1].world_from_camera);
    EXPECT_EQ(back.pictures[1].color.pixels, set.pictures[1].color.pixels);
    EXPECT_EQ(back.pictures[1].again.pixels, set.pictures[1].again.pixels);
    EXPECT_EQ(back.pictures[1].unseen.pixels, set.pictures[1].unseen.pixels);
    EXPECT_DOUBLE_EQ(back.floor_db, set.floor_db);
    std::filesystem::remove(dir / "01.png");
    EXPECT_THROW(load_truth_set(dir), Error);
    std::filesystem::remove_all(dir);
}

TEST(SideBySide, ShowsAllAndTheDifference) {
    const ImageRgb8 a(4, 3, Rgb8{10, 20, 30}), b(4, 3, Rgb8{20, 20, 30});
    const ImageRgb8 row = side_by_side({a, b});
    EXPECT_EQ(row.width, 12);
    EXPECT_EQ(row.at(8, 1), (Rgb8{40, 0, 0}));
}

}  // namespace
}  // namespace fastscene
