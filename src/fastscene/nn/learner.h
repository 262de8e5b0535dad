// A network in training: parameters created on first use, their exponential moving average (EMA) and their optimizer.
// Networks remain functions of a scope (scope.h); in training the scope's source is a Learner. Private to nn/ (torch).
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "fastscene/nn/adam.h"
#include "fastscene/nn/scope.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {

class ProcessGroup;

// Initialization of a parameter, by name and shape.
using Start = std::function<at::Tensor(const std::string& key, at::IntArrayRef shape)>;
// Kernels and matrices are normal with this standard deviation, or as by He et al. 2015 (`gain` / sqrt(fan-in)); norm
// weights are 1, everything else 0. u and v of spectral norms are unit vectors. Depends on seed and name only.
Start start_normal(std::uint64_t seed, double deviation);
Start start_he(std::uint64_t seed, double gain = 1.4142135623730951);
// Parameters from a file, unwrapped (weights.h), or from `otherwise` if the file lacks them. Throws Error for
// mismatched shapes, and if the file lacks `expected`, which means that it belongs to another network.
Start start_from(Weights found, std::string_view expected, Start otherwise);

// Not trained but saved with the network: spectral norm vectors, batch norm statistics.
bool is_buffer(std::string_view key);

class TrainableWeights final : public WeightSource {
  public:
    TrainableWeights(Start start, at::TensorOptions options) : start_(std::move(start)), options_(options) {}
    at::Tensor get(const std::string& key, at::IntArrayRef shape) override;
    bool has(const std::string&) const override { return true; }
    // By name, including buffers.
    const std::map<std::string, at::Tensor>& all() const { return all_; }
    // How many parameters were asked for so far: tells another thread how far a pass through the network is.
    std::int64_t asked() const { return asked_; }

  private:
    std::atomic<std::int64_t> asked_{0};
    Start start_;
    at::TensorOptions options_;
    std::map<std::string, at::Tensor> all_;
};

struct LearnerSettings {
    AdamSettings adam;
    double ema_decay = 0.999;
    double clip = 0;  // maximum gradient norm; 0 = no clipping
};

class Learner {
  public:
    // `run_once` runs the network on a small example, so that all parameters get created.
    Learner(std::string name, const Start& start, at::TensorOptions options,
            const std::function<void(const Scope&)>& run_once, LearnerSettings settings);

    Scope scope() { return Scope(weights_); }  // the trained parameters
    Scope ema() { return Scope(ema_); }        // their exponential moving average: for evaluation and for saving
    // Clips the gradients left by backward(), performs one step of Adam, updates the EMA and clears the gradients.
    // Returns the gradient norm before clipping. If it is not finite, the step is skipped (and NaN returned).
    double update(double learning_rate);
    // Makes update() average gradients over the group, which must outlive this object.
    void join(ProcessGroup& group) { group_ = &group; }
    void forget_gradients() { adam_.forget_gradients(); }
    // While frozen, gradients flow through the network without accumulating in its parameters.
    void freeze(bool frozen);

    // Called before the first change that update() makes.
    void before_update(std::function<void()> call) { before_update_ = std::move(call); }
    // Keeps the buffers, which a step changes before update(), as they are now, for state_at_rest().
    void rest();
    // The state before the step that is being computed. From any thread, but not during update().
    NamedTensors state_at_rest() const;
    // Passes through the network so far, of the trained one and of its average.
    double passes() const;

    const std::string& name() const { return name_; }
    // Everything needed to resume training, sharing memory with this object: NAME.weights.*, NAME.average.*,
    // NAME.adam.*.
    NamedTensors state() const;
    std::int64_t steps() const { return adam_.steps; }
    void set_steps(std::int64_t steps) { adam_.steps = steps; }
    // The EMA as a weights file, as the program loads it.
    Weights kept() const;

  private:
    std::vector<at::Tensor> gradients() const;

    std::string name_;
    TrainableWeights weights_, ema_;
    Adam adam_;
    std::int64_t asked_a_pass_ = 1;
    LearnerSettings settings_;
    std::function<void()> before_update_;
    std::map<std::string, at::Tensor> at_rest_;  // buffers by their names in state()
    ProcessGroup* group_ = nullptr;
};

}  // namespace fastscene::nn
