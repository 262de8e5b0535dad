// Training: the loop around a step. Curves, looks at held-out pictures, checkpoints, going on exactly where it stopped.
//
//     Learner net("network", start_he(run.seed), device, [&](const Scope& s) { … }, {…});
//     TrainingTask task{.learners = {&net}, .draw = …, .step = …, .look = …};
//     train(task, params, folder, run);
//
// What a step does is the task's; where the time goes, what is written and when it ends is told here once. Private to
// nn/ (torch).
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
using Numbers = std::vector<std::pair<std::string, double>>;  // by name, always the same names in the same order

struct Evaluation {
    Numbers held_out;  // figures of pictures that are never trained on
    ImageRgb8 sheet;   // what they look like; may be empty
};

struct TrainingTask {
    std::vector<Learner*> learners;
    // Examples of a step. Runs on another thread while the step before is computed; depends on the rng only.
    std::function<Batch(Random& rng)> draw;
    // Losses, backward(), Learner::update(learning_rate).
    std::function<Numbers(const Batch& batch, std::int64_t step, double learning_rate)> step;
    std::function<Evaluation()> evaluate;  // with the learners' averages
    Json settings;  // what else must be equal for a checkpoint to be gone on with: data, sizes, losses
};

struct TrainingOutcome {
    std::int64_t steps = 0;  // done in all
    bool finished = false;   // false: the minutes ran out first
    Numbers held_out;        // of the last look
};

// Works in `folder`: checkpoint.safetensors, training.json, curves.csv, curve-NAME.svg, sheets/. When a checkpoint is
// there it goes on from it, to the same numbers as without the break (on one machine with one number of threads). A
// checkpoint is written under another name and renamed: a full disk leaves the last one. Throws UsageError when the
// folder's training has other settings, Error when a file cannot be written, Stopped after a last checkpoint.
TrainingOutcome train(const TrainingTask& task, const TrainingParams& params, const std::filesystem::path& folder,
                      const Run& run);

// Adam's rate at a step: warm-up, then half a cosine from rate to final_learning_rate.
double learning_rate_at(const TrainingParams& params, std::int64_t step);

}  // namespace fastscene::nn
