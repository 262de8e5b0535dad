#include "fastscene/scene/camera_path.h"

#include <gtest/gtest.h>

namespace fastscene {
namespace {

CameraPath two_keys(float yaw_a, float yaw_b) {
    CameraPath path;
    path.keys = {{0, {0, 0, 0}, yaw_a, 0}, {2, {1, 0, 0}, yaw_b, 10}};
    return path;
}

TEST(CameraPath, PassesThroughItsKeysAndStaysAtItsEnds) {
    CameraPath path = two_keys(0, 90);
    path.keys.push_back({3, {1, -1, 2}, 45, 0});
    for (const CameraKey& key : path.keys) {
        const CameraKey at = path.at(key.time_s);
        EXPECT_NEAR(length(at.position_m - key.position_m), 0, 1e-6);
        EXPECT_NEAR(at.yaw_deg, key.yaw_deg, 1e-4);
    }
    EXPECT_EQ(path.at(-1).position_m, path.keys.front().position_m);
    EXPECT_EQ(path.at(99).position_m, path.keys.back().position_m);
    EXPECT_EQ(path.frames(), 91);
}

TEST(CameraPath, TurnsTheShorterWay) {
    EXPECT_NEAR(two_keys(350, 10).at(1).yaw_deg, 360, 1e-3);
    EXPECT_NEAR(two_keys(-170, 170).at(1).yaw_deg, -180, 1e-3);
}

TEST(CameraPath, IsContinuous) {
    CameraPath path = two_keys(0, 90);
    path.keys.push_back({3, {1, -1, 2}, 200, 0});
    for (float t = 0; t < 3; t += 0.01f) {
        EXPECT_LT(length(path.at(t + 0.01f).position_m - path.at(t).position_m), 0.05f) << t;
        EXPECT_LT(std::abs(path.at(t + 0.01f).yaw_deg - path.at(t).yaw_deg), 3.f) << t;
    }
}

TEST(CameraPath, OneKeyIsOneFrame) {
    CameraPath path;
    path.keys = {{5, {1, 2, 3}, 7, 8}};
    EXPECT_EQ(path.frames(), 1);
    EXPECT_EQ(path.at(5).yaw_deg, 7);
}

TEST(CameraPath, PosesAndAnglesConvertBothWays) {
    for (const float yaw : {-170.f, -90.f, 0.f, 33.f, 179.f})
        for (const float pitch : {-80.f, 0.f, 45.f})
            for (const float roll : {-30.f, 0.f, 100.f}) {
                const CameraKey key = key_of_pose(2, world_from_camera_at({1, 2, 3}, yaw, pitch, roll));
                EXPECT_NEAR(key.yaw_deg, yaw, 1e-3);
                EXPECT_NEAR(key.pitch_deg, pitch, 1e-3);
                EXPECT_NEAR(key.roll_deg, roll, 1e-3);
            }
    const Rigid up = world_from_camera_at({}, 40, 90);
    const Rigid again = world_from_camera(key_of_pose(0, up));
    EXPECT_LT(length(again.rotation.row0 - up.rotation.row0), 1e-3);
    EXPECT_NEAR(vertical_fov_deg(horizontal_fov_deg(50, 1280, 720), 1280, 720), 50, 1e-4);
}

TEST(CameraPath, UnevenTimesMakeNoJumpOfSpeed) {
    CameraPath path;
    path.keys = {{0, {0, 0, 0}, 0, 0}, {1, {1, 0, 0}, 10, 0}, {1.2f, {1.3f, 0, 0}, 16, 0}, {4, {3, 0, 0}, 90, 0}};
    constexpr float kStep = 0.005f;
    Vec3f last = path.at(kStep).position_m - path.at(0).position_m;
    for (float t = kStep; t < 4 - kStep; t += kStep) {
        const Vec3f step = path.at(t + kStep).position_m - path.at(t).position_m;
        EXPECT_LT(length(step - last) / kStep, 0.2f) << t;
        last = step;
    }
}

// A pose a frame becomes few keys that give the same film.
TEST(CameraPath, FewerKeysKeepThePath) {
    CameraPath drawn{30, 75, 1280, 720, {{0, {}, 0, 0}, {2, {1, 0, 1}, 90, -10}, {4, {1, 0.2f, 3}, 200, 5}}};
    CameraPath dense = drawn;
    dense.keys.clear();
    for (int i = 0; i < drawn.frames(); ++i) dense.keys.push_back(drawn.at(drawn.time_of(i)));
    const CameraPath few = with_fewer_keys(dense, 0.05f, 4);
    EXPECT_LT(few.keys.size(), dense.keys.size() / 10);
    EXPECT_GE(few.keys.size(), 3u);
    for (int i = 0; i < dense.frames(); ++i) {
        const CameraKey a = dense.at(dense.time_of(i)), b = few.at(dense.time_of(i));
        EXPECT_LE(length(a.position_m - b.position_m), 0.0501f) << i;
        EXPECT_LE(std::fabs(std::remainder(a.yaw_deg - b.yaw_deg, 360.f)), 4.01f) << i;
    }
    EXPECT_EQ(with_fewer_keys(few, 1e-6f, 1e-4f).keys.size(), few.keys.size());
}

}  // namespace
}  // namespace fastscene
