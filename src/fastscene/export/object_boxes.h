// The box of each thing along its own axes, from its triangles.
#pragma once

#include <vector>

#include "fastscene/scene/room.h"

namespace fastscene {

struct ObjectBox {
    bool empty = true;  // a thing without a surface of its own
    Vec3f low, high;    // in the object's frame
    float area_m2 = 0;  // of its surface

    Vec3f center() const { return (low + high) * 0.5f; }
    Vec3f size() const { return high - low; }
};
std::vector<ObjectBox> object_boxes(const Room& room);  // of Room::objects

}  // namespace fastscene
