// The sky: what is seen through windows, and what shines in.
#pragma once

#include "fastscene/image/image.h"
#include "fastscene/scene/room.h"

namespace fastscene {

// Radiance from a direction (world frame, unit, y down): gradient, clouds and scenery (outside.h). The sun's disc is
// excluded, since it is sampled separately.
Vec3f sky_radiance(const Sky& sky, Vec3f direction);

// The same from a table with 0.7 degrees per pixel: for illumination, which needs no leaves and window panes.
class SkyTable {
  public:
    explicit SkyTable(const Sky& sky);
    Vec3f at(Vec3f direction) const;

  private:
    ImageColor radiance_;
};

}  // namespace fastscene
