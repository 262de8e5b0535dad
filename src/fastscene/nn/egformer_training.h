// Training EGformer on pictures whose range is known. No libtorch in sight.
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

// Beyond, a range teaches nothing: published are 8 m, our halls are longer.
inline constexpr float kFarthestTaught_m = 15;

// Which surface a pixel lies on (depth/repaint.h).
using SurfaceId = std::uint16_t;
using SurfaceMap = Image<SurfaceId>;

// A panorama of the network's size: sRGB, and metres along each pixel's ray (0 = not known).
struct DepthExample {
    ImageRgb8 color;
    ImageF range;
    SurfaceMap surfaces = {};  // empty: not known
};

struct EgformerTraining {
    EgformerShape shape;
    TrainingParams training;
    double direct = 0;  // weight of direct_loss (nn/depth_losses.h) beside the published loss
    std::function<DepthExample(Random& rng)> draw;  // called on another thread
    std::vector<DepthExample> held_out;             // never drawn
    std::vector<float> mean_range_m;  // by latitude, from the top: what a room looks like before one has looked
    std::filesystem::path start;      // weights to start from; empty: random ones
    Json settings;                    // what else must be equal to go on with a training: the data
};

struct EgformerTrained {
    std::int64_t steps = 0;
    double abs_rel = 0, delta1 = 0;  // of the held-out pictures, scale and shift aligned
    std::filesystem::path weights;   // egformer.safetensors in the folder, 16 bit: what Egformer::load reads
};

// Works in `folder` as nn/training.h says; goes on from a checkpoint that is there. The loss is the published one
// (nn/depth_losses.h), and `direct` of ours. Throws as nn/training.h says.
EgformerTrained train_egformer(const EgformerTraining& training, const std::filesystem::path& folder, const Run& run);

}  // namespace fastscene
