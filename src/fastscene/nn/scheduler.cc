#include "fastscene/nn/scheduler.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "fastscene/base/check.h"
#include "fastscene/nn/config_fields.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

// sqrt((1 - a) / a) for all training steps: noise-to-signal ratio.
std::vector<double> all_sigmas(const Tensor& alphas) {
    const Tensor s = at::sqrt((1 - alphas) / alphas);
    return {s.data_ptr<float>(), s.data_ptr<float>() + s.numel()};
}
double interpolated(const std::vector<double>& table, double at) {
    const double clamped = std::clamp(at, 0.0, static_cast<double>(table.size() - 1));
    const auto below = std::min(static_cast<std::size_t>(clamped), table.size() - 2);
    return table[below] + (table[below + 1] - table[below]) * (clamped - static_cast<double>(below));
}

// Fractional index of a sigma in the table, interpolated in the logarithm; the inverse of `interpolated` if the table
// increases.
double place_of(const std::vector<double>& table, double sigma) {
    const auto above = std::upper_bound(table.begin(), table.end(), sigma);
    const auto below = std::clamp<std::ptrdiff_t>(above - table.begin() - 1, 0,
                                                  static_cast<std::ptrdiff_t>(table.size()) - 2);
    const double from = std::log(table[static_cast<std::size_t>(below)]),
                 to = std::log(table[static_cast<std::size_t>(below) + 1]);
    return static_cast<double>(below) + std::clamp((std::log(sigma) - from) / (to - from), 0.0, 1.0);
}
// Karras et al.'s spacing: sigmas descending from the table's last to its first, uniform in sigma^(1/7).
std::vector<double> karras_sigmas(const std::vector<double>& table, int count) {
    constexpr double rho = 7;
    const double most = std::pow(table.back(), 1 / rho), least = std::pow(table.front(), 1 / rho);
    std::vector<double> out;
    for (int i = 0; i < count; ++i)
        out.push_back(std::pow(most + (least - most) * (count > 1 ? static_cast<double>(i) / (count - 1) : 0), rho));
    return out;
}

double rounded_even(double v) { return std::nearbyint(v); }

// `count` descending timesteps. `last`: linspace spacing ends at 0 (otherwise one step before, as in UniPC).
std::vector<double> spaced(const ScheduleConfig& c, int count, bool last, bool whole) {
    std::vector<double> out;
    const int parts = last ? count : count + 1;
    for (int i = 0; i < count; ++i) {
        const int k = parts - 1 - i;  // counting up
        double t = 0;
        switch (c.spacing) {
            case Spacing::linspace: t = parts > 1 ? static_cast<double>(c.train_steps - 1) * k / (parts - 1) : 0; break;
            case Spacing::leading: t = static_cast<double>(k * (c.train_steps / parts)) + c.steps_offset; break;
            case Spacing::trailing:
                t = rounded_even(c.train_steps - i * (static_cast<double>(c.train_steps) / count)) - 1;
                break;
        }
        out.push_back(whole ? rounded_even(t) : t);
    }
    return out;
}

// Sigma as the pair (signal, noise) with unit total power.
struct Mix {
    double signal, noise;
};
Mix mix_of(double sigma) {
    const double signal = 1 / std::sqrt(sigma * sigma + 1);
    return {signal, sigma * signal};
}
// The clean latent implied by the network's output.
Tensor clean_of(Prediction prediction, const Tensor& output, const Tensor& x, Mix m) {
    return prediction == Prediction::noise ? (x - m.noise * output) / m.signal : m.signal * x - m.noise * output;
}

