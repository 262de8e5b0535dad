// Truth of a run: makes the room behind a run's prompt again and judges the run's splats by it.
#pragma once

#include <filesystem>
#include <memory>

#include "fastscene/metrics/metrics.h"

namespace fastscene {

// The room behind a finished run from a prompt, as its panorama was shot. Its light is gathered once, and only when a
// picture asks for it. Throws UsageError when the folder holds no finished run, or one whose panorama was the user's
// own picture.
class RunTruth {
  public:
    // True pictures are kept in `kept`, by what they hang on, so that splats are judged again, and other walks through
    // the same room, without tracing anything; empty: in the run's metrics/.
    RunTruth(const std::filesystem::path& run_dir, std::filesystem::path kept, const Run& run);
    ~RunTruth();

    // run.seed (of the constructor) chooses the poses, not the room. Writes metrics/report.json (the section "truth";
    // the last sections of each kind are kept under "truth_of_room" and "truth_by_radius") and metrics/truth/*.png;
    // returns the report. `splats` (not empty) are judged instead of the run's own; `out` (not empty) takes the place
    // of metrics/.
    Json measure(const TruthParams& params, const std::filesystem::path& splats = {},
                 const std::filesystem::path& out = {});

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// One measurement, kept in the run.
Json measure_run(const std::filesystem::path& run_dir, const TruthParams& params, const Run& run);

}  // namespace fastscene
