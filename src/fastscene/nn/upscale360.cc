#include "fastscene/nn/upscale360.h"

#include <ATen/CPUGeneratorImpl.h>
#include <c10/core/InferenceMode.h>

#include <algorithm>
#include <optional>

#include "fastscene/nn/clip_image.h"
#include "fastscene/nn/diffusion360.h"
#include "fastscene/nn/diffusion_memory.h"
#include "fastscene/nn/panorama_loops.h"
#include "fastscene/nn/replay.h"
#include "fastscene/nn/rrdbnet.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/nn/sd_model.h"
#include "fastscene/nn/shapes_only.h"
#include "fastscene/nn/sphere_tiles.h"
#include "fastscene/nn/stoppable.h"

namespace fastscene {
namespace fs = std::filesystem;

using at::Tensor;
using nn::kPixelsPerLatent;
using nn::Scope;

namespace {

constexpr std::int64_t kEnlargeTile = 384,
                       kEnlargeOverlap = 40;  // pixels; as published, where tiles extend 20 pixels beyond their ends

constexpr std::int64_t kTilesOfACard = 4;  // one tile leaves a large card idle in the deeper levels

// Real-ESRGAN's configuration, derived from its file.
nn::RrdbConfig rrdb_config(const nn::FileWeights& file) {
    nn::RrdbConfig config;
    const auto first = file.shape_of("conv_first.weight"), dense = file.shape_of("body.0.rdb1.conv1.weight");
    if (first.size() != 4 || dense.size() != 4 || first[1] != 12)
        throw Error("{}: expected Real-ESRGAN for twice the size (conv_first.weight of 12 channels), found {}",
                    file.path().string(), text_of_shape(first));
    config.features = first[0];
    config.growth = dense[0];
    config.scale = 2;
    for (config.blocks = 0; file.has(fmt::format("body.{}.rdb1.conv1.weight", config.blocks));) ++config.blocks;
    return config;
}

// The prompt template without its panorama keywords.
std::string larger_prompt(const std::string& prompt) {
    const std::string all = diffusion360_prompt(prompt), own = "<360panorama>, ";
    return all.starts_with(own) ? all.substr(own.size()) : all;
}

// Upscales by 3 with Pillow's bicubic filter as published, but with circular padding.
ImageRgb8 tripled(const ImageRgb8& image) {
    constexpr int beyond = 4;  // columns; the kernel's radius is 2
    ImageRgb8 wide(image.width + 2 * beyond, image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < wide.width; ++x) wide.at(x, y) = image.at((x - beyond + image.width) % image.width, y);
    const ImageRgb8 large = pillow_bicubic(wide, 3 * wide.width, 3 * wide.height);
    ImageRgb8 out(3 * image.width, 3 * image.height);
    for (int y = 0; y < out.height; ++y) std::copy_n(large.row(y) + 3 * beyond, out.width, out.row(y));
    return out;
}

fs::path needed_folder(const fs::path& weights, const char* name) {
    if (!fs::is_directory(weights / name))
        throw Error("--panorama-upscale: expected {}/ in {}, found none (fastscene models pull diffusion360-upscale)",
                    name, weights.string());
    return weights / name;
}

}  // namespace

struct Upscale360::Parts {
    Upscale360Settings settings;
    mutable nn::SdModel model;  // its weights are read on first use
    nn::ControlModel control;
    mutable std::unique_ptr<nn::FileWeights> larger;
    nn::RrdbConfig larger_config;
    mutable nn::Replay painting, enlarging;
    mutable at::Generator random;