class EulerAncestral final : public Scheduler {
  public:
    EulerAncestral(const ScheduleConfig& config, int steps) {
        config_ = config;
        alphas_ = alphas_cumprod(config);
        if (config.zero_snr) alphas_[-1] = std::pow(2.0, -24);  // one cannot step from an infinite sigma
        timesteps_ = spaced(config, steps, true, false);
        if (config.spacing == Spacing::linspace)
            for (double& t : timesteps_) t = static_cast<float>(t);
        const std::vector<double> table = all_sigmas(alphas_);
        for (const double t : timesteps_) sigmas_.push_back(static_cast<float>(interpolated(table, t)));
        const double most = *std::max_element(sigmas_.begin(), sigmas_.end());
        sigmas_.push_back(0);
        init_noise_sigma_ = config.spacing == Spacing::leading ? std::sqrt(most * most + 1) : most;
    }
    Tensor scaled_input(const Tensor& x, int i) const override {
        const double sigma = sigmas_[static_cast<std::size_t>(i)];
        return x / std::sqrt(sigma * sigma + 1);
    }
    Tensor step(const Tensor& output, int i, const Tensor& x, const Tensor& noise) override {
        const double from = sigmas_[static_cast<std::size_t>(i)], to = sigmas_[static_cast<std::size_t>(i) + 1];
        const Tensor clean = this->clean(output, i, x);
        const double up = std::sqrt(to * to * (from * from - to * to) / (from * from)),
                     down = std::sqrt(to * to - up * up);
        return x + (x - clean) / from * (down - from) + noise * up;
    }
    Tensor clean(const Tensor& output, int i, const Tensor& x) const override {
        const double from = sigmas_[static_cast<std::size_t>(i)];
        return config_.prediction == Prediction::noise
                   ? x - from * output
                   : output * (-from / std::sqrt(from * from + 1)) + x / (from * from + 1);
    }
    Tensor noised(const Tensor& clean, const Tensor& noise, int i) const override {
        return clean + noise * sigmas_[static_cast<std::size_t>(i)];
    }
    bool wants_noise() const override { return true; }
    std::unique_ptr<Scheduler> clone() const override { return std::make_unique<EulerAncestral>(*this); }
};

class Ddim final : public Scheduler {
  public:
    Ddim(const ScheduleConfig& config, int steps) {
        config_ = config;
        alphas_ = alphas_cumprod(config);
        timesteps_ = spaced(config, steps, true, true);
    }
    Tensor step(const Tensor& output, int i, const Tensor& x, const Tensor&) override {
        const double t = timestep(i), before = t - config_.train_steps / steps();
        const double a = alpha(t), b = before >= 0 ? alpha(before) : config_.alpha_to_one ? 1 : alpha(0);
        const Mix m{std::sqrt(a), std::sqrt(1 - a)};
        Tensor clean = this->clean(output, i, x);
        Tensor noise = config_.prediction == Prediction::noise ? output : m.signal * output + m.noise * x;
        if (config_.clip_sample) clean = at::clamp(clean, -config_.clip_range, config_.clip_range);
        return std::sqrt(b) * clean + std::sqrt(1 - b) * noise;
    }
    Tensor clean(const Tensor& output, int i, const Tensor& x) const override {
        const double a = alpha(timestep(i));
        return clean_of(config_.prediction, output, x, {std::sqrt(a), std::sqrt(1 - a)});
    }
    Tensor noised(const Tensor& clean, const Tensor& noise, int i) const override {
        const double a = alpha(timestep(i));
        return std::sqrt(a) * clean + std::sqrt(1 - a) * noise;
    }
    std::unique_ptr<Scheduler> clone() const override { return std::make_unique<Ddim>(*this); }

  private:
    double alpha(double t) const { return alphas_.data_ptr<float>()[static_cast<std::int64_t>(t)]; }
};

