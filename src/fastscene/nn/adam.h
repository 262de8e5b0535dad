// Adam (Kingma and Ba 2015) with PyTorch's arithmetic, whose state can be saved. Private to nn/ (torch).
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
    // One step with the parameters' gradients; parameters without a gradient stay unchanged.
    void step();
    void forget_gradients();
    const NamedTensors& parameters() const { return parameters_; }
    // First and second moments: "<parameter>.mean", "<parameter>.square". Tensors share memory with the optimizer.
    NamedTensors memory() const;
    std::int64_t steps = 0;
    AdamSettings settings;

  private:
    NamedTensors parameters_;
    std::vector<at::Tensor> mean_, square_;
};

}  // namespace fastscene::nn
