// Training of the depth network: `fastscene depth train`.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/nn/egformer_training.h"

namespace fastscene {

struct DepthTrainParams {
    int height = 128, channels = 16;
    double painted = 0.3, repainted = 0.3, direct = 0.2;
    double share = 1;  // share of the examples, for quick experiments
    TrainingParams training{.steps = 20000,
                            .batch = 4,
                            .learning_rate = 5e-4,
                            .final_learning_rate = 2e-5,
                            .warmup = 200,
                            .ema_decay = 0.998,
                            .eval_steps = 1000};
};
template <class V>
void visit_fields(DepthTrainParams& p, V&& v) {
    v("height", p.height, Bounds{32, 1024},
      "Height of what the network sees, a multiple of 32; 512 as published. Its width is twice that.");
    v("channels", p.channels, Bounds{4, 256},
      "Of its first stage, a multiple of 4; 32 as published. Size and time grow with the square.");
    v("painted", p.painted, Bounds{0, 1},
      "Share of examples that are painted rooms: boxes in a box, made while training; 1 where there is no --data.");
    v("repainted", p.repainted, Bounds{0, 1},
      "Share of examples of our rooms whose floor, walls and things get other colors and patterns.");
    v("direct", p.direct, Bounds{0, 100},
      "Weight of a loss that aligns nothing, beside the published one, which aligns scale and shift; 0 = as "
      "published.");
    v("share", p.share, Bounds{0.001, 1}, "Use only this share of the pictures.");
    visit_fields(p.training, v);
}

struct DepthTraining {
    std::vector<std::filesystem::path> data;  // folders (examples.h); none: synthetic rooms only (painted_room.h)
    std::filesystem::path start;              // initial weights; empty: random
    DepthTrainParams params;
};

// Trains in `folder`: egformer.safetensors is the network, other files as in nn/training.h. Holds out a tenth of all
// places. Throws UsageError for invalid settings, Error if a folder has no pictures.
EgformerTrained train_depth(const DepthTraining& training, const std::filesystem::path& folder, const Run& run);

}  // namespace fastscene
