// Weight files as libtorch tensors. Private to nn/ (torch).
#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/base/error.h"
#include "fastscene/nn/scope.h"
#include "fastscene/weights/weights.h"

namespace fastscene::nn {

at::ScalarType scalar_type(NumberType type);
// Shares the file's (read-only) bytes if they are aligned, otherwise copies.
at::Tensor tensor_of(const WeightTensor& weight);
// A parameter where the network runs. To a graphics card goes what the file has, to be converted there; kernels of
// convolutions then lie channels last, as the card's matrix units take them.
at::Tensor placed(const at::Tensor& stored, const at::TensorOptions& options);
// For saving: in C order on the CPU. Shares memory if the tensor already is: later training changes both.
WeightTensor weight_of(const at::Tensor& tensor);

// A file as the parameters of a network written as functions (scope.h). Checks each key's shape when it is requested,
// and that it is numeric.
class LoadedWeights final : public WeightSource {
  public:
    LoadedWeights(Weights weights, at::TensorOptions options = at::kFloat)
        : weights_(std::move(weights)), options_(options) {}
    at::Tensor get(const std::string& key, at::IntArrayRef shape) override;
    bool has(const std::string& key) const override { return weights_.has(key); }
    const Weights& weights() const { return weights_; }

  private:
    Weights weights_;
    at::TensorOptions options_;
    std::unordered_map<std::string, at::Tensor> ready_;
};

// Shapes of a network's parameters by name.
using NamedShapes = std::map<std::string, std::vector<std::int64_t>>;
// Throws one Error that lists every missing key, every unexpected one (unless `extra_allowed`) and every mismatched
// shape, as far as fits in a message. `unused` may be there or not.
void check_fits(const NamedShapes& needed, const Weights& weights, const NamedShapes& unused = {},
                bool extra_allowed = false);

// Copies into a list of (name, tensor). Throws what check_fits throws.
using NamedTensors = std::vector<std::pair<std::string, at::Tensor>>;
void load_into(const NamedTensors& targets, const Weights& weights, bool extra_allowed = false);

// For networks written as torch::nn::Module: its parameters and buffers by their registered names.
template <class Module>
void load_into(Module& module, const Weights& weights, bool extra_allowed = false) {
    NamedTensors targets;
    for (const auto& item : module.named_parameters()) targets.emplace_back(item.key(), item.value());
    for (const auto& item : module.named_buffers()) targets.emplace_back(item.key(), item.value());
    load_into(targets, weights, extra_allowed);
}

}  // namespace fastscene::nn
