// Adam (Kingma and Ba 2015) with PyTorch's arithmetic, its memory open to be saved. Private to nn/ (torch).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {

struct AdamSettings {
    double learning_rate = 1e-4, beta1 = 0.5, beta2 = 0.999, eps = 1e-8;
};

class Adam {
  public:
    Adam(NamedTensors parameters, AdamSettings settings);
    // One step along the gradients that the parameters hold; those without one stay.
    void step();
    void forget_gradients();
    const NamedTensors& parameters() const { return parameters_; }
    // Averages of gradients and of their squares: "<parameter>.mean", "<parameter>.square". Share memory with the
    // optimizer.
    NamedTensors memory() const;
    std::int64_t steps = 0;
    AdamSettings settings;

  private:
    NamedTensors parameters_;
    std::vector<at::Tensor> mean_, square_;
};

}  // namespace fastscene::nn
