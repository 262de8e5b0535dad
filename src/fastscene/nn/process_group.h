// ProcessGroup: data-parallel training of one network by several processes (Goyal et al. 2017). Each computes the
// gradients of its own examples, and all average them, so the networks stay identical; process 0 writes the folder.
// Uses libtorch's Gloo backend over TCP. Private to nn/ (torch).
#pragma once

#include <memory>
#include <vector>

#include "fastscene/nn/training_params.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {

class ProcessGroup {
  public:
    // Returns null if params.processes is 1. Otherwise waits until all processes have joined at params.meet. Throws
    // UsageError for an invalid address or process index, and Error if the others do not join within `patience_s`.
    static std::unique_ptr<ProcessGroup> meet(const TrainingParams& params, double patience_s = 600);
    ~ProcessGroup();

    int size() const { return size_; }
    int process() const { return process_; }
    // Collectives: every process must call them in the same order with tensors of the same shapes. They throw Error if
    // another process is gone.
    void mean(const std::vector<at::Tensor>& tensors) const;  // averages in place (all-reduce)
    // overwrites with the first process's values (broadcast)
    void from_first(const std::vector<at::Tensor>& tensors) const;
    std::int64_t from_first(std::int64_t number) const;

  private:
    struct Connection;
    ProcessGroup(std::unique_ptr<Connection> group, int size, int process);
    std::unique_ptr<Connection> group_;
    int size_, process_;
};

}  // namespace fastscene::nn
