// Camera paths of films. Between keys, position, angles and field of view follow a spline that passes through every key
// without a jump of speed, and comes to rest at both ends.
#pragma once

#include <vector>

#include "fastscene/math/rigid.h"

namespace fastscene {

// Yaw turns right about the world's down axis, pitch turns up, roll turns clockwise about the line of sight.
Rigid world_from_camera_at(Vec3f position_m, float yaw_deg, float pitch_deg, float roll_deg = 0);

struct CameraKey {
    float time_s = 0;
    Vec3f position_m;  // world
    float yaw_deg = 0, pitch_deg = 0, roll_deg = 0;
    float fov_deg = 0;  // horizontal; 0: the path's
};
inline Rigid world_from_camera(const CameraKey& key) {
    return world_from_camera_at(key.position_m, key.yaw_deg, key.pitch_deg, key.roll_deg);
}
// The key at that pose; yaw in -180 to 180 degrees. Looking straight up or down, yaw is that of the picture's top.
CameraKey key_of_pose(float time_s, const Rigid& world_from_camera);

struct CameraPath {
    float fps = 30, fov_deg = 75;
    int width = 1280, height = 720;
    std::vector<CameraKey> keys;  // at least one; ascending times

    int frames() const;                // number of frames, at least one; the last key is the last frame
    float time_of(int frame) const;    // of a frame, on the keys' clock
    CameraKey at(float time_s) const;  // clamped to the first and last key; fov_deg is never 0
};
// The same path with as few keys as keep it, at every key left out, within `slack_m` and `slack_deg`: keys that a
// person can edit, out of a pose a frame.
CameraPath with_fewer_keys(const CameraPath& path, float slack_m, float slack_deg);
// Adds full turns so that the yaw and roll of neighbouring keys differ by at most half a turn.
void unwrap_angles(std::vector<CameraKey>& keys);

// The angle over a picture's height that belongs to one over its width, and back; degrees, square pixels.
float vertical_fov_deg(float horizontal_deg, int width, int height);
float horizontal_fov_deg(float vertical_deg, int width, int height);

}  // namespace fastscene
