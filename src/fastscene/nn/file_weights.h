// Weights from a folder as Hugging Face's libraries save them: one file, or several parts with an index. Private to nn/
// (torch).
#pragma once

#include <filesystem>
#include <set>
#include <unordered_map>
#include <vector>

#include "fastscene/nn/scope.h"
#include "fastscene/nn/weights.h"

namespace fastscene::nn {

class FileWeights final : public WeightSource {
  public:
    // `component`: a file, or a folder such as unet/. In a folder the names of diffusers and transformers are tried:
    // diffusion_pytorch_model, model, pytorch_model, as .safetensors or .bin, whole or in parts, also of variant fp16.
    // Safetensors are mapped: a tensor costs memory when it is first asked for. Throws Error naming the folder or file,
    // what was expected and what was found. `keep`: what was converted stays; else a parameter lives only as long as it
    // is used, and memory holds one layer instead of a network. `expected`: a tensor that must be there; where it lies
    // within a dictionary (state_dict …), that is opened (unwrapped, weights.h).
    FileWeights(const std::filesystem::path& component, at::TensorOptions options, bool keep = true,
                std::string_view expected = "");

    at::Tensor get(const std::string& key, at::IntArrayRef shape) override;
    bool has(const std::string& key) const override { return find(key) != nullptr; }
    // Throws what get would throw, without reading.
    void check(const std::string& key, at::IntArrayRef shape) const { checked(key, shape); }
    // Throws Error naming tensors whose names begin with one of `parts` and are not among `asked`.
    void expect_none_beyond(const std::set<std::string>& asked, const std::vector<std::string>& parts) const;
    // The shape in the file, empty when there is no such tensor.
    std::vector<std::int64_t> shape_of(const std::string& key) const;
    const std::filesystem::path& path() const { return component_; }
    std::vector<std::filesystem::path> files() const;
    // Bytes of all parameters in the network's number type.
    std::int64_t bytes() const;
    std::int64_t dtype_bytes() const { return static_cast<std::int64_t>(options_.dtype().itemsize()); }
    // Forgets what was converted; it is read again when asked for.
    void release() { ready_.clear(); }
    std::int64_t kept_bytes() const;
    // Of the largest parameter, in the network's number type.
    std::int64_t largest_bytes() const;

  private:
    const WeightTensor* find(const std::string& key) const;
    const WeightTensor& checked(const std::string& key, at::IntArrayRef shape) const;

    std::filesystem::path component_;
    at::TensorOptions options_;
    bool keep_;
    std::vector<Weights> parts_;
    std::unordered_map<std::string, at::Tensor> ready_;
};

}  // namespace fastscene::nn
