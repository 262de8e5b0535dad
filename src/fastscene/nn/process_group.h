// ProcessGroup: processes that train one network together (data-parallel: Goyal et al. 2017). Each computes the
// gradients of its own examples, all take their mean, so that all networks stay the same; the first keeps the folder.
// Through libtorch's Gloo, over TCP. Private to nn/ (torch).
#pragma once

#include <memory>
#include <vector>

#include "fastscene/nn/training_params.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {

class ProcessGroup {
  public:
    // Nothing when params.processes is 1. Otherwise waits until all have come to params.meet. Throws UsageError for a
    // place that is none or a process beyond the last, Error when the others do not come within `patience_s`.
    static std::unique_ptr<ProcessGroup> meet(const TrainingParams& params, double patience_s = 600);
    ~ProcessGroup();

    int size() const { return size_; }
    int process() const { return process_; }
    // Every process calls these in the same order with tensors of the same shapes. They throw Error when another
    // process is gone.
    void mean(const std::vector<at::Tensor>& tensors) const;        // in place
    void from_first(const std::vector<at::Tensor>& tensors) const;  // in place: what the first process has
    std::int64_t from_first(std::int64_t number) const;

  private:
    struct Connection;
    ProcessGroup(std::unique_ptr<Connection> group, int size, int process);
    std::unique_ptr<Connection> group_;
    int size_, process_;
};

}  // namespace fastscene::nn
