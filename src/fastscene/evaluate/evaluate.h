// Evaluate: a suite's scenes are made (or taken as they are, where the run folder has them), measured, and put into one
// table beside published figures and other systems' pictures.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/evaluate/suite.h"

namespace fastscene {

struct EvaluateOptions {
    std::filesystem::path out;
    std::filesystem::path weights;  // of metrics, as for metrics_weights()
    int scenes = 0;                 // only the first so many; 0: all
    std::vector<SuitePeer> peers;   // besides those of the suite
};

// Writes into options.out, anew after every scene, so that one may look while it goes on:
//   results.json  everything below, as numbers        scenes/VARIANT/SCENE-SEED/  the runs: resumed, never made twice
//   report.html   one page that stands alone          measured/…                  pictures and scores, kept by content
//   table.md .csv .tex, scenes.csv
// A scene that fails is named with its reason below the table, and the others go on. Returns results.json
// (docs/evaluate.md has its form). Throws UsageError for a peer's folder that holds nothing of the suite, before
// anything is written; Stopped on request; then all that was made stays.
Json evaluate(const Suite& suite, const EvaluateOptions& options, const Run& run);

}  // namespace fastscene