    Parts(const fs::path& weights, const Upscale360Settings& s)
        : settings(s),
          model(needed_folder(weights, "sr-base"),
                nn::sd_options(s.precision, s.device, nn::Sampler::unipc, s.low_memory, true)),
          control(needed_folder(weights, "sr-control"), model, 3) {
        if (s.to == "3") return;
        if (!fs::exists(weights / "RealESRGAN_x2plus.pth"))
            throw Error(
                "--panorama-upscale {}: expected RealESRGAN_x2plus.pth in {}, found none (fastscene models pull "
                "diffusion360-upscale)",
                s.to, weights.string());
        // The official file has all tensors inside "params_ema".
        larger = std::make_unique<nn::FileWeights>(
            weights / "RealESRGAN_x2plus.pth",
            at::TensorOptions(model.options.device).dtype(model.options.picture_type()), !s.low_memory,
            "conv_first.weight");
        larger_config = rrdb_config(*larger);
    }
    void check_shapes() const {
        model.check_shapes();
        control.check_shapes();
        if (!larger) return;
        nn::ShapesOnly shapes(*larger);
        nn::rrdbnet(Scope(shapes), larger_config, at::zeros({1, 3, 4, 4}));
        shapes.expect_all_of({"body.", "conv_"});
    }
    Tensor noise(at::IntArrayRef shape) const { return at::randn(shape, random, at::TensorOptions(at::kFloat)); }
    nn::SphereTiles tiles(std::int64_t in, std::int64_t out) const {
        const std::int64_t tile = model.vae_config.sample_size / kPixelsPerLatent;
        return {tile, tile / 4, in, out, {}};
    }
    fs::path folder_of(const std::string& part) const {
        return part == "control" ? control.weights->path() : model.base / part;
    }
    ImageRgb8 painted_anew(const ImageRgb8& picture, const std::string& prompt, double guidance, const Run& run) const;
    ImageRgb8 doubled(const ImageRgb8& picture, const Run& run) const;
};

ImageRgb8 Upscale360::Parts::painted_anew(const ImageRgb8& picture, const std::string& prompt, double guidance,
                                          const Run& run) const {
    nn::StoppableWeights unet(*model.unet, run), holding(*control.weights, run);
    // a generator per stage: any stage may be the first one of a resumed run
    random = at::detail::createCPUGenerator(run.seed);
    const at::Device there = model.options.device;
    const Tensor unit = nn::unit_picture(picture, there),
                 text = model.read_prompt(
                     larger_prompt(prompt),
                     settings.negative.empty() ? std::string(kDiffusion360Negative) : settings.negative, run);
    const Tensor both = nn::without_overflow(model.vae, run, [&](const Scope& s, at::ScalarType type) {
        return nn::over_sphere((unit * 2 - 1).to(type), tiles(kPixelsPerLatent, 1), [&](const Tensor& part) {
            const nn::Gaussian found = nn::vae_encode(s, model.vae_config, part);
            return at::cat({found.mean, found.log_variance}, 1);
        });
    });
    nn::expect_finite(both, folder_of("vae"), model.options.type);
    const std::int64_t channels = model.vae_config.latent_channels;
    const Tensor mean = both.narrow(1, 0, channels),
                 clean = (mean + at::exp(both.narrow(1, channels, channels) / 2) * noise(mean.sizes()).to(there)) *
                         model.vae_config.scale;
    const auto scheduler = nn::make_scheduler(model.options.sampler, model.schedule, settings.steps);
    nn::RefinePanorama how;
    how.guidance = guidance;
    how.tile = std::min(settings.tile / kPixelsPerLatent, clean.size(2) / 2 * 2);  // no taller than the picture
    how.first_step = settings.steps - std::min(static_cast<int>(settings.steps * settings.strength), settings.steps);
    // Few tiles at a time bound memory; the result is that of published rows.
    how.batch = there.is_cuda() && !settings.low_memory ? kTilesOfACard : 1;
    if (!settings.low_memory) how.replay = &painting;  // a record needs its weights where they were
    how.first_outputs = [&](const std::string& part, const Tensor& output) {
        nn::expect_finite(output, folder_of(part), model.options.type);
    };
    Progress progress(run, fmt::format("larger {} x {}", picture.width, picture.height),
                      settings.steps - how.first_step + 1);
    how.listener = [&](int, double, const Tensor&) {
        run.check_stop();  // replayed networks ask for no weights
        progress.advance();
    };
    const Tensor latents = nn::refine_panorama(
        Scope(unet), model.unet_config, Scope(holding), control.config, *scheduler,
        scheduler->noised(clean, noise(clean.sizes()).to(there), how.first_step), unit, text, how);
    nn::expect_finite(latents, folder_of("unet"), model.options.type);
    const Tensor decoded = nn::without_overflow(model.vae, run, [&](const Scope& s, at::ScalarType type) {
        return nn::over_sphere((latents / model.vae_config.scale).to(type), tiles(1, kPixelsPerLatent),
                               [&](const Tensor& part) { return nn::vae_decode(s, model.vae_config, part); });
    });
    nn::expect_finite(decoded, folder_of("vae"), model.options.type);
    progress.advance();
    return nn::picture_of_unit(decoded / 2 + 0.5);
}

ImageRgb8 Upscale360::Parts::doubled(const ImageRgb8& picture, const Run& run) const {
    std::optional<Progress> progress;
    nn::SphereTiles how{kEnlargeTile, kEnlargeOverlap, 1, 2, {}};
    how.heard = [&](std::int64_t, std::int64_t total) {
        run.check_stop();
        if (!progress)
            progress.emplace(run, fmt::format("larger {} x {}", 2 * picture.width, 2 * picture.height), total);
        progress->advance();
    };
    const Tensor unit = nn::unit_picture(picture, model.options.device);
    const Tensor enlarged = nn::without_overflow(larger, run, [&](const Scope& s, at::ScalarType type) {
        const auto net = [&](const std::vector<Tensor>& in) { return nn::rrdbnet(s, larger_config, in[0]); };
        return nn::over_sphere(unit.to(type), how, [&](const Tensor& part) {
            return settings.low_memory ? net({part}) : enlarging({part}, net);
        });
    });
    nn::expect_finite(enlarged, larger->path(), at::kFloat);
    return nn::picture_of_unit(enlarged);
}

Upscale360::Upscale360(const fs::path& weights, int width, const Upscale360Settings& settings, const Run& run) {
    if (settings.to != "3" && settings.to != "6" && settings.to != "6-refined")
        throw UsageError("--panorama-upscale: expected none, 3, 6 or 6-refined, found \"{}\"", settings.to);
    const c10::InferenceMode inference;
    use_our_threads();
    parts_ = std::make_unique<Parts>(weights, settings);
    const Parts& p = *parts_;
    // A tile takes as much memory as a 1024 x 512 panorama; the full pictures are held besides.
    const std::int64_t pixels = 36ll * width * (width / 2);
    const std::int64_t need = diffusion_memory({1024, settings.low_memory, p.model.unet->bytes(), p.model.vae->bytes(),
                                                p.model.text->bytes(), p.control.weights->bytes(),
                                                p.model.unet->largest_bytes(), true}) +
                              (settings.to == "3" ? pixels / 4 : pixels) * 40;
    run.note(fmt::format("diffusion360: upscaling by {} needs about {} of memory", settings.to, gib_text(need)));
    if (!p.model.options.device.is_cuda())  // CUDA reports by itself when its memory is full
        check_memory("--panorama-upscale " + settings.to, need,
                     fmt::format("{}{}", settings.low_memory ? "" : ", use --panorama-low-memory",
                                 settings.to == "3" ? "" : ", use --panorama-upscale 3"));
    p.check_shapes();
}
Upscale360::~Upscale360() = default;
Upscale360::Upscale360(Upscale360&&) noexcept = default;

ImageRgb8 Upscale360::enlarge(const ImageRgb8& panorama, const std::string& prompt, const Run& run,
                              const Keep& keep) const {
    const c10::InferenceMode inference;
    const Parts& p = *parts_;
    const auto step = [&](const std::string& to, const std::function<ImageRgb8()>& make) {
        const auto fitting = [&] { return nn::fitting_the_card(make); };
        return keep ? keep(to, fitting) : fitting();
    };
    ImageRgb8 picture = step("3", [&] { return p.painted_anew(tripled(panorama), prompt, p.settings.guidance, run); });
    if (p.settings.to == "3") return picture;
    picture = step("6", [&] { return p.doubled(picture, run); });
    if (p.settings.to == "6") return picture;
    return step("6-refined", [&] { return p.painted_anew(picture, prompt, p.settings.refined_guidance, run); });
}

// Cost in units of U-Net steps on a tile's latents. From Stable Diffusion 1.5's layer sizes: the ControlNet costs 0.4
// of the U-Net, encoding and decoding a panorama 3 steps, doubling its width with Real-ESRGAN 2.
double times_the_painting(int width, int painting_steps, const Upscale360Settings& settings) {
    constexpr double control = 1.4, coding = 3, doubling = 2, decoder = 2, overlap = 1.8;
    const double painting = painting_steps + decoder;
    const auto painted_anew = [&](int times) {
        const std::int64_t rows = std::int64_t{times} * width / 2 / kPixelsPerLatent,
                           half = std::min<std::int64_t>(settings.tile / kPixelsPerLatent, rows) / 2;
        const double tiles = static_cast<double>(std::max<std::int64_t>((rows - 1) / half, 1) *
                                                 ((2 * rows + half - 1) / half));
        const double of_painting = tiles * static_cast<double>(4 * half * half) /
                                   (static_cast<double>(width) * width / 2 / kPixelsPerLatent / kPixelsPerLatent);
        return control * of_painting * static_cast<int>(settings.steps * settings.strength) +
               coding * overlap * times * times;
    };
    const double steps = painted_anew(3) + (settings.to == "3" ? 0 : doubling * 9) +
                         (settings.to == "6-refined" ? painted_anew(6) : 0);
    return steps / painting;
}

}  // namespace fastscene
