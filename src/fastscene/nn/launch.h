// Launch: which of several processes this one is, as the launcher of all of them says. Free of libtorch.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "fastscene/nn/training_params.h"

namespace fastscene {

struct Launch {
    int processes = 1, process = 0;
    std::string meet;  // HOST:PORT of process 0
};

// Null for a variable that is not set.
using Environment = std::function<const char*(const char*)>;

// From RANK, WORLD_SIZE, MASTER_ADDR and MASTER_PORT, which Kubernetes' PyTorchJob and many scripts set, or from what
// srun sets. Nothing if this process was started alone. Throws UsageError if a variable is not what it should be.
std::optional<Launch> launch_from(const Environment& environment);

// Takes from the environment what the user did not say: everything, or only the address if `processes` is said.
void take_launch(TrainingParams& params, const Environment& environment);

// The first of Slurm's list of nodes: "gpu003" of "gpu[003-010,12],login1".
std::string first_node(const std::string& list);

}  // namespace fastscene
