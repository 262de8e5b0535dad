// The same network again and again on a graphics card. A denoiser's step is some thousand launches of kernels, each
// shorter than its launch takes: recorded once as a CUDA graph, a step is a single launch. Private to nn/ (torch).
#pragma once

#include <ATen/core/Tensor.h>

#include <functional>
#include <memory>
#include <vector>

namespace fastscene::nn {

class Replay {
  public:
    Replay();
    ~Replay();
    Replay(Replay&&) noexcept;
    Replay& operator=(Replay&&) noexcept;

    using Net = std::function<at::Tensor(const std::vector<at::Tensor>&)>;
    // net(inputs). On a graphics card the first call with inputs of these shapes runs `net`, the second records it, and
    // later ones replay the record: `net` must do the same each time, without reading from the card. What is returned
    // then lies where the next call writes. Elsewhere, where recording fails, and with FASTSCENE_CUDA_GRAPHS=0: runs
    // `net`.
    at::Tensor operator()(const std::vector<at::Tensor>& inputs, const Net& net);

  private:
    struct Record;
    Record* record_for(const std::vector<at::Tensor>& inputs);
    bool fails_ = false;
    std::vector<std::unique_ptr<Record>> records_;
};

}  // namespace fastscene::nn