// UniPC (Zhao et al. 2023), predicting the clean latent: a predictor of order 1 to `solver_order`, and from the second
// step on a corrector that uses the new output before the next prediction.
class UniPc final : public Scheduler {
  public:
    UniPc(const ScheduleConfig& config, int steps) {
        config_ = config;
        alphas_ = alphas_cumprod(config);
        const std::vector<double> table = all_sigmas(alphas_);
        if (config.karras_sigmas) {
            for (const double sigma : karras_sigmas(table, steps)) {
                sigmas_.push_back(static_cast<float>(sigma));
                timesteps_.push_back(rounded_even(place_of(table, sigma)));
            }
            sigmas_.push_back(sigmas_.back());  // which already has the least noise: the last step stays there
            return;
        }
        timesteps_ = spaced(config, steps, false, true);
        for (const double t : timesteps_) sigmas_.push_back(static_cast<float>(interpolated(table, t)));
        sigmas_.push_back(static_cast<float>(table[0]));  // the last step ends at t = 0, where a little noise is left
    }
    Tensor step(const Tensor& output, int i, const Tensor& x, const Tensor&) override {
        const Tensor clean = this->clean(output, i, x);
        const auto& rests = config_.uncorrected;
        const bool corrects = last_.defined() && i > 0 && std::find(rests.begin(), rests.end(), i - 1) == rests.end();
        const Tensor from = corrects ? corrected(clean, i) : x;
        cleans_.push_back(clean);
        if (static_cast<int>(cleans_.size()) > config_.solver_order) cleans_.erase(cleans_.begin());
        order_ = config_.lower_order_final ? std::min(config_.solver_order, steps() - i) : config_.solver_order;
        order_ = std::min(order_, done_ + 1);
        last_ = from;
        done_ = std::min(done_ + 1, config_.solver_order);
        return moved(from, i, i + 1, {}, order_);
    }
    Tensor clean(const Tensor& output, int i, const Tensor& x) const override {
        return clean_of(config_.prediction, output, x, mix_of(sigmas_[static_cast<std::size_t>(i)]));
    }
    Tensor noised(const Tensor& clean, const Tensor& noise, int i) const override {
        const Mix m = mix_of(sigmas_[static_cast<std::size_t>(i)]);
        return m.signal * clean + m.noise * noise;
    }
    std::unique_ptr<Scheduler> clone() const override { return std::make_unique<UniPc>(*this); }

  private:
    double lambda(int i) const { return -std::log(static_cast<double>(sigmas_[static_cast<std::size_t>(i)])); }
    Tensor corrected(const Tensor& clean, int i) const { return moved(last_, i - 1, i, clean, order_); }

    // From step `a` to `b`. With `target`, the clean latent found at b, this is the corrector.
    Tensor moved(const Tensor& x, int a, int b, const Tensor& target, int order) const {
        const Mix to = mix_of(sigmas_[static_cast<std::size_t>(b)]),
                  from = mix_of(sigmas_[static_cast<std::size_t>(a)]);
        const double h = lambda(b) - lambda(a), growth = std::expm1(-h), bending = config_.step_as_b ? -h : growth;
        if (h == 0) return x;
        const Tensor& newest = cleans_.back();
        std::vector<double> ratios;
        std::vector<Tensor> slopes;
        for (int k = 1; k < order; ++k) {
            ratios.push_back((lambda(a - k) - lambda(a)) / h);
            slopes.push_back((cleans_[cleans_.size() - 1 - static_cast<std::size_t>(k)] - newest) / ratios.back());
        }
        ratios.push_back(1);
        Tensor bend = at::zeros_like(x);
        if (target.defined()) {
            const std::vector<double> rho = order == 1 ? std::vector{0.5} : weights(ratios, h, bending, order);
            for (std::size_t k = 0; k < slopes.size(); ++k) bend = bend + rho[k] * slopes[k];
            bend = bend + rho.back() * (target - newest);
        } else {
            const std::vector<double> rho = order == 2 ? std::vector{0.5} : weights(ratios, h, bending, order - 1);
            for (std::size_t k = 0; k < slopes.size(); ++k) bend = bend + rho[k] * slopes[k];
        }
        return to.noise / from.noise * x - to.signal * growth * newest - to.signal * bending * bend;
    }

    // Solves sum_k rho_k r_k^i = phi_i for i < n.
    static std::vector<double> weights(const std::vector<double>& ratios, double h, double b, int n) {
        const auto size = static_cast<std::size_t>(n);
        std::vector<std::vector<double>> m(size, std::vector<double>(size + 1));
        double phi = std::expm1(-h) / -h - 1, factorial = 1;
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t k = 0; k < size; ++k) m[i][k] = std::pow(ratios[k], static_cast<double>(i));
            m[i][size] = phi * factorial / b;
            factorial *= static_cast<double>(i + 2);
            phi = phi / -h - 1 / factorial;
        }
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t r = 0; r < size; ++r) {
                if (r == i) continue;
                const double f = m[r][i] / m[i][i];
                for (std::size_t k = i; k <= size; ++k) m[r][k] -= f * m[i][k];
            }
        std::vector<double> out;
        for (std::size_t i = 0; i < size; ++i) out.push_back(m[i][size] / m[i][i]);
        return out;
    }

    std::vector<Tensor> cleans_;  // history, newest last, at most solver_order
    Tensor last_;                 // where the last predictor step started
    int order_ = 1, done_ = 0;
};

}  // namespace

