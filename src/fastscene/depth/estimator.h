// Range from color alone, for panoramas without a measured range.
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
    ImageF range;      // metres along each pixel's ray, of the picture's size
    Json assumptions;  // assumptions and findings, for stage.json
};

class DepthEstimator {
  public:
    virtual ~DepthEstimator() = default;
    // Linear color, equirectangular, any size. Deterministic (for networks: with a fixed number of threads).
    virtual EstimatedRange estimate(const ImageColor& color, const Run& run) const = 0;
};

// Built-in weights, the finest first. Averaged, they are better than the coarser one alone on rooms and than the finer
// one alone on photographs, and always better than a box (docs/benchmarks.md).
inline constexpr std::array<const char*, 2> kShippedDepth{"egformer-rooms-256", "egformer-rooms"};

// Mean prediction of several networks (Egformer::relative_depth), at the size of the first: their errors are partly
// independent. They must have been trained with the same unit.
ImageF mean_depth(std::span<const Egformer> networks, const ImageColor& color, int augmentations, const Run& run);

// params.backend "egformer", "layout" or "auto": egformer with the given or built-in weights (averaging several
// networks), otherwise layout. Throws Error naming the weights file and the missing or misshaped key, UsageError if
// egformer has no weights.
std::unique_ptr<DepthEstimator> make_depth_estimator(const DepthParams& params);

}  // namespace fastscene
