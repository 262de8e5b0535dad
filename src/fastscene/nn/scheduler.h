// Samplers: how predicted noise becomes the next, less noisy latent. The noise schedules that configurations name
// (Stable Diffusion's has 1000 steps, betas whose roots rise evenly) and three solvers, with the meaning of diffusers
// 0.26: what Diffusion360 was made with. Private to nn/ (torch).
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
};  // scaled: their roots rise evenly; cosine: Nichol and Dhariwal 2021

struct ScheduleConfig {
    int train_steps = 1000;
    double beta_start = 0.00085, beta_end = 0.012;
    Betas betas = Betas::scaled_linear;
    std::vector<double> trained_betas;  // in place of all of these, when given
    bool zero_snr = false;              // rescaled so that the last step is all noise (Lin et al. 2023)
    Prediction prediction = Prediction::noise;
    Spacing spacing = Spacing::linspace;
    int steps_offset = 0;
    bool alpha_to_one = true;  // DDIM: what follows the last step is no noise at all
    bool clip_sample = false;  // DDIM
    double clip_range = 1;
    int solver_order = 2;  // UniPC, and what follows
    bool lower_order_final = true;
    bool karras_sigmas = false;  // spaced evenly in sigma^(1/7) (Karras et al. 2022), whatever `spacing` says
    bool step_as_b = false;      // B(h) = h ("bh1"), else e^h - 1 ("bh2")
    std::vector<std::int64_t> uncorrected;  // steps after which the corrector rests
};
// Reads scheduler_config.json, whichever sampler it was written for. What a sampler does not know of another one's file
// is passed over; kinds of schedule that are not known here throw Error.
//   euler-ancestral, unipc: spacing as in the file, else linspace; ddim: as in the file, else leading.
enum class Sampler { euler_ancestral, ddim, unipc };
ScheduleConfig schedule_config(const Json& json, const std::string& where, Sampler sampler);

// Products of 1 - beta, [train_steps] float. At zero_snr the last is 0.
at::Tensor alphas_cumprod(const ScheduleConfig& config);

class Scheduler {
  public:
    virtual ~Scheduler() = default;
    int steps() const { return static_cast<int>(timesteps_.size()); }
    double timestep(int i) const { return timesteps_[static_cast<std::size_t>(i)]; }
    const std::vector<double>& timesteps() const { return timesteps_; }
    const std::vector<float>& sigmas() const { return sigmas_; }  // empty for DDIM
    double init_noise_sigma() const { return init_noise_sigma_; }

    // What the network is shown at step i.
    virtual at::Tensor scaled_input(const at::Tensor& x, int) const { return x; }
    // From x at step i to step i + 1, given the network's output. `noise` (unit normal, like x) is read by the
    // ancestral sampler only.
    virtual at::Tensor step(const at::Tensor& output, int i, const at::Tensor& x, const at::Tensor& noise) = 0;
    // The clean latent that the network's output at step i implies: what the picture would be if it ended here.
    virtual at::Tensor clean(const at::Tensor& output, int i, const at::Tensor& x) const = 0;
    // A clean latent with the noise of step i.
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

// Throws UsageError when the schedule has not as many different steps.
std::unique_ptr<Scheduler> make_scheduler(Sampler sampler, const ScheduleConfig& config, int steps);

}  // namespace fastscene::nn
