// A batch as a Slurm job array. Slurm's own programs are asked (sbatch, squeue, sacct, scancel, scontrol); nothing is
// linked.
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

// Writes the manifest and the script folder/slurm/batch.sh, and submits it. Throws UsageError if the arguments cannot
// be of sbatch, Error with Slurm's own words if it is not there or refuses, or if tasks of the batch are still at work.
SlurmJob submit_to_slurm(const std::vector<BatchScene>& scenes, const std::filesystem::path& folder,
                         const BatchParams& params, const SlurmParams& slurm, const Run& run);

// States of the batch's tasks, and how many there are of each: {"source": "squeue", "sacct" or "files", "job", "tasks":
// {"RUNNING": 3}, "requeues", "reasons": {"Priority": 4}}. Reasons are Slurm's, why tasks wait. Nothing if the batch
// was never submitted.
std::optional<Json> slurm_status(const std::filesystem::path& folder);

// Whether the batch was ever submitted.
bool is_submitted(const std::filesystem::path& folder);

// Cancels what waits and what runs; returns how many tasks that were. Throws UsageError if the batch was never
// submitted, Error if Slurm does not answer.
int cancel_in_slurm(const std::filesystem::path& folder);

// Tasks of the batch that wait or run; nothing if Slurm cannot be asked.
std::optional<int> tasks_in_slurm(const std::filesystem::path& folder);

}  // namespace fastscene
