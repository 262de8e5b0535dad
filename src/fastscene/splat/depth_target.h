// Target depths for views, rendered from the surface points that training starts from.
#pragma once

#include "fastscene/base/run.h"
#include "fastscene/splat/engine.h"

namespace fastscene::splat {

class DepthTarget {
  public:
    // Uses `count` of the points.
    DepthTarget(const ViewSet& set, int count, const Run& run);
    // Metres along the optical axis (equirectangular: along the ray); 0 where no points cover the pixel. Valid until
    // the next call.
    const ImageF& of(const View& view);

  private:
    Cloud points_;
    Engine engine_;
    ImageF depth_;
};

}  // namespace fastscene::splat
