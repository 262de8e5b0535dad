// What a camera sees, pixel by pixel: depth, normals, things, classes. From the room's surfaces, so it is exact.
#pragma once

#include <cstdint>

#include "fastscene/export/instances.h"
#include "fastscene/geometry/pinhole.h"
#include "fastscene/image/image.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

struct ViewMaps {
    ImageF depth_z;                 // metres along the optical axis; +inf: outside
    ImageColor normal;              // unit, in the camera's frame (x right, y down, z forward); zero: outside
    Image<std::uint16_t> instance;  // numbers of instances_of; 0: outside
};
ViewMaps view_maps(const TracedRoom& room, const Pinhole& camera, const Rigid& world_from_camera, const Run& run);

// NYU40 class of each pixel.
ImageMask class_map(const Image<std::uint16_t>& instance, const std::vector<Instance>& instances);

}  // namespace fastscene
