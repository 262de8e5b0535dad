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

// Another process is gone; the others can rejoin.
struct ProcessLost : Error {
    using Error::Error;
};

// What communication has cost this process.
struct GroupCosts {
    double waiting_s = 0;    // at barriers, for the slowest
    double averaging_s = 0;  // of gradients, after the barrier
    std::int64_t bytes = 0;  // of gradients
};

class ProcessGroup {
  public:
    // Returns null if params.processes is 1. Otherwise waits until all processes have joined at params.meet. Throws
    // UsageError for an invalid address or process index, Error if the others do not join within `timeout_s`, Stopped.
    static std::unique_ptr<ProcessGroup> join(const TrainingParams& params, const Run& run, double timeout_s = 600);
    ~ProcessGroup();

    int world_size() const { return static_cast<int>(members_.size()); }
    int rank() const { return rank_; }  // index in members(); process 0 has rank 0
    // The processes that take part, in increasing order.
    const std::vector<int>& members() const { return members_; }
    // Collectives: every process must call them in the same order with tensors of the same shapes. They throw
    // ProcessLost if another process is gone; then only rejoin() may be called.
    void all_reduce_mean(const std::vector<at::Tensor>& tensors);  // in place
    // The values of rank 0, in place.
    void broadcast(const std::vector<at::Tensor>& tensors);
    std::int64_t broadcast(std::int64_t number);

    // Process 0: whether a process that was lost, or restarted, waits to take part. All must rejoin for that.
    bool has_newcomer();
    // Forms a new group of those that rejoin. Process 0 waits at most `timeout_s` for the members. Throws Error if
    // process 0 is gone, Stopped.
    void rejoin(const Run& run, double timeout_s);

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
