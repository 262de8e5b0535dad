#include <torch/csrc/autograd/custom_function.h>

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

}  // namespace

Tensor exact_gelu(const Tensor& x) { return x.requires_grad() && at::GradMode::is_enabled() ? Gelu::apply(x) : at::gelu(x); }

}  // namespace fastscene::nn
