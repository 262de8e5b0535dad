// Whether a run's pictures and splats are sound: `health` in report.json.
#pragma once

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene {

// Looks at the panorama, its range, some pictures of the walk and views, and at the splats from where the panoramas are
// (photographs: from the first glance). Returns {"ok", "problems": ["FILE: what is wrong" …], "looked_at", "splats":
// {"transparent" …}}, and warns of each problem. Files that are missing are not looked at; those that cannot be read
// are a problem.
Json check_health(const RunFolder& folder, const Run& run);

}  // namespace fastscene
