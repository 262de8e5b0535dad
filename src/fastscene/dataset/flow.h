// Optical flow between two pictures of a room: where each pixel's surface is seen in the other one. Exact, from ranges,
// poses and the room itself, which tells what is hidden.
#pragma once

#include <functional>

#include "fastscene/dataset/camera.h"
#include "fastscene/image/image.h"
#include "fastscene/io/color_maps.h"

namespace fastscene::dataset {

// The pixel moves by (u, v); valid: its surface is seen there. Not valid: hidden, out of the picture, or the outside.
struct FlowPixel {
    float u = 0, v = 0;
    bool valid = false;
};
using FlowMap = Image<FlowPixel>;

// `sees(point)`: whether the other picture's viewpoint sees a point of the world. `range`: +inf outside. In panoramas
// u is the shorter way around.
FlowMap flow_between(const Camera& from, const Camera& to, const ImageF& range, const std::function<bool(Vec3f)>& sees);

// A pixel's move as two 16-bit counts: 32768 + u / unit, 32768 + v / unit, and 1 or 0 for valid; (0, 0, 0) where it is
// not. The unit is KITTI's 1/64 pixel, or as many times two larger as pictures of this size need.
float flow_unit_px(int width, int height, bool panorama);
Image3x16 encoded_flow(const FlowMap& flow, float unit_px);
FlowMap decoded_flow(const Image3x16& counts, float unit_px);

}  // namespace fastscene::dataset
