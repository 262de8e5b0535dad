// Fetches models and verifies them against the registry.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/models/cache.h"

namespace fastscene {

struct PullOptions {
    std::filesystem::path root = models_root();
    std::string mirror;   // a folder or URL that contains FOLDER/FILE; empty: each file's own URL
    bool accept = false;  // the user accepts the licence; remembered
    std::chrono::milliseconds first_wait{1000};
};
// $FASTSCENE_MODELS_MIRROR, or empty.
std::string default_mirror();

enum class FileState { fetched, here, recorded, missing, damaged };
std::string_view name_of(FileState state);

struct FileReport {
    std::string name;  // which alternative exists
    FileState state = FileState::missing;
    std::int64_t bytes = 0;
    std::string sha256;  // as computed
    // true: compared with the registry's hash; false: with the one recorded when the file was first seen
    bool known = false;
    std::string problem;  // for a damaged or missing file
};
struct ModelReport {
    std::string model;
    std::filesystem::path folder;
    std::vector<FileReport> files;
    bool whole() const;
};
Json to_json(const ModelReport& report);

// Each file is downloaded as NAME.part and renamed once its size and hash are verified; interrupted pulls resume.
// Existing files are verified (as in verify_model) and kept if valid; damaged ones are downloaded again and replaced
// once the new one is complete. Throws UsageError with the licence if it is not accepted; Error as `download` does, for
// a wrong hash (the data is discarded), for a model that must be fetched by hand, and if another pull of it is running.
// Throws Stopped.
ModelReport pull_model(const Model& model, const PullOptions& options, const Run& run);

// Hashes every file and compares it with the registry, or with the hash recorded when it was first seen, or else
// records it.
ModelReport verify_model(const Model& model, const std::filesystem::path& root, const Run& run);

// Whether this model's licence has been accepted.
bool is_accepted(const Model& model, const std::filesystem::path& root = models_root());

}  // namespace fastscene
