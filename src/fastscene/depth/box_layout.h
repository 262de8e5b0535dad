// Depth backend "layout": the room as a box. Where no network's weights are at hand, a room's walls, floor and
// ceiling are still the most of what a panorama shows, and the lines where they meet tell how far they are.
#pragma once

#include <array>

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"

namespace fastscene {

// A box seen from inside, the camera at the origin, upright. Metres.
struct BoxLayout {
    float yaw = 0;                            // radians: wall 0 is met at right angles at this longitude; in [0, pi/2)
    std::array<float, 4> wall_m{2, 2, 2, 2};  // distances to the walls at yaw, yaw + 90, + 180, + 270 degrees
    float floor_m = 1.6f, ceiling_m = 1.f;    // below and above the camera
    float score = 0;                          // mean edge strength under the box's edges, 0..1
};

// The box whose edges lie on the strongest lines of the picture, with the floor `camera_height_m` below the camera.
// Looks through all yaws and ceiling heights; for each the four walls are moved in turn to where they fit best.
BoxLayout fit_box(const ImageColor& panorama, float camera_height_m);

// Range in metres along each pixel's ray to the box.
ImageF range_of_box(const BoxLayout& box, EquirectSize size);

}  // namespace fastscene
