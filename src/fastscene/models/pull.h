// Models brought to this machine and held against what is known of them.
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
    std::string mirror;   // a folder or an address that has FOLDER/FILE; empty: each file's own address
    bool accept = false;  // the licence was read and is accepted; remembered
    std::chrono::milliseconds first_wait{1000};
};
// $FASTSCENE_MODELS_MIRROR, or nothing.
std::string default_mirror();

enum class FileState { fetched, here, recorded, missing, damaged };
std::string_view name_of(FileState state);

struct FileReport {
    std::string name;  // the alternative that is there
    FileState state = FileState::missing;
    std::int64_t bytes = 0;
    std::string sha256;   // found
    bool known = false;   // the registry knew the hash; else it is the one recorded when the file was first seen
    std::string problem;  // of a damaged or missing file
};
struct ModelReport {
    std::string model;
    std::filesystem::path folder;
    std::vector<FileReport> files;
    bool whole() const;
};
Json to_json(const ModelReport& report);

// Each file goes to NAME.part and gets its name when its size and hash are right; an interrupted pull goes on where it
// was. What is there already is read again and stays when it is whole (as verify_model judges); what is damaged is
// fetched again, and gives way when the new one has come. Throws UsageError while the licence is not accepted, with the
// licence; Error for what `download` throws, for a wrong hash (the bytes are thrown away), for a model that can only be
// fetched by hand, and when another pull works on it. Throws Stopped.
ModelReport pull_model(const Model& model, const PullOptions& options, const Run& run);

// Reads every file and holds it against the registry, else against what was recorded when it was first seen, else
// records it.
ModelReport verify_model(const Model& model, const std::filesystem::path& root, const Run& run);

// Does this model's licence still have to be accepted?
bool is_accepted(const Model& model, const std::filesystem::path& root = models_root());

}  // namespace fastscene
