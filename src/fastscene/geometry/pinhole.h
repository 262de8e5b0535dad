// Perspective camera: x right, y down, z forward (COLMAP's PINHOLE).
#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "fastscene/math/vec.h"

namespace fastscene {

struct Pinhole {
    int width = 0, height = 0;
    float fx = 0, fy = 0, cx = 0, cy = 0;  // pixels

    // Square pixels, principal point at the center; fov_deg is the full horizontal angle, in (0, 180).
    static Pinhole with_fov(int width, int height, float fov_deg) {
        const float f = static_cast<float>(width) / 2.f / std::tan(fov_deg * std::numbers::pi_v<float> / 360.f);
        return {width, height, f, f, static_cast<float>(width) / 2.f, static_cast<float>(height) / 2.f};
    }
    // Direction through picture point (px, py), with z = 1.
    Vec3f direction_at(Vec2f pixel) const { return {(pixel.x - cx) / fx, (pixel.y - cy) / fy, 1.f}; }
    // Projects a point in the camera's frame; none behind the camera.
    std::optional<Vec2f> project(Vec3f p_camera) const {
        if (!(p_camera.z > 0.f)) return {};
        return Vec2f{fx * p_camera.x / p_camera.z + cx, fy * p_camera.y / p_camera.z + cy};
    }
    friend bool operator==(const Pinhole&, const Pinhole&) = default;
};

}  // namespace fastscene
