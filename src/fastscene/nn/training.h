// Training: the loop around a step. Curves, evaluation on held-out pictures, checkpoints, exact resumption.
//
// Learner net("network", start_he(run.seed), device, [&](const Scope& s) { … }, {…});
// TrainingTask task{.learners = {&net}, .draw = …, .step = …, .evaluate = …};
// train(task, params, folder, run);
//
// The task defines what a step does; timing, output and termination are handled here. Private to nn/ (torch).
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/random.h"
#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/learner.h"
#include "fastscene/nn/training_params.h"

namespace fastscene::nn {

using Batch = std::vector<at::Tensor>;
using Numbers = std::vector<std::pair<std::string, double>>;  // by name; names and order never change

struct Evaluation {
    Numbers held_out;  // metrics on held-out pictures
    ImageRgb8 sheet;   // contact sheet; may be empty
};

struct TrainingTask {
    std::vector<Learner*> learners;
    // The examples of a step. Called on another thread while the previous step is computed; must depend on the rng
    // only.
    std::function<Batch(Random& rng)> draw;
    // Computes losses, backward(), Learner::update(learning_rate).
    std::function<Numbers(const Batch& batch, std::int64_t step, double learning_rate)> step;
    std::function<Evaluation()> evaluate;  // uses the learners' EMA weights
    int held_out = 0, held_out_together = 1;  // pictures that evaluate() looks at, in all and in a pass: for estimates
    Json settings;  // further settings that must match for a checkpoint to be resumed: data, sizes, losses
};

struct TrainingOutcome {
    std::int64_t steps = 0;  // total number done
    bool finished = false;   // false: the time limit came first
    Numbers held_out;        // of the last evaluation
};

// Trains in `folder`: checkpoint.safetensors, training.json, curves.csv, curve-NAME.svg, sheets/. Resumes from a
// checkpoint there, with the same results as without the interruption (on the same machine and thread count).
// Checkpoints are written under a temporary name and renamed: a full disk leaves the last one intact. Throws UsageError
// if the folder's training has other settings, Error if a file cannot be written, Stopped after a final checkpoint.
TrainingOutcome train(const TrainingTask& task, const TrainingParams& params, const std::filesystem::path& folder,
                      const Run& run);

// Learning rate schedule: linear warm-up, then cosine decay from learning_rate to final_learning_rate.
double learning_rate_at(const TrainingParams& params, std::int64_t step);

}  // namespace fastscene::nn
