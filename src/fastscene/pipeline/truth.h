// Evaluates a run against ground truth: recreates its room from the prompt and compares the splats with it.
#pragma once

#include <filesystem>
#include <memory>

#include "fastscene/metrics/metrics.h"

namespace fastscene {

// The room of a finished run from a prompt, with its panorama's render settings. Its light is gathered once, on demand.
// Throws UsageError if the folder holds no finished run, or one from a user's picture.
class RunTruth {
  public:
    // Ground truth is cached in `kept` by its inputs, so that splats, also those of other walks through the same room,
    // can be evaluated again without rendering; empty: in the run's metrics/.
    RunTruth(const std::filesystem::path& run_dir, std::filesystem::path kept, const Run& run);
    ~RunTruth();

    // run.seed (of the constructor) selects the poses, not the room. Writes metrics/report.json (the section "truth";
    // the latest of each kind is kept under "truth_of_room" and "truth_by_radius") and metrics/truth/*.png; returns the
    // report. `splats` (if not empty) are evaluated instead of the run's own; `out` (if not empty) replaces metrics/.
    Json measure(const TruthParams& params, const std::filesystem::path& splats = {},
                 const std::filesystem::path& out = {}, const SplatBackend& backend = {});

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// A single measurement, stored in the run.
Json measure_run(const std::filesystem::path& run_dir, const TruthParams& params, const Run& run,
                 const SplatBackend& backend = {});

}  // namespace fastscene
