// The whole stream: a sentence becomes a scene in a run folder.
#pragma once

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/pipeline/request.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene {

// Makes every stage up to the last one that is not there yet, then what people look at (share.h), report.json at the
// end; returns the report. run.seed is the scene's seed.
// Throws UsageError for a prompt that is none, a setting out of bounds, or a folder that
// holds something else; Error when a file or the disk is wrong; Stopped on request. Finished stages stay in any case.
Json make_scene(const SceneRequest& request, const RunFolder& folder, const Run& run);

}  // namespace fastscene
