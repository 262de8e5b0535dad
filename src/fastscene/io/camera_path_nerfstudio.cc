// nerfstudio's camera_path.json: render_width, render_height, fps, seconds, and camera_path, a list with a
// camera_to_world of 16 numbers, row by row, and a vertical fov in degrees for each frame. A file of its viewer that
// was saved without rendering has keyframes instead, with the matrix column by column in older versions.
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/shortest.h"
#include "fastscene/io/camera_path_parts.h"

namespace fastscene {
namespace {

// OpenGL's camera axes: y up, z back.
Rigid flipped(Rigid pose) {
    for (Vec3f* row : {&pose.rotation.row0, &pose.rotation.row1, &pose.rotation.row2})
        *row = {row->x, -row->y, -row->z};
    return pose;
}

Rigid pose_of(const Json& given, const std::string& where) {
    // Keyframes hold their matrix as text in some versions.
    const Json list = given.is_string() ? Json::parse(given.get<std::string>()) : given;
    std::array<double, 16> m{};
    if (!list.is_array() || list.size() != m.size())
        throw Error("{}: expected a matrix of 16 numbers, found {}", where, list.dump().substr(0, 60));
    for (std::size_t i = 0; i < m.size(); ++i) m[i] = list[i].get<double>();
    // Column by column: the place is in the last row.
    if (m[3] == 0 && m[7] == 0 && m[11] == 0 && (m[12] != 0 || m[13] != 0 || m[14] != 0))
        m = {m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14], 0, 0, 0, 1};
    for (const std::size_t i : {3u, 7u, 11u})
        if (!(std::fabs(m[i]) < 1e6)) throw Error("{}: expected a place below a million, found {}", where, m[i]);
    return flipped({rotation_from({m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, where),
                    {static_cast<float>(m[3]), static_cast<float>(m[7]), static_cast<float>(m[11])}});
}

}  // namespace

CameraPath path_from_nerfstudio(const Json& json, const CameraPath& otherwise, const std::string& where) {
    CameraPath camera = otherwise;
    camera.keys.clear();
    camera.width = json.value("render_width", camera.width), camera.height = json.value("render_height", camera.height);
    const bool whole = json.contains("camera_path") && !json["camera_path"].empty();
    const Json& frames = json.at(whole ? "camera_path" : "keyframes");
    const float seconds = json.value("seconds", 0.f);
    const auto count = static_cast<float>(frames.size());
    camera.fps = json.value("fps", whole && seconds > 0 ? count / seconds : camera.fps);
    const float step = whole || seconds <= 0 || count < 2 ? 1.f / camera.fps : seconds / (count - 1);
    for (const Json& frame : frames) {
        const std::size_t i = camera.keys.size();
        const std::string place = where + ": frame " + std::to_string(i + 1);
        CameraKey key = key_of_pose(static_cast<float>(i) * step,
                                    pose_of(frame.at(whole ? "camera_to_world" : "matrix"), place));
        if (frame.contains("fov"))
            key.fov_deg = horizontal_fov_deg(frame["fov"].get<float>(), camera.width, camera.height);
        camera.keys.push_back(key);
    }
    if (!camera.keys.empty() && camera.keys.front().fov_deg != 0) camera.fov_deg = camera.keys.front().fov_deg;
    return camera;
}

Json nerfstudio_from_path(const CameraPath& camera) {
    Json frames = Json::array(), keyframes = Json::array();
    const float aspect = static_cast<float>(camera.width) / static_cast<float>(camera.height);
    for (int i = 0; i < camera.frames(); ++i) {
        const CameraKey key = camera.at(camera.time_of(i));
        const Rigid pose = flipped(world_from_camera(key));
        const Mat3f& r = pose.rotation;
        const Vec3f t = pose.translation;
        Json matrix = Json::array();
        for (const auto& [row, place] : {std::pair{r.row0, t.x}, {r.row1, t.y}, {r.row2, t.z}})
            for (const float v : {row.x, row.y, row.z, place}) matrix.push_back(shortest(v));
        for (const int v : {0, 0, 0, 1}) matrix.push_back(v);
        const double fov = shortest(vertical_fov_deg(key.fov_deg, camera.width, camera.height));
        frames.push_back({{"camera_to_world", matrix}, {"fov", fov}, {"aspect", shortest(aspect)}});
        if (i == 0 || i + 1 == camera.frames())
            keyframes.push_back({{"matrix", matrix}, {"fov", fov}, {"aspect", shortest(aspect)}});
    }
    return {{"camera_type", "perspective"},
            {"render_height", camera.height},
            {"render_width", camera.width},
            {"fps", shortest(camera.fps)},
            {"seconds", shortest(static_cast<float>(camera.frames()) / camera.fps)},
            {"is_cycle", false},
            {"smoothness_value", 0},
            {"keyframes", std::move(keyframes)},
            {"camera_path", std::move(frames)}};
}

}  // namespace fastscene
