// What is seen through a window, and what shines in.
#pragma once

#include "fastscene/image/image.h"
#include "fastscene/scene/room.h"

namespace fastscene {

// Radiance from a direction (world frame, unit; y is down): the sky's gradient and clouds, and what stands before
// it (outside.h). The sun's disc is not in it: it is sampled by itself.
Vec3f sky_radiance(const Sky& sky, Vec3f direction);

// The same, looked up in a picture of 0.7 degrees a pixel: for light, which has no use for leaves and panes.
class SkyTable {
  public:
    explicit SkyTable(const Sky& sky);
    Vec3f at(Vec3f direction) const;

  private:
    ImageColor radiance_;
};

}  // namespace fastscene
