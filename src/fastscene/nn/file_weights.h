// Weights from a Hugging Face folder: one file, or several shards with an index. Private to nn/ (torch).
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <unordered_map>
#include <vector>

#include "fastscene/nn/scope.h"
#include "fastscene/weights/weights.h"

namespace fastscene::nn {

class FileWeights final : public WeightSource {
  public:
    // `component`: a file, or a folder such as unet/, in which the names used by diffusers and transformers are tried:
    // diffusion_pytorch_model, model, pytorch_model, as .safetensors or .bin, whole or sharded, also of variant fp16.
    // Safetensors are memory-mapped: tensors are loaded on first use. Throws Error naming the folder or file, expected
    // and actual. `keep`: cache converted parameters; otherwise each lives only while in use, so that memory holds one
    // layer instead of the network. `expected`: a tensor that must exist; if it is inside a dictionary (state_dict …),
    // that is unwrapped (weights.h).
    FileWeights(const std::filesystem::path& component, at::TensorOptions options, bool keep = true,
                std::string_view expected = "");

    at::Tensor get(const std::string& key, at::IntArrayRef shape) override;
    bool has(const std::string& key) const override { return find(key) != nullptr; }
    // Throws what get() would throw, without reading the tensor.
    void check(const std::string& key, at::IntArrayRef shape) const { checked(key, shape); }
    // Throws Error naming tensors whose names begin with one of `parts` and that are not in `asked`.
    void expect_none_beyond(const std::set<std::string>& asked, const std::vector<std::string>& parts) const;
    // The shape in the file; empty if there is no such tensor.
    std::vector<std::int64_t> shape_of(const std::string& key) const;
    const std::filesystem::path& path() const { return component_; }
    std::vector<std::filesystem::path> files() const;
    // Total bytes of all parameters in the network's number type.
    std::int64_t bytes() const;
    at::ScalarType type() const { return c10::typeMetaToScalarType(options_.dtype()); }
    std::int64_t dtype_bytes() const { return static_cast<std::int64_t>(options_.dtype().itemsize()); }
    // The same parameters as another number type.
    std::unique_ptr<FileWeights> in_type(at::ScalarType type) const;
    // Drops the cache of converted parameters.
    void release() { ready_.clear(); }
    std::int64_t kept_bytes() const;
    // Bytes of the largest parameter, in the network's number type.
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
