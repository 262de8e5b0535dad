// Camera paths: where a film's camera is at each frame. As a file:
//   {"fps": 30, "fov_deg": 75, "size": [1280, 720],
//    "keys": [{"time_s": 0, "position_m": [0, 0, 0], "yaw_deg": 0, "pitch_deg": 0}, …]}
// Between keys the position follows a Catmull-Rom curve and the angles the shorter way round.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/math/rigid.h"

namespace fastscene {

struct CameraKey {
    float time_s = 0;
    Vec3f position_m;     // world
    float yaw_deg = 0;    // right about the world's down axis
    float pitch_deg = 0;  // up
};
struct CameraPath {
    float fps = 30, fov_deg = 75;
    int width = 1280, height = 720;
    std::vector<CameraKey> keys;  // at least one; times grow

    int frames() const;                // at least one; the last key is the last frame
    CameraKey at(float time_s) const;  // clamped to the first and last key
};
// Throws Error naming the file and what is wrong in it.
CameraPath load_camera_path(const std::filesystem::path& path);

}  // namespace fastscene
