// Sources in run.json: kind, file paths, and content hashes that identify them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/pipeline/source_files.h"

namespace fastscene {

// A source's fields as in run.json, with absolute paths. Parsing throws Json::exception for invalid input.
Json json_of_source(const SceneSource& source);
SceneSource source_from_json(const Json& run);

// Hash of the prompt, or of the contents of the picture and all files that belong to it.
std::string identity_of(const SceneSource& source, SourceFiles& files);
// Hashes of the input files, by their names in run.json.
Json contents_of(const SceneSource& source, SourceFiles& files);
// For display: source and seed recorded in a run.json, and which files differ from those of `other`.
std::string describe(const Json& run, const Json& other);

// If input files (picture, range map, further panoramas) have been deleted since the run started, returns run.json's
// entry: finished stages were made from them, and the run can continue. Empty if all files exist or the record is of
// other files.
struct GoneSource {
    Json record;
    std::filesystem::path file;  // the first missing one
};
std::optional<GoneSource> gone_source(const RunFolder& folder, const SceneSource& source, SourceFiles& files);

}  // namespace fastscene
