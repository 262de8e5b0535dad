// Batch: many scenes, each made by its own process. One that fails does not affect the others; a stopped batch resumes
// with what is left.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/batch/journal.h"
#include "fastscene/batch/scene_list.h"

namespace fastscene {

struct BatchParams {
    std::filesystem::path program;  // fastscene itself
    std::string stage = "make";     // the command that makes a scene: "make", or "panorama" for pictures alone
    std::string quality = "standard";
    std::vector<std::string> flags;  // of that command, for all scenes
    int jobs = 0;                    // scenes at a time; 0: as many as cores and memory allow
    int threads = 0;                 // of all scenes together; 0: all cores
    int tries = 2;                   // attempts per scene
    std::filesystem::path scratch;   // where scenes are made before they are moved to the batch; empty: in place
};

// Scenes at a time that cores and free memory allow.
int jobs_that_fit(const BatchParams& params);

// Makes the scenes in folders of their names below `folder`, each with a log file beside it (NAME.log). Those that
// folder/batch.jsonl lists as done are left alone. Writes folder/index.html. Throws Error if another batch works on the
// folder; Stopped when asked to stop, after the scenes in work have ended.
std::vector<BatchRecord> run_batch(const std::vector<BatchScene>& scenes, const std::filesystem::path& folder,
                                   const BatchParams& params, const Run& run);

// Makes the scenes of one chunk (manifest.h), as run_batch does, beside other processes that make others. Returns their
// records. `settings`: program, threads and scratch are taken from it.
std::vector<BatchRecord> run_chunk(const std::filesystem::path& folder, int number, const BatchParams& settings,
                                   const Run& run);

// Whether the journal knows that the scene was made with these settings.
bool is_done(const BatchScene& scene, const BatchParams& params, const BatchJournal& journal);

// The progress of a batch: done, failed, total (-1: unknown), seconds_a_scene, failures, and slurm for one that was
// submitted there (slurm.h). Updates the page of a batch made in chunks, if it may. Throws UsageError if `folder` is
// not a batch.
Json batch_status(const std::filesystem::path& folder);

}  // namespace fastscene
