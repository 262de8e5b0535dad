// The depth that views should have, as far as the points know it that the splats start from.
#pragma once

#include "fastscene/base/run.h"
#include "fastscene/splat/engine.h"

namespace fastscene::splat {

class DepthTarget {
  public:
    // Of `count` of the points.
    DepthTarget(const ViewSet& set, int count, const Run& run);
    // Metres along the optical axis (equirectangular: along the ray); 0 where the points do not cover a pixel. Valid
    // until the next call.
    const ImageF& of(const View& view);

  private:
    Cloud points_;
    Engine engine_;
    ImageF depth_;
};

}  // namespace fastscene::splat
