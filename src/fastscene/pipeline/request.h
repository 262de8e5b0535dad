// What is asked of make_scene, and how run.json has it.
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
    std::string quality = "standard";  // which preset the params started from; for the record only
    SceneParams params;
    std::string last_stage = "splat";  // go no further than this stage
    bool start_over = false;           // the folder may hold another prompt's run: throw that away
};

// run.json; of a source that is gone it keeps what was recorded.
Json json_of_request(const SceneRequest& request, std::uint64_t seed, SourceFiles& files,
                     const std::optional<GoneSource>& gone);

// The request that run.json records, with its seed; for verbs that go on with a folder. Throws UsageError when the
// folder holds no run.
struct RecordedRun {
    SceneRequest request;
    std::uint64_t seed = 0;
};
RecordedRun recorded_run(const RunFolder& folder);

}  // namespace fastscene
