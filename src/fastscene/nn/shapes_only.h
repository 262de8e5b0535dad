// Weights that provide names and shapes only: traversing a network with minimal input checks it against its file before
// computing. Private to nn/ (torch).
#pragma once

#include <set>
#include <string>

#include "fastscene/nn/file_weights.h"

namespace fastscene::nn {

// Returns zeros that take no memory. `get` throws what the file's would.
class ShapesOnly final : public WeightSource {
  public:
    explicit ShapesOnly(const FileWeights& file) : file_(file) {}
    at::Tensor get(const std::string& key, at::IntArrayRef shape) override {
        file_.check(key, shape);
        asked_.insert(key);
        return at::zeros({}, at::kFloat).expand(shape);
    }
    bool has(const std::string& key) const override { return file_.has(key); }
    // Throws Error if the file has layers below one of `parts` ("up_blocks.") that were not requested: the
    // configuration does not match the file.
    void expect_all_of(const std::vector<std::string>& parts) const { file_.expect_none_beyond(asked_, parts); }

  private:
    const FileWeights& file_;
    std::set<std::string> asked_;
};

}  // namespace fastscene::nn
