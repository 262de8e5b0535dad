// Pseudo-random weights derived from parameter names: anyone can reproduce them, so that two programs can be compared
// layer by layer without exchanging files. Private to nn/ (torch).
#pragma once

#include <string>
#include <unordered_map>
#include <utility>

#include "fastscene/nn/scope.h"

namespace fastscene::nn {

// Element i of the stream `name`, in [-1, 1), exact in single precision.
float hashed_number(std::uint64_t name_hash, std::uint64_t index);
// A stream's numbers as a tensor, for test inputs.
at::Tensor hashed_input(const std::string& name, at::IntArrayRef shape);
// A parameter: matrices and kernels are uniform with variance 1 / fan-in, norm weights lie around 1, running variances
// in [1, 1.1], everything else in [-0.1, 0.1].
at::Tensor hashed_parameter(const std::string& key, at::IntArrayRef shape);

// Has every parameter that is requested.
class HashedWeights final : public WeightSource {
  public:
    // `salt`: gives different weights for the same names.
    explicit HashedWeights(at::TensorOptions options = at::kFloat, std::string salt = "")
        : options_(options), salt_(std::move(salt)) {}
    at::Tensor get(const std::string& key, at::IntArrayRef shape) override;
    bool has(const std::string&) const override { return true; }
    const std::unordered_map<std::string, at::Tensor>& seen() const { return seen_; }
    // Replaces a hashed tensor by a given one.
    void set(const std::string& key, const at::Tensor& value) { seen_[key] = value; }

  private:
    at::TensorOptions options_;
    std::string salt_;
    std::unordered_map<std::string, at::Tensor> seen_;
};

}  // namespace fastscene::nn
