// Samplers: parsing of configurations, and convergence to the solution of the differential equation.
#include "fastscene/nn/scheduler.h"

#include <c10/core/InferenceMode.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/nn/tiny_model.h"

namespace fastscene::nn {
namespace {

using at::Tensor;

constexpr Sampler kSamplers[] = {Sampler::euler_ancestral, Sampler::ddim, Sampler::unipc};

// As in the official file of Stable Diffusion 1.5, modified by `more`.
Json schedule_file(const Json& more = Json::object()) {
    Json file = {{"_class_name", "PNDMScheduler"}, {"beta_end", 0.012},    {"beta_schedule", "scaled_linear"},
                 {"beta_start", 0.00085},          {"clip_sample", false}, {"num_train_timesteps", 1000},
                 {"set_alpha_to_one", false},      {"steps_offset", 1},    {"trained_betas", nullptr}};
    if (!more.is_null()) file.update(more);
    return file;
}
ScheduleConfig schedule_of(const Json& more, Sampler sampler) {
    return schedule_config(schedule_file(more), "scheduler_config.json", sampler);
}
std::unique_ptr<Scheduler> scheduler_with(const Json& more, Sampler sampler, int steps) {
    return make_scheduler(sampler, schedule_of(more, sampler), steps);
}
std::string complaint_of(const Json& more, Sampler sampler) {
    return message_of([&] { (void)schedule_of(more, sampler); });
}

// A latent of unit variance, and noise.
Tensor waves(double from, std::int64_t count = 64) {
    return at::sin(at::arange(count, at::kDouble) * 1.7 + from) * std::sqrt(2.0);
}

TEST(Schedules, ASpacingThatIsWrittenCountsWhoeverWroteIt) {
    for (const char* writer : {"PNDMScheduler", "DDIMScheduler", "EulerAncestralDiscreteScheduler",
                               "UniPCMultistepScheduler", "DPMSolverMultistepScheduler"}) {
        SCOPED_TRACE(writer);
        const Json by{{"_class_name", writer}};
        const auto first = [&](const char* spacing, Sampler sampler, int steps) {
            Json file = by;
            if (*spacing) file["timestep_spacing"] = spacing;
            return scheduler_with(file, sampler, steps)->timestep(0);
        };
        for (const auto& [sampler, parts] :
             {std::pair{Sampler::euler_ancestral, 20}, {Sampler::ddim, 20}, {Sampler::unipc, 21}}) {
            EXPECT_EQ(first("leading", sampler, 20), 1000 / parts * (parts - 1) + 1);
            EXPECT_EQ(first("trailing", sampler, 20), 999);
            EXPECT_EQ(first("linspace", sampler, 20), 999);
            EXPECT_EQ(first("", sampler, 20), first(sampler == Sampler::ddim ? "leading" : "linspace", sampler, 20));
        }
        Json leading = by;
        leading["timestep_spacing"] = "leading";
        const auto euler = scheduler_with(leading, Sampler::euler_ancestral, 20);
        EXPECT_NEAR(euler->init_noise_sigma(), std::hypot(euler->sigmas()[0], 1), 1e-5)
            << "begins where the picture is still seen a little";
    }
}

TEST(Schedules, ListedBetasAreThoseOfTheRuleTheyCameFrom) {
    std::vector<double> betas;
    for (int i = 0; i < 1000; ++i)
        betas.push_back(std::pow(std::sqrt(0.00085) + (std::sqrt(0.012) - std::sqrt(0.00085)) * i / 999, 2));
    for (const Sampler sampler : kSamplers) {
        const Tensor listed = alphas_cumprod(
            schedule_of({{"trained_betas", betas}, {"beta_schedule", "linear"}}, sampler));
        EXPECT_TRUE(at::allclose(listed, alphas_cumprod(schedule_of({}, sampler)), 1e-4, 0));
    }
    betas[7] = 1;
    EXPECT_NE(complaint_of({{"trained_betas", betas}}, Sampler::ddim).find("found 1"), std::string::npos);
    EXPECT_NE(complaint_of({{"trained_betas", {0.1, 0.2}}}, Sampler::ddim).find("1000 numbers"), std::string::npos);
    EXPECT_NE(complaint_of({{"trained_betas", 3}}, Sampler::ddim).find("trained_betas"), std::string::npos);
}

TEST(Schedules, ACosineFallsAsItsName) {
    const Tensor alphas = alphas_cumprod(schedule_of({{"beta_schedule", "squaredcos_cap_v2"}}, Sampler::ddim));
    const auto signal = [](double t) { return std::pow(std::cos((t + 0.008) / 1.008 * std::acos(-1.0) / 2), 2); };
    for (const int i : {0, 1, 250, 500, 900, 990})
        EXPECT_NEAR(alphas[i].item<double>(), signal((i + 1) / 1000.0) / signal(0), 1e-5) << i;
    EXPECT_GT(alphas[-1].item<double>(), 0) << "capped";
}

TEST(Schedules, ZeroSignalAtTheEndIsStretchedFromTheRest) {
    const Json zero{
        {"rescale_betas_zero_snr", true}, {"prediction_type", "v_prediction"}, {"timestep_spacing", "trailing"}};
    const Tensor plain = alphas_cumprod(schedule_of({}, Sampler::ddim)).sqrt(),
                 stretched = alphas_cumprod(schedule_of(zero, Sampler::ddim)).sqrt();
    EXPECT_EQ(stretched[-1].item<double>(), 0);
    EXPECT_NEAR(stretched[0].item<double>(), plain[0].item<double>(), 1e-6);
    const Tensor ratio = (stretched.narrow(0, 0, 999) - stretched[0]) /
                         (plain.narrow(0, 0, 999) - plain[0]);  // the first is 0 / 0
    EXPECT_LT((ratio.narrow(0, 10, 989) - ratio[500]).abs().max().item<double>(), 1e-3) << "one factor for all";
    EXPECT_NE(complaint_of({{"rescale_betas_zero_snr", true}}, Sampler::ddim).find("v_prediction"), std::string::npos);
    EXPECT_NE(complaint_of(zero, Sampler::unipc).find("unipc"), std::string::npos);
    EXPECT_EQ(scheduler_with(zero, Sampler::ddim, 10)->timestep(0), 999);
    EXPECT_NEAR(scheduler_with(zero, Sampler::euler_ancestral, 10)->sigmas()[0], 4096, 1);
}

// The output of a perfect denoiser, which knows the clean latent.
Tensor all_knowing(const Json& more, Sampler sampler, const Scheduler& scheduler, const Tensor& x, int i,
                   const Tensor& clean) {
    const ScheduleConfig config = schedule_of(more, sampler);
    double signal = 0;
    if (sampler == Sampler::ddim)
        signal = std::sqrt(alphas_cumprod(config)[static_cast<std::int64_t>(scheduler.timestep(i))].item<double>());
    else signal = 1 / std::hypot(1, scheduler.sigmas()[static_cast<std::size_t>(i)]);
    const double noise = std::sqrt(1 - signal * signal);
    const Tensor seen = sampler == Sampler::euler_ancestral ? x * signal : x;  // x is larger by 1 / signal there
    if (config.prediction == Prediction::noise) return (seen - signal * clean) / noise;
    return noise > 0 && signal > 0 ? (signal * seen - clean) / noise : -clean;
}

TEST(Schedules, AnAllKnowingNetworkIsBelieved) {
    const c10::InferenceMode inference;
    const Tensor clean = waves(0);
    const std::vector<Json> files{
        Json::object(),
        {{"prediction_type", "v_prediction"}},
        {{"timestep_spacing", "leading"}},
        {{"timestep_spacing", "trailing"}},
        {{"beta_schedule", "linear"}},
        {{"use_karras_sigmas", true}},
        {{"solver_type", "bh1"}, {"solver_order", 3}},
        {{"disable_corrector", {0, 1}}},
        {{"set_alpha_to_one", true}},
        {{"rescale_betas_zero_snr", true}, {"prediction_type", "v_prediction"}, {"timestep_spacing", "trailing"}}};
    for (const Json& file : files)
        for (const Sampler sampler : kSamplers) {
            if (sampler == Sampler::unipc && file.contains("rescale_betas_zero_snr")) continue;
            SCOPED_TRACE(file.dump() + " " + std::to_string(static_cast<int>(sampler)));
            for (const int steps : {7, 30}) {
                const auto scheduler = scheduler_with(file, sampler, steps);
                Tensor x = waves(0.3) * scheduler->init_noise_sigma();
                for (int i = 0; i < steps; ++i)
                    x = scheduler->step(all_knowing(file, sampler, *scheduler, x, i, clean), i, x, waves(i + 2.));
                // Residual noise: 0.03 at the first training step, where DDIM and UniPC may end.
                EXPECT_LT((x - clean).abs().max().item<double>(), 0.1) << steps;
            }
        }
}

// For normally distributed latents with standard deviation `spread`, the expected clean latent and the exact solution
// are known.
TEST(Schedules, HigherOrdersFollowTheEquationMoreClosely) {
    const c10::InferenceMode inference;
    constexpr double spread = 0.6;
    const auto error = [&](const Json& file, int steps) {
        const auto scheduler = scheduler_with(file, Sampler::unipc, steps);
        const auto power = [&](int i) {  // signal^2 and noise^2 at step i
            const double sigma = scheduler->sigmas()[static_cast<std::size_t>(i)], signal = 1 / (1 + sigma * sigma);
            return std::pair{signal, 1 - signal};
        };
        const auto deviation = [&](int i) { return std::sqrt(power(i).first * spread * spread + power(i).second); };
        const Tensor start = waves(0);
        Tensor x = start;
        for (int i = 0; i < steps; ++i) {
            const auto [signal, noise] = power(i);
            const Tensor expected = x * (std::sqrt(signal) * spread * spread / (signal * spread * spread + noise));
            x = scheduler->step((x - std::sqrt(signal) * expected) / std::sqrt(noise), i, x, {});
        }
        return (x - start * (deviation(steps) / deviation(0))).abs().max().item<double>();
    };
    for (const bool karras : {false, true})
        for (const char* type : {"bh1", "bh2"}) {
            const auto of_order = [&](int order, int steps) {
                return error({{"solver_order", order}, {"solver_type", type}, {"use_karras_sigmas", karras}}, steps);
            };
            SCOPED_TRACE(std::string(type) + (karras ? " karras" : ""));
            EXPECT_LT(of_order(2, 20), 0.05);
            EXPECT_LT(of_order(2, 40), of_order(2, 20));
            EXPECT_LT(of_order(2, 20), of_order(1, 20));
            EXPECT_LT(of_order(3, 20), of_order(1, 20));
        }
}

TEST(Schedules, ACorrectorThatRestsLeavesEachStepToItself) {
    const c10::InferenceMode inference;
    constexpr int steps = 8;
    Json rests = Json::array();
    for (int i = 0; i < steps; ++i) rests.push_back(i);
    const auto resting = scheduler_with({{"disable_corrector", rests}, {"solver_order", 1}}, Sampler::unipc, steps),
               fresh = scheduler_with({}, Sampler::unipc, steps),
               working = scheduler_with({{"solver_order", 1}}, Sampler::unipc, steps);
    Tensor x = waves(0), y = x, z = x;
    for (int i = 0; i < steps; ++i) {
        x = resting->step(waves(i), i, x, {});
        y = fresh->clone()->step(waves(i), i, y, {});  // without history
        z = working->step(waves(i), i, z, {});
    }
    EXPECT_TRUE(at::allclose(x, y));
    EXPECT_FALSE(at::allclose(x, z));
}

TEST(Schedules, KarrasSigmasFallEvenlyInTheirSeventhRoot) {
    const Json file{{"use_karras_sigmas", true}};
    for (const int steps : {1, 5, 20, 100}) {
        const auto scheduler = scheduler_with(file, Sampler::unipc, steps);
        const std::vector<float>& sigmas = scheduler->sigmas();
        ASSERT_EQ(sigmas.size(), static_cast<std::size_t>(steps) + 1);
        EXPECT_NEAR(sigmas[0], 14.6146, 1e-3);
        EXPECT_EQ(sigmas[static_cast<std::size_t>(steps)], sigmas[static_cast<std::size_t>(steps) - 1]);
        for (int i = 2; i < steps; ++i) {
            const auto root = [&](int k) { return std::pow(sigmas[static_cast<std::size_t>(k)], 1.0 / 7); };
            EXPECT_NEAR(root(i) - root(i - 1), root(1) - root(0), 1e-5);
        }
        // The timestep passed to the network is the one with that sigma in training.
        const Tensor alphas = alphas_cumprod(schedule_of(file, Sampler::unipc));
        for (int i = 0; i < steps; ++i) {
            const double a = alphas[static_cast<std::int64_t>(scheduler->timestep(i))].item<double>();
            EXPECT_NEAR(std::log(std::sqrt((1 - a) / a)), std::log(sigmas[static_cast<std::size_t>(i)]), 0.2) << i;
        }
    }
    EXPECT_EQ(scheduler_with(file, Sampler::euler_ancestral, 20)->sigmas(),
              scheduler_with({}, Sampler::euler_ancestral, 20)->sigmas())
        << "which does not know of them";
}

TEST(Schedules, WhatCannotBeFollowedIsNamed) {
    for (const auto& [file, says] : {std::pair<Json, std::string>{{{"steps_offset", 1000}}, "steps_offset"},
                                     {{{"beta_schedule", "sigmoid"}}, "beta_schedule"},
                                     {{{"prediction_type", "sample"}}, "prediction_type"},
                                     {{{"timestep_spacing", "even"}}, "timestep_spacing"},
                                     {{{"thresholding", true}}, "thresholding"},
                                     {{{"predict_x0", false}}, "predict_x0"},
                                     {{{"disable_corrector", {-1}}}, "disable_corrector"}}) {
        const std::string said = complaint_of(file, Sampler::unipc);
        EXPECT_NE(said.find("\"" + says + "\""), std::string::npos) << said;
        EXPECT_NE(said.find("scheduler_config.json"), std::string::npos) << said;
    }
}

}  // namespace
}  // namespace fastscene::nn
