#include "fastscene/nn/aotgan_widen.h"

#include "fastscene/base/random.h"
#include "fastscene/nn/libtorch.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

// how far the weights of copies deviate from equal
constexpr float kUneven = 0.5f;

// Derives wide parameters from the narrow network's on request: running the wide generator determines which ones exist
// and their shapes. Special cases are only the layers that read concatenated channels (branches, skips).
class Wide final : public WeightSource {
  public:
    Wide(const Weights& narrow, const AotganShape& shape, std::int64_t times, std::uint64_t seed)
        : narrow_(narrow), shape_(shape), times_(times), seed_(seed) {}

    Tensor get(const std::string& key, at::IntArrayRef wanted) override {
        Tensor wide = narrow_.get(key, narrow_shape(key, wanted));
        if (wide.dim() == 4) wide = shared_among_copies(key, wide, wanted[1]);
        if (wide.size(0) != wanted[0]) {
            std::vector<std::int64_t> repeats(static_cast<std::size_t>(wide.dim()), 1);
            repeats[0] = times_;
            wide = wide.repeat(repeats);
        }
        made_.tensors[key] = weight_of(wide);
        return wide;
    }
    bool has(const std::string& key) const override { return narrow_.has(key); }
    Weights take() {
        made_.path = narrow_.weights().path;
        made_.metadata = narrow_.weights().metadata;
        return std::move(made_);
    }

  private:
    // The input picture, the mask and the output picture keep their channels; all others are multiplied by `times`.
    std::vector<std::int64_t> narrow_shape(const std::string& key, at::IntArrayRef wanted) const {
        std::vector<std::int64_t> out = wanted.vec();
        if (!key.starts_with("decoder.4.")) out[0] /= times_;
        if (out.size() == 4 && key != "encoder.1.weight") out[1] /= times_;
        return out;
    }
    // How many concatenated outputs a kernel reads.
    std::int64_t sources_of(const std::string& key) const {
        if (key.find(".fuse.") != std::string::npos) return static_cast<std::int64_t>(shape_.rates.size());
        return shape_.skips && (key == "decoder.2.conv.weight" || key == "decoder.4.weight") ? 2 : 1;
    }
    // [O, sources n, k, k] -> [O, sources times n, k, k]: each channel of each source is repeated `times` times.
    Tensor shared_among_copies(const std::string& key, const Tensor& kernel, std::int64_t inputs) const {
        if (kernel.size(1) == inputs) return kernel;
        const std::int64_t out = kernel.size(0), sources = sources_of(key), n = kernel.size(1) / sources,
                           k = kernel.size(2);
        Tensor shares = at::empty({out, sources, times_, n, 1, 1}, at::kFloat);
        Random rng(seed_, "widened " + key);
        float* share = shares.data_ptr<float>();
        for (std::int64_t i = 0; i < shares.numel(); ++i) share[i] = kUneven * rng.normal();
        shares = shares - shares.mean(2, true) + 1.0 / static_cast<double>(times_);
        return (kernel.reshape({out, sources, 1, n, k, k}) * shares).reshape({out, inputs, k, k});
    }

    LoadedWeights narrow_;
    AotganShape shape_;
    std::int64_t times_;
    std::uint64_t seed_;
    Weights made_;
};

}  // namespace

Weights widened(const Weights& narrow, const AotganShape& shape, std::int64_t times, std::uint64_t seed) {
    FASTSCENE_CHECK(times >= 1);
    const at::NoGradGuard no_gradients;
    Wide wide(narrow, shape, times, seed);
    AotganShape larger = shape;
    larger.width *= times;
    // A forward pass requests all parameters.
    (void)aotgan_generator(Scope(wide), larger, at::zeros({1, 3, 64, 64}), at::zeros({1, 1, 64, 64}));
    return wide.take();
}

}  // namespace fastscene::nn
