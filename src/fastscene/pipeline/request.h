// The request of make_scene, and its form in run.json.
#pragma once

#include <optional>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/pipeline/quality.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/pipeline/source_json.h"

namespace fastscene {

struct SceneRequest {
    SceneSource source;
    std::string quality = "standard";  // the preset that the params started from; only recorded
    SceneParams params;
    std::string last_stage = "splat";  // stop after this stage
    bool start_over = false;           // delete another source's run in the folder
};

// run.json; for a source whose files are gone, the recorded entry is kept.
Json json_of_request(const SceneRequest& request, std::uint64_t seed, SourceFiles& files,
                     const std::optional<GoneSource>& gone);

// The request recorded in run.json, with its seed; for commands that continue a folder. Throws UsageError if the folder
// holds no run.
struct RecordedRun {
    SceneRequest request;
    std::uint64_t seed = 0;
};
RecordedRun recorded_run(const RunFolder& folder);

}  // namespace fastscene
