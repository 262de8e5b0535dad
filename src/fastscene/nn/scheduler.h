// Diffusion samplers: from predicted noise to the next, less noisy latent. Implements the noise schedules of
// configuration files (Stable Diffusion's has 1000 steps with the square roots of beta evenly spaced) and three
// solvers, following diffusers 0.26, which Diffusion360 was built on. Private to nn/ (torch).
#pragma once

#include <ATen/ATen.h>

#include <memory>
#include <string>
#include <vector>

#include "fastscene/base/json.h"

namespace fastscene::nn {

enum class Prediction { noise, velocity };  // "epsilon" and "v_prediction"
enum class Spacing { linspace, leading, trailing };
enum class Betas {
    linear,
    scaled_linear,
    cosine
};  // scaled: sqrt(beta) evenly spaced; cosine: Nichol and Dhariwal 2021

struct ScheduleConfig {
    int train_steps = 1000;
    double beta_start = 0.00085, beta_end = 0.012;
    Betas betas = Betas::scaled_linear;
    std::vector<double> trained_betas;  // overrides all of these if given
    bool zero_snr = false;  // zero terminal SNR: rescaled so that the last step is pure noise (Lin et al. 2023)
    Prediction prediction = Prediction::noise;
    Spacing spacing = Spacing::linspace;
    int steps_offset = 0;
    bool alpha_to_one = true;  // DDIM: the final step leads to no noise at all
    bool clip_sample = false;  // DDIM
    double clip_range = 1;
    int solver_order = 2;  // UniPC, as are the following
    bool lower_order_final = true;
    bool karras_sigmas = false;             // uniform in sigma^(1/7) (Karras et al. 2022), overriding `spacing`
    bool step_as_b = false;                 // B(h) = h ("bh1"), else e^h - 1 ("bh2")
    std::vector<std::int64_t> uncorrected;  // steps without the corrector
};
// Parses scheduler_config.json, whichever sampler it was written for. Settings of other samplers are ignored; unknown
// schedules throw Error. Timestep spacing: as in the file, or else linspace (euler-ancestral, unipc) or leading (ddim).
enum class Sampler { euler_ancestral, ddim, unipc };
ScheduleConfig schedule_config(const Json& json, const std::string& where, Sampler sampler);

// Cumulative products of 1 - beta, [train_steps] float. With zero_snr the last one is 0.
at::Tensor alphas_cumprod(const ScheduleConfig& config);

class Scheduler {
  public:
    virtual ~Scheduler() = default;
    int steps() const { return static_cast<int>(timesteps_.size()); }
    double timestep(int i) const { return timesteps_[static_cast<std::size_t>(i)]; }
    const std::vector<double>& timesteps() const { return timesteps_; }
    const std::vector<float>& sigmas() const { return sigmas_; }  // empty for DDIM
    double init_noise_sigma() const { return init_noise_sigma_; }

    // The network's input at step i.
    virtual at::Tensor scaled_input(const at::Tensor& x, int) const { return x; }
    // Advances x from step i to i + 1, given the network's output. `noise` (standard normal, like x) is used by the
    // ancestral sampler only.
    virtual at::Tensor step(const at::Tensor& output, int i, const at::Tensor& x, const at::Tensor& noise) = 0;
    // The clean latent implied by the network's output at step i: the result if sampling ended now.
    virtual at::Tensor clean(const at::Tensor& output, int i, const at::Tensor& x) const = 0;
    // Adds the noise of step i to a clean latent.
    virtual at::Tensor noised(const at::Tensor& clean, const at::Tensor& noise, int i) const = 0;
    virtual bool wants_noise() const { return false; }
    virtual std::unique_ptr<Scheduler> clone() const = 0;

  protected:
    ScheduleConfig config_;
    at::Tensor alphas_;
    std::vector<double> timesteps_;
    std::vector<float> sigmas_;
    double init_noise_sigma_ = 1;
};

// Throws UsageError if the schedule has fewer distinct steps than requested.
std::unique_ptr<Scheduler> make_scheduler(Sampler sampler, const ScheduleConfig& config, int steps);

}  // namespace fastscene::nn
