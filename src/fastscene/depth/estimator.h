// Range from color alone: what a panorama that nobody measured needs.
#pragma once

#include <memory>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/depth/depth.h"
#include "fastscene/image/image.h"

namespace fastscene {

struct EstimatedRange {
    ImageF range;       // metres along each pixel's ray, the picture's size
    Json assumptions;   // what was assumed and found, for stage.json
};

class DepthEstimator {
  public:
    virtual ~DepthEstimator() = default;
    // Linear color, equirectangular, any size. Deterministic (for a network: with a fixed number of threads).
    virtual EstimatedRange estimate(const ImageColor& color, const Run& run) const = 0;
};

// The weights that come with the program: better than a box (docs/benchmarks/depth.md), or they would not be there.
inline constexpr const char* kShippedDepth = "egformer-rooms";

// params.backend "egformer", "layout" or "auto": egformer with the weights that are named or shipped, else layout. Throws Error naming the
// weights file and the key that is missing or has another shape, UsageError when egformer has no weights.
std::unique_ptr<DepthEstimator> make_depth_estimator(const DepthParams& params);

}  // namespace fastscene
