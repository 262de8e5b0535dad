#include <ATen/Parallel.h>
#include <torch/csrc/autograd/custom_function.h>

#include <algorithm>

#include "fastscene/nn/lanes.h"
#include "fastscene/nn/layers.h"
#include "fastscene/nn/libtorch.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

constexpr std::int64_t kGeluGrain = 1 << 15;

// to[i] = of(a[i], b[i]); `b` may be `a`.
void sweep(const Tensor& a, const Tensor& b, const Tensor& to, const auto& of) {
    const float *x = a.data_ptr<float>(), *y = b.data_ptr<float>();
    float* out = to.data_ptr<float>();
    at::parallel_for(0, a.numel(), kGeluGrain, [&](std::int64_t i, std::int64_t end) {
        for (; i + kLanes <= end; i += kLanes) store(out + i, of(load(x + i), load(y + i)));
        float rest[2][kLanes] = {};
        std::copy(x + i, x + end, rest[0]);
        std::copy(y + i, y + end, rest[1]);
        store(rest[0], of(load(rest[0]), load(rest[1])));
        std::copy_n(rest[0], end - i, out + i);
    });
}

// The normal distribution: e^(-x^2 / 2), and the cumulative distribution (Abramowitz and Stegun 7.1.26, error at most
// 8e-8).
struct Normal {
    Lanes bell, below;
    explicit Normal(Lanes x) {
        const Lanes far = (x > Lanes{} ? x : -x) * all(0.70710678f), t = all(1.f) / (all(1.f) + all(0.3275911f) * far);
        bell = exp_of(-(far * far));
        const Lanes polynomial = all(0.254829592f) +
                                 t * (all(-0.284496736f) +
                                      t * (all(1.421413741f) + t * (all(-1.453152027f) + t * all(1.061405429f))));
        const Lanes beyond = all(0.5f) * bell * t * polynomial;
        below = x > Lanes{} ? all(1.f) - beyond : beyond;
    }
};

Tensor gelu_of(const Tensor& x) {
    if (!x.is_cpu() || x.scalar_type() != at::kFloat) return at::gelu(x);
    const Tensor out = at::empty_like(x);
    sweep(x, x, out, [](Lanes v, Lanes) { return v * Normal(v).below; });
    return out;
}
Tensor gelu_gradient(const Tensor& back, const Tensor& x) {
    if (!x.is_cpu() || x.scalar_type() != at::kFloat) return at::gelu_backward(back, x);
    const Tensor out = at::empty_like(x);
    sweep(back, x, out, [](Lanes b, Lanes v) {
        const Normal normal(v);
        return b * (normal.below + all(0.39894228f) * v * normal.bell);
    });
    return out;
}

Tensor dense(const Tensor& x) { return x.contiguous(x.suggest_memory_format()); }

// A GELU whose gradient is correct when it arrives in another memory layout than the input (tokens transposed from a
// picture); in that case libtorch 1.13 returns uninitialized memory.
class Gelu : public torch::autograd::Function<Gelu> {
  public:
    static Tensor forward(torch::autograd::AutogradContext* context, const Tensor& x) {
        const Tensor kept = dense(x);
        context->save_for_backward({kept});
        return gelu_of(kept);
    }
    static torch::autograd::tensor_list backward(torch::autograd::AutogradContext* context,
                                                 torch::autograd::tensor_list gradients) {
        const Tensor x = context->get_saved_variables()[0];
        return {gelu_gradient(gradients[0].contiguous(x.suggest_memory_format()), x)};
    }
};

constexpr float kQuick = 1.702f;

Lanes quick_gelu_of(Lanes x) {
    const Lanes t = x * all(kQuick), e = exp_of(t > Lanes{} ? -t : t),
                above = t > Lanes{} ? all(1.f) : e;  // the branch where e^t is at most 1
    return x * above / (all(1.f) + e);
}

}  // namespace

Tensor exact_gelu(const Tensor& x) {
    return x.requires_grad() && at::GradMode::is_enabled() ? Gelu::apply(x) : gelu_of(dense(x));
}

// Single pass and in place: an MLP's inner layer is the largest tensor of a network, and temporaries of that size would
// be allocated and zeroed by the system in every layer.
Tensor quick_gelu(Tensor x) {
    const bool alone = x.use_count() == 1 && x.storage().use_count() == 1;
    if (!alone || at::GradMode::is_enabled() || !x.device().is_cpu() || x.scalar_type() != at::kFloat ||
        !x.is_contiguous())
        return x * at::sigmoid(kQuick * x);
    sweep(x, x, x, [](Lanes v, Lanes) { return quick_gelu_of(v); });
    return x;
}

}  // namespace fastscene::nn
