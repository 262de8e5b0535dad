// The state of training in progress: the contents of a checkpoint.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fastscene/splat/splat.h"
#include "fastscene/splat/engine.h"

namespace fastscene::splat {

struct TrainState {
    int step = 0;  // steps taken
    Cloud cloud;
    double loss_sum = 0, squared_error_sum = 0;  // since the last point of the curve
    int sum_steps = 0;
    std::vector<CurvePoint> curve;
    std::vector<EvalPoint> evals;
};

// A checkpoint belongs to one machine and one set of settings, identified by `key`: raw numbers followed by a hash.
void save_checkpoint(const std::string& file, TrainState& state,
                     std::string_view key);  // not const: the same traversal serves reading and writing
// Whether the file's header matches this key.
bool has_checkpoint_key(const std::string& file, std::string_view key);
// Throws Error naming `file` if it is damaged or belongs to another key.
TrainState load_checkpoint(const std::string& file, std::string_view key);

}  // namespace fastscene::splat
