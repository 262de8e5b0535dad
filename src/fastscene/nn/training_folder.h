// The folder of a training: its checkpoint and its settings. Private to nn/training.cc.
#pragma once

#include <cstdint>
#include <filesystem>

#include "fastscene/base/run.h"
#include "fastscene/nn/training.h"

namespace fastscene::nn {

// The state of all learners.
NamedTensors whole_state(const TrainingTask& task);

std::filesystem::path checkpoint_of(const std::filesystem::path& folder);
void save_checkpoint(const TrainingTask& task, std::int64_t step, const std::filesystem::path& folder);
// Returns the number of steps done; 0 in a new folder.
std::int64_t load_checkpoint(const TrainingTask& task, const std::filesystem::path& folder);

// Records the settings in a new folder, or checks them against an existing one. Throws UsageError if they differ.
void settle_settings(const TrainingTask& task, const TrainingParams& params, const std::filesystem::path& folder,
                     const Run& run);

}  // namespace fastscene::nn
