// ProcessGroup: data-parallel training of one network by several processes (Goyal et al. 2017). Each computes the
// gradients of its own examples, and all average them, so the networks stay identical; process 0 writes the folder.
// Uses libtorch's Gloo backend over TCP. Private to nn/ (torch).
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/nn/training_params.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {

// Another process is gone; the others can meet again.
struct ProcessLost : Error {
    using Error::Error;
};

// What being several has cost this process.
struct GroupCosts {
    double waiting_s = 0;    // until all had come as far
    double averaging_s = 0;  // of gradients, once all were there
    std::int64_t bytes = 0;  // of gradients
};

class ProcessGroup {
  public:
    // Returns null if params.processes is 1. Otherwise waits until all processes have joined at params.meet. Throws
    // UsageError for an invalid address or process index, Error if the others do not join within `patience_s`, Stopped.
    static std::unique_ptr<ProcessGroup> meet(const TrainingParams& params, const Run& run, double patience_s = 600);
    ~ProcessGroup();

    int size() const { return static_cast<int>(members_.size()); }
    int rank() const { return rank_; }  // 0 is process 0
    // The processes that take part, in increasing order.
    const std::vector<int>& members() const { return members_; }
    // Collectives: every process must call them in the same order with tensors of the same shapes. They throw
    // ProcessLost if another process is gone; then nothing but meet_again() can be called.
    void mean(const std::vector<at::Tensor>& tensors);  // averages in place (all-reduce)
    // overwrites with the first process's values (broadcast)
    void from_first(const std::vector<at::Tensor>& tensors);
    std::int64_t from_first(std::int64_t number);

    // Process 0: whether one that was lost, or started anew, wants to take part. All must meet again for that.
    bool has_newcomer();
    // A group of those who come. Process 0 waits at most `patience_s` for those who took part. Throws Error if process
    // 0 is gone, Stopped.
    void meet_again(const Run& run, double patience_s);

    GroupCosts take_costs() { return std::exchange(costs_, {}); }  // since the last call

  private:
    struct Connection;
    ProcessGroup();
    std::unique_ptr<Connection> connection_;
    std::vector<int> members_;
    int rank_ = 0;
    GroupCosts costs_;
};

}  // namespace fastscene::nn
