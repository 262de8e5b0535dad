// Range from color alone: what a panorama that nobody measured needs.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/depth/depth.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/egformer.h"

namespace fastscene {

struct EstimatedRange {
    ImageF range;      // metres along each pixel's ray, the picture's size
    Json assumptions;  // what was assumed and found, for stage.json
};

class DepthEstimator {
  public:
    virtual ~DepthEstimator() = default;
    // Linear color, equirectangular, any size. Deterministic (for a network: with a fixed number of threads).
    virtual EstimatedRange estimate(const ImageColor& color, const Run& run) const = 0;
};

// The weights that come with the program, the finest first: in rooms together better than the coarser one alone, on
// photographs than the finer, and both than a box (docs/benchmarks.md).
inline constexpr std::array<const char*, 2> kShippedDepth{"egformer-rooms-256", "egformer-rooms"};

// What several networks say of a picture (Egformer::relative_depth), at the size of the first: their mean, for where
// one is wrong another often is less so. They must have been taught one unit.
ImageF mean_depth(std::span<const Egformer> networks, const ImageColor& color, int augmentations, const Run& run);

// params.backend "egformer", "layout" or "auto": egformer with the weights that are named or shipped (the mean of those
// networks), else layout. Throws Error naming the weights file and the key that is missing or has another shape,
// UsageError when egformer has no weights.
std::unique_ptr<DepthEstimator> make_depth_estimator(const DepthParams& params);

}  // namespace fastscene
