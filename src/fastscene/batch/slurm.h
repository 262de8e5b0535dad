// A batch as a Slurm job array. Calls Slurm's programs (sbatch, squeue, sacct, scancel, scontrol); links no
// library.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/batch/batch.h"

namespace fastscene {

struct SlurmParams {
    std::string arguments;    // of sbatch, as a user writes them
    std::string scratch;      // of the nodes; the shell there replaces variables
    int chunk_scenes = 0;     // of a task; 0: as few as the array allows
    int tasks_at_a_time = 0;  // 0: no limit
};

struct SlurmJob {
    std::string id;  // empty: nothing was left to do
    int scenes = 0, tasks = 0;
};

// Writes the manifest and the script folder/slurm/batch.sh, and submits it. Throws UsageError if the arguments are
// not flags of sbatch; Error, with Slurm's message, if it is missing or refuses, or if tasks of the batch are active.
SlurmJob submit_to_slurm(const std::vector<BatchScene>& scenes, const std::filesystem::path& folder,
                         const BatchParams& params, const SlurmParams& slurm, const Run& run);

// States of the batch's tasks, and how many there are of each: {"source": "squeue", "sacct" or "files", "job", "tasks":
// {"RUNNING": 3}, "requeues", "reasons": {"Priority": 4}}. Reasons are Slurm's, why tasks wait. Nothing if the batch
// was never submitted.
std::optional<Json> slurm_status(const std::filesystem::path& folder);

// Whether the batch was ever submitted.
bool is_submitted(const std::filesystem::path& folder);

// Cancels pending and running tasks; returns their number. Throws UsageError if the batch was never
// submitted, Error if Slurm does not answer.
int cancel_in_slurm(const std::filesystem::path& folder);

// Number of pending and running tasks of the batch; nothing if Slurm does not answer.
std::optional<int> tasks_in_slurm(const std::filesystem::path& folder);

}  // namespace fastscene
