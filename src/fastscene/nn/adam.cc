#include "fastscene/nn/adam.h"

#include <cmath>

#include "fastscene/nn/libtorch.h"

namespace fastscene::nn {

Adam::Adam(NamedTensors parameters, AdamSettings given) : settings(given), parameters_(std::move(parameters)) {
    const at::NoGradGuard no_gradients;
    for (const auto& [name, parameter] : parameters_) {
        mean_.push_back(at::zeros_like(parameter));
        square_.push_back(at::zeros_like(parameter));
    }
}

void Adam::step() {
    const at::NoGradGuard no_gradients;
    ++steps;
    const double correction1 = 1 - std::pow(settings.beta1, static_cast<double>(steps)),
                 correction2 = 1 - std::pow(settings.beta2, static_cast<double>(steps));
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
        at::Tensor parameter = parameters_[i].second;
        const at::Tensor gradient = parameter.grad();
        if (!gradient.defined()) continue;
        mean_[i].mul_(settings.beta1).add_(gradient, 1 - settings.beta1);
        square_[i].mul_(settings.beta2).addcmul_(gradient, gradient, 1 - settings.beta2);
        const at::Tensor deviation = (square_[i].sqrt() / std::sqrt(correction2)).add_(settings.eps);
        parameter.addcdiv_(mean_[i], deviation, -settings.learning_rate / correction1);
    }
}

void Adam::forget_gradients() {
    for (auto& [name, parameter] : parameters_) parameter.mutable_grad() = at::Tensor();
}

NamedTensors Adam::memory() const {
    NamedTensors out;
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
        out.emplace_back(parameters_[i].first + ".mean", mean_[i]);
        out.emplace_back(parameters_[i].first + ".square", square_[i]);
    }
    return out;
}

}  // namespace fastscene::nn
