// Caching and resuming: a stage is made in a temporary directory next to the final one, which it then replaces
// atomically; its stage.json records inputs and outputs. A stage with an unchanged key and complete files is skipped.
// So a run killed at any moment resumes after its last finished stage, and a full disk never destroys existing results.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"

namespace fastscene {

// Resources used by a piece of work in this process.
struct Cost {
    double seconds = 0, cpu_seconds = 0;
    std::int64_t peak_memory_bytes = 0;  // peak resident memory during the work
};
Cost measure_cost(const std::function<void()>& work);

struct StageRecord {
    std::string name;
    std::string result;    // hash of all its files; enters the next stage's key
    Cost cost;             // of making it, possibly in an earlier process
    bool skipped = false;  // already existed
};

// Hash of everything that a stage's files depend on.
std::string stage_key(std::string_view stage, const Json& params, const std::vector<std::string>& inputs,
                      std::uint64_t seed);

// Calls `make` to write the stage's files into the directory it is given, unless `root`/`name` already exists with this
// key. Throws what `make` throws; then the disk is unchanged.
StageRecord run_stage(const std::filesystem::path& root, std::string_view name, const std::string& key, const Run& run,
                      const std::function<void(const std::filesystem::path& directory)>& make);

// The record of a finished stage, if all its files exist.
std::optional<StageRecord> finished_stage(const std::filesystem::path& root, std::string_view name);

}  // namespace fastscene
