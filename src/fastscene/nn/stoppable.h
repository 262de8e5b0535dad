// Makes networks interruptible, and shows how far they are: a step on a large picture takes minutes, a layer seconds.
// Private to nn/ (torch).
#pragma once

#include "fastscene/base/run.h"
#include "fastscene/nn/scope.h"

namespace fastscene::nn {

// Forwards to another source, and throws Stopped on a parameter request if the run was asked to stop. `progress`, if
// any, advances by one with each parameter.
class StoppableWeights final : public WeightSource {
  public:
    StoppableWeights(WeightSource& weights, const Run& run, Progress* progress = nullptr)
        : weights_(weights), run_(run), progress_(progress) {}
    at::Tensor get(const std::string& key, at::IntArrayRef shape) override {
        run_.check_stop();
        if (progress_) progress_->advance();
        return weights_.get(key, shape);
    }
    bool has(const std::string& key) const override { return weights_.has(key); }

  private:
    WeightSource& weights_;
    const Run& run_;
    Progress* progress_;
};

}  // namespace fastscene::nn
