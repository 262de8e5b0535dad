// Training of EGformer on pictures with known range. The interface is free of libtorch.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/random.h"
#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/egformer.h"
#include "fastscene/nn/training_params.h"

namespace fastscene {

// Farther pixels are masked out. Published: 8 m; our halls are longer.
inline constexpr float kFarthestTaught_m = 15;

// Index of the surface that a pixel shows (depth/repaint.h).
using SurfaceId = std::uint16_t;
using SurfaceMap = Image<SurfaceId>;

// A panorama of the network's size: sRGB, and range in metres along each pixel's ray (0 = unknown).
struct DepthExample {
    ImageRgb8 color;
    ImageF range;
    SurfaceMap surfaces = {};  // empty: unknown
};

struct EgformerTraining {
    EgformerShape shape;
    TrainingParams training;
    double direct = 0;  // weight of direct_loss (nn/depth_losses.h), in addition to the published loss
    std::function<DepthExample(Random& rng)> draw;  // called on another thread
    std::vector<DepthExample> held_out;             // validation examples
    std::vector<float> mean_range_m;                // prior for the prediction: mean range by latitude, from the top
    std::filesystem::path start;                    // initial weights; empty: random
    Json settings;  // further settings, such as the data, that must match for a training to be resumed
};

struct EgformerTrained {
    std::int64_t steps = 0;
    double abs_rel = 0, delta1 = 0;  // on the held-out pictures, after scale and shift alignment
    std::filesystem::path weights;   // egformer.safetensors in the folder, 16 bit, as Egformer::load reads it
};

// Trains in `folder` as described in nn/training.h; resumes from a checkpoint there. The loss is the published one
// (nn/depth_losses.h) plus `direct` times ours. Throws what train() throws.
EgformerTrained train_egformer(const EgformerTraining& training, const std::filesystem::path& folder, const Run& run);

}  // namespace fastscene
