// The names and shapes of a network's parameters, by traversing it with minimal input. Private to nn/ (torch).
#pragma once

#include <string>

#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {

// Has every parameter that is requested, as zeros that take no memory, and remembers it.
class ShapeList final : public WeightSource {
  public:
    at::Tensor get(const std::string& key, at::IntArrayRef shape) override {
        shapes_[key] = shape.vec();
        return at::zeros({}, at::kFloat).expand(shape);
    }
    bool has(const std::string&) const override { return true; }
    const NamedShapes& shapes() const { return shapes_; }

  private:
    NamedShapes shapes_;
};

}  // namespace fastscene::nn
