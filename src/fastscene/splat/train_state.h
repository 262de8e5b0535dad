// Everything that training is in the middle of: what a checkpoint holds.
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
    double loss_sum = 0, squared_error_sum = 0;  // since the curve's last point
    int sum_steps = 0;
    std::vector<CurvePoint> curve;
    std::vector<EvalPoint> evals;
};

// A checkpoint is for one machine and one set of settings, named by `key`: raw numbers, sealed by a hash.
void save_checkpoint(const std::string& file, TrainState& state,
                     std::string_view key);  // not const: one walk over it serves both directions
// Whether the file begins as a checkpoint of this key does.
bool has_checkpoint_key(const std::string& file, std::string_view key);
// Throws Error naming `file` when its bytes are damaged or belong to another key.
TrainState load_checkpoint(const std::string& file, std::string_view key);

}  // namespace fastscene::splat
