// The first news of a training: until its first step is done there is no speed to extrapolate, and that step may take
// minutes. Private to nn/ (torch).
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "fastscene/nn/training.h"

namespace fastscene::nn {

// Notes how far the first evaluation and the first step are, and how long the training will take, from how far their
// passes through the network are. Until it is destroyed.
class TrainingBeginning {
  public:
    TrainingBeginning(const TrainingTask& task, const TrainingParams& params, std::int64_t steps_done, const Run& run);
    void first_step();  // the evaluation is done

  private:
    using Clock = std::chrono::steady_clock;
    void tell();
    double passes() const;

    const TrainingTask& task_;
    const TrainingParams& params_;
    const Run& run_;
    std::int64_t steps_to_do_;
    std::mutex mutex_;
    bool evaluates_ = true;
    Clock::time_point begin_ = Clock::now();
    double passes_before_ = 0;
    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace fastscene::nn
