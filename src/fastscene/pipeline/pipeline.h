// The whole pipeline: from a prompt or picture to a scene in a run folder.
#pragma once

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/pipeline/request.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene {

// Makes all missing stages up to the last one requested, then viewer and preview (share.h), and finally report.json;
// returns the report. run.seed is the scene's seed. Throws UsageError for an empty prompt, a setting out of bounds, or
// a folder that holds something else; Error for file and disk problems; Stopped on request. Finished stages are kept in
// any case.
Json make_scene(const SceneRequest& request, const RunFolder& folder, const Run& run);

}  // namespace fastscene
