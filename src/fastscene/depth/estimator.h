// Range from color alone, for panoramas without a measured range.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/registry.h"
#include "fastscene/base/run.h"
#include "fastscene/depth/depth.h"
#include "fastscene/depth/metric_range.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/egformer.h"

namespace fastscene {

struct EstimatedRange {
    ImageF range;      // metres along each pixel's ray, of the picture's size
    Json assumptions;  // assumptions and findings, for stage.json
};

// A network's output, of any size and increasing with distance, in metres and aligned to the picture. `about` gets the
// fit and the walls that were found. Warns if the floor does not fix the scale.
EstimatedRange in_metres(const ImageF& relative, const ImageColor& color, float camera_height_m, UnknownOfRange unknown,
                         Json about, const Run& run);

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

// A way to estimate range, in a source file of its own under depth/depth_backends/ (docs/extend/depth-network.md shows
// how to add one). Flags, --help, errors and the contract test take their lists from the registry.
struct DepthBackend {
    std::string name = {};   // as its source file
    std::string about = {};  // half a sentence, for --help
    std::string model = {};  // of models/registry.cc, whose file in the cache serves as its weights; empty: none
    int auto_rank = 0;       // "auto" takes the ready one with the highest rank; 0: only when it is named
    bool (*ready)(const DepthParams& params) = nullptr;  // whether what it needs is here; null: it needs nothing
    // Throws UsageError if weights are missing; Error naming the file and the key that is missing or misshaped.
    std::unique_ptr<DepthEstimator> (*make)(const DepthParams& params) = nullptr;
};
// The one that params.backend names; for "auto" the best that is ready. Throws UsageError with the names for another.
const DepthBackend& depth_backend_of(const DepthParams& params);
// Those whose model is worth looking for if no weights are given: the one that params.backend names; for "auto" all it
// may choose, the best first. Without those that need no model.
std::vector<const DepthBackend*> depth_backends_with_models(const DepthParams& params);
std::unique_ptr<DepthEstimator> make_depth_estimator(const DepthParams& params);

}  // namespace fastscene
