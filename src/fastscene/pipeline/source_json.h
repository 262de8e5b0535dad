// A source in run.json: what it is, where its files lie, and by which contents it is told from another.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/pipeline/source_files.h"

namespace fastscene {

// The fields of a source as run.json has them, files with their whole paths. Reading throws Json::exception for what is
// no source.
Json json_of_source(const SceneSource& source);
SceneSource source_from_json(const Json& run);

// Hash of the prompt, or of the contents of the picture and of all that belongs to it.
std::string identity_of(const SceneSource& source, SourceFiles& files);
// Hashes of the files that a run is made from, by their names in run.json.
Json contents_of(const SceneSource& source, SourceFiles& files);
// For people: what run.json says of the source and the seed, and which of its files are others than those of `other`.
std::string describe(const Json& run, const Json& other);

// What run.json says of this source, when files that it was read from (the picture, its range map, further panoramas)
// are gone meanwhile: what is finished was made of them, and the run goes on from there. Nothing when all are there, or
// when the record is of other files.
struct GoneSource {
    Json record;
    std::filesystem::path file;  // the first that is gone
};
std::optional<GoneSource> gone_source(const RunFolder& folder, const SceneSource& source, SourceFiles& files);

}  // namespace fastscene
