#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/io/camera_path_io.h"

namespace fastscene {
namespace {

std::filesystem::path path_file(const std::string& name) {
    return std::filesystem::path(::testing::TempDir()) / ("fastscene-path-" + name);
}

CameraPath some_path() {
    CameraPath path{24, 70, 640, 360, {}};
    path.keys = {{0, {0.1f, -0.2f, 0.3f}, 10, -5}, {0.5f, {0.4f, -0.2f, 0.1f}, 170, 20}, {1, {1, 0, -2}, 215, -30}};
    path.keys[1].fov_deg = 60;
    return path;
}

// Our own format keeps the keys, the others a pose a frame; all show the same film.
TEST(CameraPathFile, EveryFormatComesBackAsTheSameFilm) {
    const CameraPath path = some_path();
    CameraPath otherwise;
    otherwise.fps = path.fps, otherwise.width = path.width, otherwise.height = path.height;
    for (std::size_t f = 0; f < std::size(kPathFormats); ++f) {
        SCOPED_TRACE(kPathFormats[f]);
        const auto format = static_cast<PathFormat>(f);
        const auto file = path_file(format == PathFormat::blender ? "film.chan" : "film.json");
        save_camera_path(file, path, format);
        const CameraPath again = load_camera_path(file, otherwise);
        ASSERT_EQ(again.frames(), path.frames());
        EXPECT_NEAR(again.fps, path.fps, 1e-5);
        for (int i = 0; i < path.frames(); ++i) {
            const CameraKey a = path.at(path.time_of(i)), b = again.at(again.time_of(i));
            const Rigid p = world_from_camera(a), q = world_from_camera(b);
            EXPECT_LT(length(p.translation - q.translation), 2e-5f) << i;
            EXPECT_LT(length(p.rotation.column(2) - q.rotation.column(2)), 1e-4f) << i;
            EXPECT_LT(length(p.rotation.column(0) - q.rotation.column(0)), 1e-4f) << i;
            EXPECT_NEAR(a.fov_deg, b.fov_deg, 1e-3) << i;
        }
    }
}

TEST(CameraPathFile, RollIsKeptWhereTheFormatHasIt) {
    CameraPath path = some_path();
    path.keys[2].roll_deg = 15;
    for (const PathFormat format : {PathFormat::fastscene, PathFormat::nerfstudio, PathFormat::blender}) {
        const auto file = path_file(format == PathFormat::blender ? "film.chan" : "film.json");
        save_camera_path(file, path, format);
        EXPECT_NEAR(load_camera_path(file, path).keys.back().roll_deg, 15, 1e-3);
    }
}

// The axes, by hand: a camera at the world's origin that looks along +z, then one metre ahead and half a metre up.
TEST(CameraPathFile, AxesAreThoseOfTheOtherPrograms) {
    CameraPath path{1, 90, 100, 100, {}};
    path.keys = {{0, {}, 0, 0}, {1, {0, -0.5f, 1}, 90, 0}};
    const auto file = path_file("axes.json");
    save_camera_path(file, path, PathFormat::nerfstudio);
    // OpenGL's camera: its y is up, which is the world's -y, and it looks along its -z.
    EXPECT_EQ(read_json(file)["camera_path"][0]["camera_to_world"],
              Json::parse("[1,0,0,0, 0,-1,0,0, 0,0,-1,0, 0,0,0,1]"));
    EXPECT_NEAR(read_json(file)["camera_path"][0]["fov"].get<double>(), 90, 1e-4);
    save_camera_path(file, path, PathFormat::supersplat);
    const Json values = read_json(file)["animTracks"][0]["keyframes"]["values"];
    EXPECT_EQ(read_json(file)["startMode"], "animTrack");
    EXPECT_NEAR(values["position"][4].get<double>(), 0.5, 1e-6);  // the second key's height, y up
    EXPECT_NEAR(values["target"][3].get<double>() - values["position"][3].get<double>(), -1, 1e-6);  // x left
    // Its angle is that over the picture's longer side.
    CameraPath wide = path, tall = path;
    wide.width = 200, tall.height = 200;
    for (const CameraPath& shape : {wide, tall}) {
        save_camera_path(file, shape, PathFormat::supersplat);
        const float longer = shape.width > shape.height ? 90 : vertical_fov_deg(90, shape.width, shape.height);
        EXPECT_NEAR(read_json(file)["animTracks"][0]["keyframes"]["values"]["fov"][0].get<float>(), longer, 1e-3);
        EXPECT_NEAR(load_camera_path(file, shape).fov_deg, 90, 1e-3);
    }
    save_camera_path(path_file("axes.chan"), path, PathFormat::blender);
    // Blender's y-up file: the frame of our GLB, x left; the camera looks along its own -z, so it is turned by half a
    // turn to look along +z, then by a quarter to the right, which is -x.
    std::istringstream lines(read_file(path_file("axes.chan")));
    double n, x, y, z, rx, ry, rz, fov;
    lines >> n >> x >> y >> z >> rx >> ry >> rz >> fov;
    EXPECT_EQ(n, 1);
    EXPECT_NEAR(std::fabs(ry), 180, 1e-3);
    EXPECT_NEAR(fov, 90, 1e-3);
    lines >> n >> x >> y >> z >> rx >> ry >> rz >> fov;
    EXPECT_NEAR(y, 0.5, 1e-6);
    EXPECT_NEAR(z, 1, 1e-6);
}

TEST(CameraPathFile, OtherProgramsFilesAreRead) {
    write_file(path_file("ns.json"),
               R"({"camera_type": "perspective", "render_height": 100, "render_width": 200, "fps": 10,
        "seconds": 0.2, "camera_path": [{"camera_to_world": [1,0,0,5, 0,-1,0,6, 0,0,-1,7, 0,0,0,1], "fov": 50, "aspect": 2},
        {"camera_to_world": [1,0,0,6, 0,-1,0,6, 0,0,-1,7, 0,0,0,1], "fov": 50, "aspect": 2}]})");
    const CameraPath ns = load_camera_path(path_file("ns.json"));
    EXPECT_EQ(ns.frames(), 2);
    EXPECT_EQ(ns.keys[1].position_m, (Vec3f{6, 6, 7}));
    EXPECT_NEAR(ns.keys[0].pitch_deg, 0, 1e-4);
    EXPECT_EQ(ns.width, 200);
    // Keyframes of its viewer: text, column by column.
    write_file(path_file("kf.json"),
               R"({"render_height": 100, "render_width": 200, "fps": 10, "seconds": 2, "camera_path": [],
        "keyframes": [{"matrix": "[1,0,0,0, 0,-1,0,0, 0,0,-1,0, 5,6,7,1]", "fov": 50},
                      {"matrix": "[1,0,0,0, 0,-1,0,0, 0,0,-1,0, 5,6,9,1]", "fov": 50}]})");
    const CameraPath kf = load_camera_path(path_file("kf.json"));
    EXPECT_EQ(kf.keys[1].time_s, 2);
    EXPECT_EQ(kf.keys[1].position_m, (Vec3f{5, 6, 9}));
    write_file(path_file("poses.json"), R"({"poseSets": [{"name": "set0", "poses": [
        {"name": "b", "frame": 30, "position": [-1, 0, 2], "target": [-1, 0, 3]},
        {"name": "a", "frame": 0, "position": [0, 0, 0], "target": [0, 0, 1]}]}]})");
    const CameraPath poses = load_camera_path(path_file("poses.json"));
    EXPECT_EQ(poses.keys[1].position_m, (Vec3f{1, 0, 2}));
    EXPECT_EQ(poses.keys[1].time_s, 1);
    for (const auto& [name, text] :
         {std::pair{"bad1.json", R"({"camera_path": [{"camera_to_world": [1, 2]}]})"},
          {"bad2.json", R"({"camera_path": [{"camera_to_world": [1,0,0,0, 1,0,0,0, 0,0,1,0, 0,0,0,1]}]})"},
          {"bad3.json", R"({"camera_path": {"a": 3}})"},
          {"bad4.json", R"({"keyframes": "no"})"},
          {"bad5.json", R"({"animTracks": []})"},
          {"bad6.json",
           R"({"animTracks": [{"keyframes": {"times": [0], "values": {"position": [0], "target": []}}}]})"},
          {"bad7.json", R"({"poseSets": [{"poses": [{"frame": 0, "position": [0,0,0], "target": [0,0,0]}]}]})"},
          {"bad8.chan", "1 2 3\n"},
          {"bad9.chan", "1 0 0 0 0 0 0 x\n"},
          {"bad10.chan", ""}}) {
        write_file(path_file(name), text);
        try {
            load_camera_path(path_file(name));
            ADD_FAILURE() << name;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(name), std::string::npos) << e.what();
        }
    }
}

TEST(CameraPathFile, BadFilesAreRefusedWithTheirName) {
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
                    "key 2: expected time_s, position_m, yaw_deg, pitch_deg, roll_deg, fov_deg, found yaw"},
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
