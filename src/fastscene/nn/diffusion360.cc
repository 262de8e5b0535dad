#include "fastscene/nn/diffusion360.h"

#include <ATen/CPUGeneratorImpl.h>
#include <c10/core/InferenceMode.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "fastscene/nn/circular.h"
#include "fastscene/nn/clip_image.h"
#include "fastscene/nn/diffusion_memory.h"
#include "fastscene/nn/panorama_loops.h"
#include "fastscene/nn/photo_sphere.h"
#include "fastscene/nn/precision.h"
#include "fastscene/nn/replay.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/nn/sd_model.h"
#include "fastscene/nn/sphere_tiles.h"
#include "fastscene/nn/stoppable.h"

namespace fastscene {
namespace fs = std::filesystem;

using at::Tensor;
using nn::kPixelsPerLatent;
using nn::Scope;

const std::string_view kDiffusion360Negative =
    "persons, complex texture, small objects, sheltered, blur, worst quality, low quality, zombie, logo, text, "
    "watermark, username, monochrome, complex lighting";

std::string diffusion360_prompt(const std::string& prompt) {
    return "<360panorama>, " + prompt + ", photorealistic, trend on artstation, ((best quality)), ((ultra high res))";
}

namespace {

constexpr std::int64_t kMaskAndColor = 4;

fs::path base_of(const fs::path& weights, const char* inside) {
    if (!fs::is_directory(weights))
        throw Error("--weights {}: expected a folder with unet/ vae/ text_encoder/ tokenizer/ scheduler/, found none",
                    weights.string());
    const fs::path base = !fs::exists(weights / "unet") && fs::exists(weights / inside) ? weights / inside : weights;
    std::string missing;
    for (const char* part : {"unet", "vae", "text_encoder", "tokenizer", "scheduler"})
        if (!fs::is_directory(base / part)) missing += (missing.empty() ? "" : ", ") + std::string(part) + "/";
    if (!missing.empty())
        throw Error("--weights {}: expected a model as diffusers saves it, found no {}", base.string(), missing);
    return base;
}

nn::Sampler sampler_named(const std::string& name) {
    if (name == "euler-ancestral") return nn::Sampler::euler_ancestral;
    if (name == "ddim") return nn::Sampler::ddim;
    if (name == "unipc") return nn::Sampler::unipc;
    throw UsageError("--panorama-sampler: expected euler-ancestral, ddim or unipc, found \"{}\"", name);
}

// Steps with a preview: an early one, and the one halfway.
bool is_preview_step(int step, int steps) {
    return step + 1 == (steps + 9) / 10 || (steps >= 8 && step + 1 == steps / 2);
}

}  // namespace

struct Diffusion360::Parts {
    Diffusion360Settings settings;
    Diffusion360Info info;
    mutable nn::SdModel model;  // its weights are read on first use
    std::optional<nn::ControlModel> control;
    mutable nn::Replay replay;
    mutable at::Generator random;

    Parts(const fs::path& weights, const Diffusion360Settings& s, From from)
        : settings(s),
          model(base_of(weights, from == From::text ? "sd-base" : "sr-base"),
                nn::sd_options(s.precision, s.device, sampler_named(s.sampler), s.low_memory, from == From::photo)) {
        if (from == From::text) return;
        if (!fs::is_directory(weights / "sd-i2p"))
            throw Error("--photo: expected sd-i2p/ in {}, found none (fastscene models pull diffusion360-photo)",
                        weights.string());
        control.emplace(weights / "sd-i2p", model, kMaskAndColor);
    }
    // Published bands are as wide as the picture; larger pictures and low memory need tiles.
    bool decodes_in_tiles() const { return settings.low_memory || settings.width > 1024; }
    std::int64_t latent_width() const { return settings.width / kPixelsPerLatent; }

