// The camera of a picture: a panorama or a perspective view.
#pragma once

#include <optional>

#include "fastscene/base/json.h"
#include "fastscene/geometry/pinhole.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/math/rigid.h"

namespace fastscene::dataset {

struct Camera {
    Rigid world_from_camera;
    Pinhole pinhole;  // a panorama has only its width and height
    bool panorama = false;

    EquirectSize size() const { return {pinhole.width, pinhole.height}; }
    // Unit direction in the camera's frame, through the center of a pixel.
    Vec3f ray(int x, int y) const;
    // Where a point of the world is seen; nothing if it is outside of the picture.
    std::optional<Vec2f> seen_at(Vec3f point) const;
};

// "camera" and "world_from_camera" of a picture's JSON.
Json lens_json(const Camera& camera);
// Throws Json::exception if something is missing.
Camera camera_from_json(const Json& about, int width, int height);

}  // namespace fastscene::dataset