namespace {

std::vector<double> trained_betas_of(const ConfigFields& f, int steps) {
    const Json* trained = f.find("trained_betas");
    if (!trained) return {};
    const auto expected = [&] {
        return fmt::format("null or a list of {} numbers between 0 and 1 (\"num_train_timesteps\")", steps);
    };
    if (!trained->is_array() || trained->size() != static_cast<std::size_t>(steps))
        throw f.wrong("trained_betas", expected(),
                      trained->is_array() ? Json(fmt::format("{} entries", trained->size())) : *trained);
    std::vector<double> out;
    for (const Json& beta : *trained) {
        if (!beta.is_number() || !(beta.get<double>() > 0 && beta.get<double>() < 1))
            throw f.wrong("trained_betas", expected(), beta);
        out.push_back(beta.get<double>());
    }
    return out;
}

void read_unipc(const ConfigFields& f, ScheduleConfig& c) {
    if (!f.flag("predict_x0", true)) throw f.wrong("predict_x0", "true", false);
    c.karras_sigmas = f.flag("use_karras_sigmas", false);
    c.step_as_b = f.text("solver_type", "bh2") == "bh1";  // solver types of other samplers map to bh2
    if (const Json* rests = f.find("disable_corrector"); rests && !(rests->is_array() && rests->empty()))
        c.uncorrected = f.list("disable_corrector", 0);
}

// Nichol and Dhariwal's schedule: the signal power follows a squared cosine.
Tensor cosine_betas(int steps) {
    const auto signal = [&](int i) {
        return std::pow(std::cos((static_cast<double>(i) / steps + 0.008) / 1.008 * std::numbers::pi / 2), 2);
    };
    std::vector<float> out;
    for (int i = 0; i < steps; ++i) out.push_back(static_cast<float>(std::min(1 - signal(i + 1) / signal(i), 0.999)));
    return at::tensor(out);
}

Tensor betas_of(const ScheduleConfig& c) {
    if (!c.trained_betas.empty()) return at::tensor(std::vector<float>(c.trained_betas.begin(), c.trained_betas.end()));
    if (c.betas == Betas::cosine) return cosine_betas(c.train_steps);
    return c.betas == Betas::scaled_linear
               ? at::linspace(std::sqrt(c.beta_start), std::sqrt(c.beta_end), c.train_steps, at::kFloat).square()
               : at::linspace(c.beta_start, c.beta_end, c.train_steps, at::kFloat);
}

}  // namespace

