// SuperSplat: a camera track in the viewer's settings (animTracks: times in frames, place, target and angle a key), or
// the poses of an editor's document (poseSets: frame, place and target a pose). In the viewer's frame; no roll.
#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/shortest.h"
#include "fastscene/io/camera_path_parts.h"
#include "fastscene/io/viewer.h"

namespace fastscene {
namespace {

Vec3f world_point(const Json& list, std::size_t at) {
    return {-list.at(at).get<float>(), -list.at(at + 1).get<float>(), list.at(at + 2).get<float>()};
}

// The viewer's angle is that over the longer side of the picture.
float viewer_fov_deg(float horizontal_deg, const CameraPath& camera) {
    return camera.width > camera.height ? horizontal_deg
                                        : vertical_fov_deg(horizontal_deg, camera.width, camera.height);
}
float horizontal_of_viewer_deg(float viewer_deg, const CameraPath& camera) {
    return camera.width > camera.height ? viewer_deg : horizontal_fov_deg(viewer_deg, camera.width, camera.height);
}

CameraKey key_looking_at(float time_s, Vec3f position, Vec3f target, const std::string& where) {
    const Vec3f way = target - position;
    if (!(length(way) > 1e-6f && length(way) < 1e6f && length(position) < 1e6f))
        throw Error("{}: expected a target apart from the camera's place, found both at one place", where);
    const Vec3f forward = normalize(way);
    constexpr float kDegrees = 180.f / kPi;
    return {time_s, position, std::atan2(forward.x, forward.z) * kDegrees,
            std::asin(std::clamp(-forward.y, -1.f, 1.f)) * kDegrees};
}

CameraPath path_from_track(const Json& track, CameraPath camera, const std::string& where) {
    camera.fps = track.value("frameRate", camera.fps);
    const Json &times = track.at("keyframes").at("times"), &values = track.at("keyframes").at("values");
    const bool has_fov = values.contains("fov") && values["fov"].size() == times.size();
    for (std::size_t i = 0; i < times.size(); ++i) {
        CameraKey key = key_looking_at(times[i].get<float>() / camera.fps, world_point(values.at("position"), 3 * i),
                                       world_point(values.at("target"), 3 * i),
                                       where + ": key " + std::to_string(i + 1));
        if (has_fov) key.fov_deg = horizontal_of_viewer_deg(values["fov"][i].get<float>(), camera);
        camera.keys.push_back(key);
    }
    return camera;
}

CameraPath path_from_poses(const Json& poses, CameraPath camera, const std::string& where) {
    for (const Json& pose : poses)
        camera.keys.push_back(key_looking_at(pose.at("frame").get<float>() / camera.fps,
                                             world_point(pose.at("position"), 0), world_point(pose.at("target"), 0),
                                             where + ": pose " + std::to_string(camera.keys.size() + 1)));
    std::stable_sort(camera.keys.begin(), camera.keys.end(),
                     [](const CameraKey& a, const CameraKey& b) { return a.time_s < b.time_s; });
    return camera;
}

}  // namespace

CameraPath path_from_supersplat(const Json& json, const CameraPath& otherwise, const std::string& where) {
    CameraPath camera = otherwise;
    camera.keys.clear();
    const char* lists = json.contains("animTracks") ? "animTracks" : "poseSets";
    const Json& list = json.at(lists);
    if (list.empty()) throw Error("{}: expected a camera track in {}, found none", where, lists);
    if (json.contains("animTracks")) camera = path_from_track(list.at(0), camera, where);
    else camera = path_from_poses(list.at(0).at("poses"), camera, where);
    if (!camera.keys.empty() && camera.keys.front().fov_deg != 0) camera.fov_deg = camera.keys.front().fov_deg;
    return camera;
}

Json supersplat_track(const CameraPath& camera) {
    Json times = Json::array(), positions = Json::array(), targets = Json::array(), fovs = Json::array();
    const auto add = [](Json& list, Vec3f world) {
        for (const float v : {-world.x, -world.y, world.z}) list.push_back(shortest(v));
    };
    for (int i = 0; i < camera.frames(); ++i) {
        const CameraKey key = camera.at(camera.time_of(i));
        times.push_back(i);
        add(positions, key.position_m);
        add(targets, world_from_camera(key) * Vec3f{0, 0, 1});
        fovs.push_back(shortest(viewer_fov_deg(key.fov_deg, camera)));
    }
    return {
        {"name", "path"},
        {"duration", shortest(static_cast<float>(camera.frames() - 1) / camera.fps)},
        {"frameRate", shortest(camera.fps)},
        {"loopMode", "none"},
        {"interpolation", "spline"},
        {"smoothness", 1},
        {"keyframes", {{"times", times}, {"values", {{"position", positions}, {"target", targets}, {"fov", fovs}}}}}};
}

Json supersplat_from_path(const CameraPath& camera) {
    const CameraKey first = camera.at(0);
    ViewerScene scene{"", first.position_m, world_from_camera(first) * Vec3f{0, 0, 1},
                      viewer_fov_deg(first.fov_deg, camera)};
    scene.tour = camera;
    return Json::parse(viewer_settings(scene));
}

}  // namespace fastscene
