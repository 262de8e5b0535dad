#include "fastscene/pipeline/camera_path.h"

#include <gtest/gtest.h>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"

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

TEST(CameraPath, BadFilesAreRefusedWithTheirName) {
    const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "fastscene-path.json";
    for (const char* text :
         {"[]", "{}", R"({"keys": []})", R"({"keys": [{"position_m": [0, 0]}]})",
          R"({"keys": [{"position_m": [0,0,0]}], "fps": 0})", R"({"keys": [{"position_m": [0,0,0]}], "size": [0, 5]})",
          R"({"keys": [{"position_m": [0,0,0]}, {"time_s": 1e9, "position_m": [0,0,0]}]})",
          R"({"keys": [{"time_s": 1, "position_m": [0,0,0]}, {"time_s": 1, "position_m": [0,0,0]}]})"}) {
        write_file(file, text);
        try {
            load_camera_path(file);
            ADD_FAILURE() << text;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find("fastscene-path.json"), std::string::npos);
        }
    }
    for (const auto& [text, said] :
         {std::pair{R"({"keys": [{"position_m": [0,0,0]}, {"position_m": [0,0,0], "yaw": 20}]})",
                    "key 2: expected time_s, position_m, yaw_deg, pitch_deg, found yaw"},
          {R"({"keys": [{"position_m": [0,0,0], "yaw_deg": 1e39}]})",
           "key 1: expected a number below a million as yaw_deg, found 1e+39"},
          {R"({"keys": [{"position_m": [0,0]}]})", "key 1: expected 3 numbers as position_m, found [0,0]"},
          {R"({"keys": {"a": 3}})", "expected a list of keys"},
          {R"({"key": []})", "found key; did you mean keys?"},
          {R"({"keys": [{"position_m": [0,0,0]}], "fps": "fast"})", "as fps, found \"fast\""}}) {
        write_file(file, text);
        try {
            load_camera_path(file);
            ADD_FAILURE() << text;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(said), std::string::npos) << e.what();
        }
    }
    write_file(file, R"({"size": [64, 32], "keys": [{"position_m": [0,0,1], "yaw_deg": 3}]})");
    const CameraPath path = load_camera_path(file);
    EXPECT_EQ(path.width, 64);
    EXPECT_EQ(path.keys.at(0).yaw_deg, 3);
}

}  // namespace
}  // namespace fastscene