ScheduleConfig schedule_config(const Json& json, const std::string& where, Sampler sampler) {
    const ConfigFields f(json, where);
    ScheduleConfig c;
    c.train_steps = static_cast<int>(f.whole("num_train_timesteps", 1000));
    c.beta_start = f.number("beta_start", 0.0001);
    c.beta_end = f.number("beta_end", 0.02);
    if (c.train_steps < 2 || !(c.beta_start > 0 && c.beta_start < c.beta_end && c.beta_end < 1))
        throw Error("{}: expected at least 2 steps and 0 < beta_start < beta_end < 1, found {} steps, {} and {}", where,
                    c.train_steps, c.beta_start, c.beta_end);
    const std::string betas = f.text("beta_schedule", "linear");
    if (betas != "linear" && betas != "scaled_linear" && betas != "squaredcos_cap_v2")
        throw f.wrong("beta_schedule", "\"linear\", \"scaled_linear\" or \"squaredcos_cap_v2\"", betas);
    c.betas = betas == "linear" ? Betas::linear : betas == "scaled_linear" ? Betas::scaled_linear : Betas::cosine;
    c.trained_betas = trained_betas_of(f, c.train_steps);
    const std::string prediction = f.text("prediction_type", "epsilon");
    if (prediction != "epsilon" && prediction != "v_prediction")
        throw f.wrong("prediction_type", "\"epsilon\" or \"v_prediction\"", prediction);
    c.prediction = prediction == "epsilon" ? Prediction::noise : Prediction::velocity;
    c.zero_snr = f.flag("rescale_betas_zero_snr", false);
    if (c.zero_snr && sampler == Sampler::unipc)
        throw f.wrong("rescale_betas_zero_snr", "false for --panorama-sampler unipc (euler-ancestral and ddim know it)",
                      true);
    // at zero SNR, predicting noise carries no information about the latent
    if (c.zero_snr && c.prediction == Prediction::noise)
        throw f.wrong("prediction_type", "\"v_prediction\" where \"rescale_betas_zero_snr\" is true", prediction);

    const std::string spacing = f.text("timestep_spacing", sampler == Sampler::ddim ? "leading" : "linspace");
    if (spacing != "linspace" && spacing != "leading" && spacing != "trailing")
        throw f.wrong("timestep_spacing", "\"linspace\", \"leading\" or \"trailing\"", spacing);
    c.spacing = spacing == "linspace" ? Spacing::linspace : spacing == "leading" ? Spacing::leading : Spacing::trailing;

    c.steps_offset = static_cast<int>(f.whole("steps_offset", 0));
    if (c.steps_offset >= c.train_steps)
        throw f.wrong("steps_offset", fmt::format("less than the {} steps of the schedule", c.train_steps),
                      c.steps_offset);
    c.alpha_to_one = f.flag("set_alpha_to_one", true);
    // Clipping is DDIM's default, meant for pixel-space models. Latents are not clipped, unless a DDIM file enables it
    // explicitly or by omission.
    c.clip_sample = f.flag("clip_sample", f.text("_class_name", "") == "DDIMScheduler");
    c.clip_range = f.number("clip_sample_range", 1);
    c.solver_order = static_cast<int>(std::clamp<std::int64_t>(f.whole("solver_order", 2), 1, 3));
    c.lower_order_final = f.flag("lower_order_final", true);
    if (sampler != Sampler::euler_ancestral && f.flag("thresholding", false))
        throw f.wrong("thresholding", "false (it is for pictures, not for latents)", true);
    if (sampler == Sampler::unipc) read_unipc(f, c);
    return c;
}

Tensor alphas_cumprod(const ScheduleConfig& c) {
    const Tensor products = at::cumprod(1 - betas_of(c), 0);
    if (!c.zero_snr) return products;
    // Square roots shifted so that the last is 0, and rescaled so that the first is unchanged.
    const Tensor roots = products.sqrt(), first = roots[0], last = roots[-1];
    return ((roots - last) * (first / (first - last))).square();
}

namespace {

std::unique_ptr<Scheduler> scheduler_of(Sampler sampler, const ScheduleConfig& config, int steps) {
    switch (sampler) {
        case Sampler::euler_ancestral: return std::make_unique<EulerAncestral>(config, steps);
        case Sampler::ddim: return std::make_unique<Ddim>(config, steps);
        case Sampler::unipc: return std::make_unique<UniPc>(config, steps);
    }
    FASTSCENE_CHECK(false);
    return nullptr;
}

// Whether each step reduces noise and stays within the schedule.
bool goes_down(const Scheduler& scheduler, const ScheduleConfig& config) {
    const std::vector<double>& t = scheduler.timesteps();
    const std::vector<float>& sigma = scheduler.sigmas();
    if (t.front() > config.train_steps - 1 || t.back() < 0) return false;
    if (config.karras_sigmas)  // with Karras spacing rounded timesteps may repeat, and so does the last sigma
        return std::adjacent_find(t.begin(), t.end(), std::less<>()) == t.end() &&
               std::adjacent_find(sigma.begin(), sigma.end() - 1, std::less_equal<>()) == sigma.end() - 1;
    return std::adjacent_find(t.begin(), t.end(), std::less_equal<>()) == t.end() &&
           std::adjacent_find(sigma.begin(), sigma.end(), std::less_equal<>()) == sigma.end();
}

}  // namespace

std::unique_ptr<Scheduler> make_scheduler(Sampler sampler, const ScheduleConfig& config, int steps) {
    FASTSCENE_CHECK(steps >= 1);
    std::unique_ptr<Scheduler> scheduler = steps <= config.train_steps ? scheduler_of(sampler, config, steps) : nullptr;
    if (!scheduler || !goes_down(*scheduler, config))
        throw UsageError(
            "--panorama-steps: expected fewer than the {} of the model's schedule (\"num_train_timesteps\"), so that "
            "none repeats, found {}",
            config.train_steps, steps);
    return scheduler;
}

}  // namespace fastscene::nn
