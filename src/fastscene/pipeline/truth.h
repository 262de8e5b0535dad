// Truth of a run: makes the room behind a run's prompt again and judges the run's splats by it.
#pragma once

#include <filesystem>

#include "fastscene/metrics/metrics.h"

namespace fastscene {

// Needs a finished run from a prompt. run.seed chooses the poses, not the room. Writes metrics/report.json (the section
// "truth"; sections of other radii are kept under "truth_by_radius") and metrics/truth/*.png; returns the report.
// Throws UsageError when the folder holds no finished run, or one whose panorama was the user's own picture.
Json measure_run(const std::filesystem::path& run_dir, const TruthParams& params, const Run& run);

}  // namespace fastscene
