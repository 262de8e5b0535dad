#include <ATen/Parallel.h>
#include <torch/csrc/autograd/custom_function.h>

#include <algorithm>

#include "fastscene/nn/lanes.h"
#include "fastscene/nn/layers.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

// libtorch 1.13 leaves memory as it found it where the gradient of its GELU arrives in another layout than the input had (tokens cut
// from a picture and back): so it arrives in the same one.
class Gelu : public torch::autograd::Function<Gelu> {
  public:
    static Tensor forward(torch::autograd::AutogradContext* context, const Tensor& x) {
        const Tensor dense = x.contiguous(x.suggest_memory_format());
        context->save_for_backward({dense});
        return at::gelu(dense);
    }
    static torch::autograd::tensor_list backward(torch::autograd::AutogradContext* context, torch::autograd::tensor_list gradients) {
        const Tensor x = context->get_saved_variables()[0];
        return {at::gelu_backward(gradients[0].contiguous(x.suggest_memory_format()), x)};
    }
};

constexpr float kQuick = 1.702f;
constexpr std::int64_t kGeluGrain = 1 << 15;

Lanes quick_gelu_of(Lanes x) {
    const Lanes t = x * all(kQuick), e = exp_of(t > Lanes{} ? -t : t), above = t > Lanes{} ? all(1.f) : e;   // of the side where e^t is at most 1
    return x * above / (all(1.f) + e);
}

}  // namespace

Tensor exact_gelu(const Tensor& x) { return x.requires_grad() && at::GradMode::is_enabled() ? Gelu::apply(x) : at::gelu(x); }

// One sweep: a perceptron's inner layer is the largest thing in a network, and each temporary of its size would come from the system, cleared,
// in every layer.
Tensor quick_gelu(Tensor x) {
    const bool alone = x.use_count() == 1 && x.storage().use_count() == 1;
    if (!alone || at::GradMode::is_enabled() || !x.device().is_cpu() || x.scalar_type() != at::kFloat || !x.is_contiguous()) return x * at::sigmoid(kQuick * x);
    float* const numbers = x.data_ptr<float>();
    at::parallel_for(0, x.numel(), kGeluGrain, [numbers](std::int64_t i, std::int64_t end) {
        for (; i + kLanes <= end; i += kLanes) store(numbers + i, quick_gelu_of(load(numbers + i)));
        float rest[kLanes] = {};
        std::copy(numbers + i, numbers + end, rest);
        store(rest, quick_gelu_of(load(rest)));
        std::copy_n(rest, end - i, numbers + i);
    });
    return x;
}

}  // namespace fastscene::nn
