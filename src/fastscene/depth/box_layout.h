// Depth backend "layout": fits a box to the room. Without network weights, walls, floor and ceiling still make up most
// of a panorama, and the lines where they meet determine their distance.
#pragma once

#include <array>

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"

namespace fastscene {

// A box seen from inside, the camera at the origin, vertical walls. Metres.
struct BoxLayout {
    float yaw = 0;                            // radians: longitude of wall 0's normal; in [0, pi/2)
    std::array<float, 4> wall_m{2, 2, 2, 2};  // distances to the walls at yaw, yaw + 90, + 180, + 270 degrees
    float floor_m = 1.6f, ceiling_m = 1.f;    // below and above the camera
    float score = 0;                          // mean edge strength under the box's edges, 0..1
};

// Fits the box whose edges lie on the strongest lines of the picture, with the floor `camera_height_m` below the
// camera. Exhaustive over yaws and ceiling heights; for each, the four walls are optimized in turn.
BoxLayout fit_box(const ImageColor& panorama, float camera_height_m);

// Range in metres along each pixel's ray to the box.
ImageF range_of_box(const BoxLayout& box, EquirectSize size);

}  // namespace fastscene
