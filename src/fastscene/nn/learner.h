// A network that learns: parameters that exist once they are asked for, their running average, their optimizer.
// Networks stay functions of a scope (scope.h); where they are trained, the scope's source is a learner. Private to nn/
// (torch).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "fastscene/nn/adam.h"
#include "fastscene/nn/scope.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {

class ProcessGroup;

// What a new parameter starts from, by its name and shape.
using Start = std::function<at::Tensor(const std::string& key, at::IntArrayRef shape)>;
// Kernels and matrices normal with this deviation, or with that of He et al. 2015 (`gain` / sqrt(fan-in)); weights of
// norms 1; the rest 0. u and v of spectral norms are unit vectors. The same seed and name give the same numbers.
Start start_normal(std::uint64_t seed, double deviation);
Start start_he(std::uint64_t seed, double gain = 1.4142135623730951);
// Parameters of a file, unwrapped (weights.h), and for those that it lacks `otherwise`. Throws Error for another shape,
// and when it lacks `expected`: then it is another network's.
Start start_from(Weights found, std::string_view expected, Start otherwise);

// Not trained, but kept with the network: spectral norms' vectors, statistics of batch norms.
bool is_buffer(std::string_view key);

class TrainableWeights final : public WeightSource {
  public:
    TrainableWeights(Start start, at::TensorOptions options) : start_(std::move(start)), options_(options) {}
    at::Tensor get(const std::string& key, at::IntArrayRef shape) override;
    bool has(const std::string&) const override { return true; }
    // By name, buffers too.
    const std::map<std::string, at::Tensor>& all() const { return all_; }

  private:
    Start start_;
    at::TensorOptions options_;
    std::map<std::string, at::Tensor> all_;
};

struct LearnerSettings {
    AdamSettings adam;
    double ema_decay = 0.999;
    double clip = 0;  // 0 = no
};

class Learner {
  public:
    // `run_once` runs the network through a small example, so that every parameter is there.
    Learner(std::string name, const Start& start, at::TensorOptions options,
            const std::function<void(const Scope&)>& run_once, LearnerSettings settings);

    Scope scope() { return Scope(weights_); }  // what learns
    Scope ema() { return Scope(ema_); }        // the running average: for looking and for keeping
    // Along the gradients that the last backward() left: shortens them, one step of Adam, moves the average, forgets
    // them. Returns the gradients' length before. A step whose gradients are not finite is left out (NaN comes back).
    double update(double learning_rate);
    // From now on update() takes the mean of the group's gradients. The group must live as long.
    void join(const ProcessGroup& group) { group_ = &group; }
    void forget_gradients() { adam_.forget_gradients(); }
    // While frozen, gradients pass through the network without being kept for its parameters.
    void freeze(bool frozen);

    const std::string& name() const { return name_; }
    // Everything that a training that goes on needs, sharing memory with this: NAME.weights.*, NAME.average.*,
    // NAME.adam.*.
    NamedTensors state() const;
    std::int64_t steps() const { return adam_.steps; }
    void set_steps(std::int64_t steps) { adam_.steps = steps; }
    // The average, as a file of this network: what the program loads.
    Weights kept() const;

  private:
    std::vector<at::Tensor> gradients() const;

    std::string name_;
    TrainableWeights weights_, ema_;
    Adam adam_;
    LearnerSettings settings_;
    const ProcessGroup* group_ = nullptr;
};

}  // namespace fastscene::nn
