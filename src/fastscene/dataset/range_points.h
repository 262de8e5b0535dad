// A picture's range map as depth along the axis, and as points of the world.
#pragma once

#include <vector>

#include "fastscene/dataset/set.h"
#include "fastscene/scene/view.h"

namespace fastscene::dataset {

// Millimetres along the optical axis, 0 = outside; of a panorama, which has none, along the ray.
Image<std::uint16_t> depth_millimetres(const DataSet& set, const SetPicture& picture);
// About `count` points, evenly over the picture.
std::vector<SurfacePoint> range_points(const DataSet& set, const SetPicture& picture, int count);

}  // namespace fastscene::dataset
