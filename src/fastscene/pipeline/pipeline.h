// The whole stream: a sentence becomes a scene in a run folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/pipeline/quality.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/source.h"

namespace fastscene {

struct SceneRequest {
    SceneSource source;
    std::string quality = "standard";  // which preset the params started from; for the record only
    SceneParams params;
    std::string last_stage = "splat";  // go no further than this stage
    bool start_over = false;           // the folder may hold another prompt's run: throw that away
};

// Makes every stage up to the last one that is not there yet, then what people look at (share.h), report.json at the
// end; returns the report. run.seed is the scene's seed.
// Throws UsageError for a prompt that is none, a picture without a range map, a setting out of bounds, or a folder that
// holds something else; Error when a file or the disk is wrong; Stopped on request. Finished stages stay in any case.
Json make_scene(const SceneRequest& request, const RunFolder& folder, const Run& run);

// The request that run.json records, with its seed; for verbs that go on with a folder. Throws UsageError when the
// folder holds no run.
struct RecordedRun {
    SceneRequest request;
    std::uint64_t seed = 0;
};
RecordedRun recorded_run(const RunFolder& folder);

}  // namespace fastscene
