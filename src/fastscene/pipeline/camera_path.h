// Camera paths for rendering films. File format: {"fps": 30, "fov_deg": 75, "size": [1280, 720], "keys": [{"time_s": 0,
// "position_m": [0, 0, 0], "yaw_deg": 0, "pitch_deg": 0}, …]} Between keys, positions follow a Catmull-Rom spline, and
// angles take the shorter way.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/math/rigid.h"

namespace fastscene {

struct CameraKey {
    float time_s = 0;
    Vec3f position_m;     // world
    float yaw_deg = 0;    // to the right, about the world's down axis
    float pitch_deg = 0;  // upwards
};
struct CameraPath {
    float fps = 30, fov_deg = 75;
    int width = 1280, height = 720;
    std::vector<CameraKey> keys;  // at least one; ascending times

    int frames() const;                // number of frames, at least one; the last key is the last frame
    CameraKey at(float time_s) const;  // clamped to the first and last key
};
// Throws Error naming the file and the problem.
CameraPath load_camera_path(const std::filesystem::path& path);

}  // namespace fastscene
