// Evaluation: makes a suite's scenes (or uses existing runs), measures them, and tabulates them beside published
// figures and other systems' results.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/evaluate/suite.h"

namespace fastscene {

struct EvaluateOptions {
    std::filesystem::path out;
    std::filesystem::path weights;  // as for metrics_weights()
    int scenes = 0;                 // only the first n; 0: all
    std::vector<SuitePeer> peers;   // in addition to those of the suite
};

// Writes into options.out, updated after every scene, so that results can be viewed while it runs:
// results.json: everything below, as numbers; scenes/VARIANT/SCENE-SEED/: the runs, resumed and never made twice;
// report.html: a self-contained page; measured/…: pictures and scores, cached by content;
// table.md .csv .tex, scenes.csv.
// A failed scene is listed with its reason below the table, and the others continue. Returns results.json (format:
// docs/evaluate.md). Throws UsageError for a peer's folder without any of the suite's scenes, before anything is
// written; Stopped on request, keeping all finished work.
Json evaluate(const Suite& suite, const EvaluateOptions& options, const Run& run);

}  // namespace fastscene
