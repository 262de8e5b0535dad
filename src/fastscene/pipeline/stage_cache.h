// Resume: a stage is made in a directory of its own beside the final one, which it then replaces as a
// whole; stage.json in it says from what it was made and what came out. A stage whose key is the same and
// whose files are all there is skipped. So a run killed at any moment goes on from its last finished
// stage, and a full disk never costs what was there before.
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

// What a piece of work cost this process.
struct Cost {
    double seconds = 0, cpu_seconds = 0;
    std::int64_t peak_memory_bytes = 0;  // resident, the most at any moment of the work
};
Cost measure_cost(const std::function<void()>& work);

struct StageRecord {
    std::string name;
    std::string result;    // hash of all its files: the input of the next stage's key
    Cost cost;             // of the making, also when it was made by an earlier process
    bool skipped = false;  // it was there already
};

// Hash of everything that a stage's files depend on.
std::string stage_key(std::string_view stage, const Json& params, const std::vector<std::string>& inputs,
                      std::uint64_t seed);

// Has `make` write the stage's files into the directory it is given, unless `root`/`name` is already there
// with this key. Throws what `make` throws; then nothing has changed on disk.
StageRecord run_stage(const std::filesystem::path& root, std::string_view name, const std::string& key, const Run& run,
                      const std::function<void(const std::filesystem::path& directory)>& make);

// The record of a finished stage, if it is there with all its files.
std::optional<StageRecord> finished_stage(const std::filesystem::path& root, std::string_view name);

}  // namespace fastscene