    void estimate(const Run& run);
    Tensor decode(const Tensor& latents, const Run& run) const;  // [1, 3, H, W] in [0, 1]
    Tensor encode(const Tensor& unit, const Run& run) const;
    // The ControlNet's folder is outside the model's.
    fs::path folder_of(const std::string& part) const {
        return part == "control" ? control->weights->path() : model.base / part;
    }
    Tensor noise(at::IntArrayRef shape) const { return at::randn(shape, random, at::TensorOptions(at::kFloat)); }
    ImageRgb8 finish(Tensor start, nn::TextToPanorama how, nn::Scheduler& scheduler, const std::string& prompt,
                     const Run& run, const Preview& preview) const;
};

void Diffusion360::Parts::estimate(const Run& run) {
    info.family = model.family();
    info.prediction = model.schedule.prediction == nn::Prediction::noise ? "epsilon" : "v_prediction";
    info.parameters = model.unet->bytes() / model.unet->dtype_bytes();
    info.peak_bytes = diffusion_memory({settings.width, settings.low_memory, model.unet->bytes(), model.vae->bytes(),
                                        model.text->bytes(), control ? control->weights->bytes() : 0,
                                        model.unet->largest_bytes(), decodes_in_tiles()});
    const bool on_card = model.options.device.is_cuda();
    run.note(fmt::format("diffusion360: {}, {:.0f} million parameters, needs about {} of {}memory", info.family,
                         static_cast<double>(info.parameters) / 1e6, gib_text(info.peak_bytes),
                         on_card ? "the graphics card's " : ""));
    if (on_card) return;  // CUDA reports by itself when its memory is full
    check_memory(fmt::format("diffusion360: {} x {} in {}", settings.width, settings.width / 2, settings.precision),
                 info.peak_bytes,
                 fmt::format("{}{}, or make it smaller with --panorama-width",
                             settings.low_memory ? "" : ", use --panorama-low-memory",
                             settings.precision == "bf16" ? "" : ", use --panorama-precision bf16"));
}

Tensor Diffusion360::Parts::decode(const Tensor& latents, const Run& run) const {
    const nn::Autocast coarse(
        at::kCPU, model.options.device.is_cpu() && settings.precision == "bf16");  // residual sums stay in float
    const Tensor unscaled = (latents / model.vae_config.scale).to(model.options.device);
    const std::int64_t tile = model.vae_config.sample_size / kPixelsPerLatent;
    const nn::SphereTiles how{tile, tile / 4, 1, kPixelsPerLatent, {}};
    const auto decoded = [&](const Scope& s, at::ScalarType type) {
        const Tensor z = unscaled.to(type);
        return decodes_in_tiles()
                   ? nn::over_sphere(z, how,
                                     [&](const Tensor& part) { return nn::vae_decode(s, model.vae_config, part); })
                   : nn::circular_decode(s, model.vae_config, z, tile, !settings.published_seam);
    };
    const Tensor picture = nn::without_overflow(model.vae, run, decoded);
    nn::expect_finite(picture, folder_of("vae"), model.options.type);
    return picture / 2 + 0.5;
}

Tensor Diffusion360::Parts::encode(const Tensor& unit, const Run& run) const {
    const std::int64_t tile = model.vae_config.sample_size / kPixelsPerLatent,
                       channels = model.vae_config.latent_channels;
    const nn::SphereTiles how{tile, tile / 4, kPixelsPerLatent, 1, {}};
    const Tensor picture = (unit * 2 - 1).to(model.options.device);
    const Tensor both = nn::without_overflow(model.vae, run, [&](const Scope& s, at::ScalarType type) {
        return nn::over_sphere(picture.to(type), how, [&](const Tensor& part) {
            const nn::Gaussian found = nn::vae_encode(s, model.vae_config, part);
            return at::cat({found.mean, found.log_variance}, 1);
        });
    });
    nn::expect_finite(both, folder_of("vae"), model.options.type);
    const Tensor mean = both.narrow(1, 0, channels), spread = at::exp(both.narrow(1, channels, channels) / 2);
    return (mean + spread * noise(mean.sizes()).to(mean.device())) * model.vae_config.scale;
}

ImageRgb8 Diffusion360::Parts::finish(Tensor start, nn::TextToPanorama how, nn::Scheduler& scheduler,
                                      const std::string& prompt, const Run& run, const Preview& preview) const {
    const std::string negative = settings.negative.empty() ? std::string(kDiffusion360Negative) : settings.negative;
    const Tensor text = model.read_prompt(diffusion360_prompt(prompt), negative, run);
    Progress progress(run, "panorama", settings.steps + 2);  // decoding takes about as long as two steps
    how.guidance = settings.guidance;
    how.seam = settings.published_seam ? nn::Seam::published : nn::Seam::closed;
    how.blend_columns = latent_width() / 32;
    how.noise = [&](int, const Tensor& like) { return noise(like.sizes()); };
    if (!settings.low_memory) how.replay = &replay;  // a record needs its weights where they were
    how.first_outputs = [&](const std::string& part, const Tensor& output) {
        nn::expect_finite(output, folder_of(part), model.options.type);
    };
    how.listener = [&](int, double, const Tensor&) {
        run.check_stop();  // replayed networks ask for no weights
        progress.advance();
    };
    how.preview = [&](int step, double, const Tensor& clean) {
        if (preview && is_preview_step(step, settings.steps))
            preview(nn::picture_of_unit(decode(at::avg_pool2d(clean, {2, 2}), run)));
    };
    nn::StoppableWeights weights(*model.unet, run);
    const Tensor latents = nn::text_to_panorama(Scope(weights), model.unet_config, scheduler, std::move(start), text,
                                                how);
    nn::expect_finite(latents, folder_of("unet"), model.options.type);
    const Tensor decoded = decode(latents, run);
    progress.advance(2);
    return nn::picture_of_unit(decoded);
}

Diffusion360::Diffusion360(const fs::path& weights, const Diffusion360Settings& settings, const Run& run, From from) {
    if (settings.width < 256 || settings.width % 128)
        throw UsageError("--panorama-width: expected a multiple of 128 from 256 for diffusion360, found {}",
                         settings.width);
    const c10::InferenceMode inference;
    use_our_threads();
    parts_ = std::make_unique<Parts>(weights, settings, from);
    (void)nn::make_scheduler(parts_->model.options.sampler, parts_->model.schedule,
                             settings.steps);  // throws if there are more steps than the schedule has
    parts_->estimate(run);
    parts_->model.check_shapes();
    if (parts_->control) parts_->control->check_shapes();
}
Diffusion360::~Diffusion360() = default;
Diffusion360::Diffusion360(Diffusion360&&) noexcept = default;

const Diffusion360Info& Diffusion360::info() const { return parts_->info; }

ImageRgb8 Diffusion360::paint(const std::string& prompt, const Run& run, const Preview& preview) const {
    const c10::InferenceMode inference;
    const Parts& p = *parts_;
    FASTSCENE_CHECK(!p.control);
    p.random = at::detail::createCPUGenerator(run.seed);
    const auto scheduler = nn::make_scheduler(p.model.options.sampler, p.model.schedule, p.settings.steps);
    const Tensor start = p.noise({1, p.model.vae_config.latent_channels, p.latent_width() / 2, p.latent_width()});
    return nn::fitting_the_card([&] { return p.finish(start, {}, *scheduler, prompt, run, preview); });
}

ImageRgb8 Diffusion360::paint_around(const ImageRgb8& photo, const std::string& prompt, const Run& run,
                                     const Preview& preview) const {
    const c10::InferenceMode inference;
    const Parts& p = *parts_;
    FASTSCENE_CHECK(p.control.has_value());
    p.random = at::detail::createCPUGenerator(run.seed);
    const auto scheduler = nn::make_scheduler(p.model.options.sampler, p.model.schedule, p.settings.steps);
    const nn::PhotoOnSphere placed = nn::photo_on_sphere(photo, p.settings.width, p.settings.photo_fov_deg);
    nn::TextToPanorama how;
    nn::StoppableWeights control(*p.control->weights, run);
    how.control = nn::Control{Scope(control), p.control->config, at::cat({placed.mask, placed.color}, 1), 1};
    how.noised = true;
    return nn::fitting_the_card([&] {
        const Tensor clean = p.encode(placed.color, run);
        return p.finish(scheduler->noised(clean, p.noise(clean.sizes()).to(clean.device()), 0), how, *scheduler, prompt,
                        run, preview);
    });
}

}  // namespace fastscene
