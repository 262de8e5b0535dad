#include "fastscene/nn/learner.h"

#include <cmath>

#include "fastscene/nn/libtorch.h"
#include "fastscene/base/random.h"
#include "fastscene/nn/process_group.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

Tensor normal_numbers(std::uint64_t seed, const std::string& key, at::IntArrayRef shape, double deviation) {
    Tensor out = at::empty(shape, at::kFloat);
    Random rng(seed, key);
    float* to = out.data_ptr<float>();
    for (std::int64_t i = 0; i < out.numel(); ++i) to[i] = static_cast<float>(deviation) * rng.normal();
    return out;
}

bool is_spectral_vector(std::string_view key) { return key.ends_with("weight_u") || key.ends_with("weight_v"); }

// Normal with the standard deviation `deviation`(fan-in).
Start start_with(std::uint64_t seed, std::function<double(double inputs)> deviation) {
    return [seed, deviation](const std::string& key, at::IntArrayRef shape) -> Tensor {
        if (is_spectral_vector(key)) {
            const Tensor v = normal_numbers(seed, key, shape, 1);
            return v / v.norm().clamp_min(1e-12);
        }
        if (shape.size() >= 2)
            return normal_numbers(
                seed, key, shape,
                deviation(static_cast<double>(c10::multiply_integers(shape)) / static_cast<double>(shape[0])));
        const bool one = key.ends_with("weight") || key.ends_with("running_var");
        return one ? at::ones(shape) : at::zeros(shape);
    };
}

NamedTensors learning(const TrainableWeights& weights) {
    NamedTensors out;
    for (const auto& [key, tensor] : weights.all())
        if (!is_buffer(key)) out.emplace_back(key, tensor);
    return out;
}

}  // namespace

Start start_normal(std::uint64_t seed, double deviation) {
    return start_with(seed, [deviation](double) { return deviation; });
}
Start start_he(std::uint64_t seed, double gain) {
    return start_with(seed, [gain](double inputs) { return gain / std::sqrt(inputs); });
}

Start start_from(Weights found, std::string_view expected, Start otherwise) {
    Weights weights = unwrapped(std::move(found), expected);
    (void)weights.at(std::string(expected));
    auto source = std::make_shared<LoadedWeights>(std::move(weights));
    return [source, otherwise = std::move(otherwise)](const std::string& key, at::IntArrayRef shape) {
        return source->has(key) ? source->get(key, shape).clone() : otherwise(key, shape);
    };
}

bool is_buffer(std::string_view key) {
    return is_spectral_vector(key) || key.ends_with("running_mean") || key.ends_with("running_var");
}

Tensor TrainableWeights::get(const std::string& key, at::IntArrayRef shape) {
    ++asked_;
    const auto found = all_.find(key);
    if (found != all_.end()) {
        FASTSCENE_CHECK(found->second.sizes() == shape);
        return found->second;
    }
    const at::NoGradGuard no_gradients;
    const Tensor made = start_(key, shape).to(options_);
    return all_[key] = made.set_requires_grad(!is_buffer(key));
}

Learner::Learner(std::string name, const Start& start, at::TensorOptions options,
                 const std::function<void(const Scope&)>& run_once, LearnerSettings settings)
    : name_(std::move(name)),
      weights_(start, options),
      ema_([this](const std::string& key, at::IntArrayRef) { return weights_.all().at(key).detach().clone(); },
           options),
      adam_((run_once(Scope(weights_)), learning(weights_)), settings.adam),
      asked_a_pass_(std::max<std::int64_t>(1, weights_.asked())),
      settings_(settings) {
    for (const auto& [key, tensor] : weights_.all()) ema_.get(key, tensor.sizes()).set_requires_grad(false);
}

// One per parameter, with zeros where there is none, so that all processes of a group send the same sizes.
std::vector<Tensor> Learner::gradients() const {
    std::vector<Tensor> out;
    for (const auto& [key, parameter] : adam_.parameters()) {
        if (!parameter.grad().defined()) parameter.mutable_grad() = at::zeros_like(parameter);
        out.push_back(parameter.grad());
    }
    return out;
}

double Learner::update(double learning_rate) {
    if (before_update_) before_update_();
    const at::NoGradGuard no_gradients;
    if (group_) group_->all_reduce_mean(gradients());
    Tensor square = at::zeros({}, at::kDouble);
    for (const auto& [key, parameter] : adam_.parameters())
        if (parameter.grad().defined()) square += parameter.grad().square().sum().to(square.options());
    const double length = std::sqrt(square.item<double>());
    if (!std::isfinite(length)) {
        adam_.forget_gradients();
        return std::nan("");
    }
    if (settings_.clip > 0 && length > settings_.clip)
        for (const auto& [key, parameter] : adam_.parameters())
            if (parameter.grad().defined()) parameter.grad().mul_(settings_.clip / length);
    adam_.settings.learning_rate = learning_rate;
    adam_.step();
    adam_.forget_gradients();
    // The decay is smaller at first, so that the EMA forgets its random initialization sooner.
    const double stays = std::min(settings_.ema_decay,
                                  (1.0 + static_cast<double>(adam_.steps)) / (10.0 + static_cast<double>(adam_.steps)));
    for (const auto& [key, tensor] : weights_.all()) {
        Tensor mean = ema_.all().at(key);
        if (is_buffer(key)) mean.copy_(tensor);
        else mean.lerp_(tensor, 1 - stays);
    }
    return length;
}

void Learner::freeze(bool frozen) {
    for (const auto& [key, parameter] : adam_.parameters()) parameter.set_requires_grad(!frozen);
}

NamedTensors Learner::state() const {
    NamedTensors out;
    for (const auto& [key, tensor] : weights_.all()) out.emplace_back(name_ + ".weights." + key, tensor);
    for (const auto& [key, tensor] : ema_.all()) out.emplace_back(name_ + ".average." + key, tensor);
    for (const auto& [key, tensor] : adam_.memory()) out.emplace_back(name_ + ".adam." + key, tensor);
    return out;
}

void Learner::rest() {
    for (const auto& [key, tensor] : weights_.all())
        if (is_buffer(key)) at_rest_[name_ + ".weights." + key] = tensor.detach().clone();
}

NamedTensors Learner::state_at_rest() const {
    NamedTensors out = state();
    for (auto& [key, tensor] : out)
        if (const auto found = at_rest_.find(key); found != at_rest_.end()) tensor = found->second;
    return out;
}

double Learner::passes() const {
    return static_cast<double>(weights_.asked() + ema_.asked()) / static_cast<double>(asked_a_pass_);
}

Weights Learner::kept() const {
    Weights out{name_, {}, {}, {}};
    for (const auto& [key, tensor] : ema_.all()) out.tensors[key] = weight_of(tensor);
    return out;
}

}  // namespace fastscene::nn
