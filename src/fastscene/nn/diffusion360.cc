#include "fastscene/nn/diffusion360.h"

#include <ATen/CPUGeneratorImpl.h>
#include <c10/core/InferenceMode.h>

#include <algorithm>
#include <fstream>
#include <optional>

#include "fastscene/nn/circular.h"
#include "fastscene/nn/file_weights.h"
#include "fastscene/nn/panorama_loops.h"
#include "fastscene/nn/runtime.h"

namespace fastscene {
namespace fs = std::filesystem;

using at::Tensor;
using nn::FileWeights;
using nn::Scope;

const std::string_view kDiffusion360Negative =
    "persons, complex texture, small objects, sheltered, blur, worst quality, low quality, zombie, logo, text, watermark, username, monochrome, complex lighting";

std::string diffusion360_prompt(const std::string& prompt) {
    return "<360panorama>, " + prompt + ", photorealistic, trend on artstation, ((best quality)), ((ultra high res))";
}

namespace {

constexpr std::int64_t kFactor = 8;  // pixels per latent

fs::path base_of(const fs::path& weights) {
    if (!fs::is_directory(weights)) throw Error("--weights {}: expected a folder with unet/ vae/ text_encoder/ tokenizer/ scheduler/, found none", weights.string());
    const fs::path base = !fs::exists(weights / "unet") && fs::exists(weights / "sd-base") ? weights / "sd-base" : weights;
    std::string missing;
    for (const char* part : {"unet", "vae", "text_encoder", "tokenizer", "scheduler"})
        if (!fs::is_directory(base / part)) missing += (missing.empty() ? "" : ", ") + std::string(part) + "/";
    if (!missing.empty()) throw Error("--weights {}: expected a model as diffusers saves it, found no {}", base.string(), missing);
    return base;
}

Json config_in(const fs::path& folder, const char* name = "config.json") {
    if (!fs::exists(folder / name)) throw Error("{}: expected {}, found none", folder.string(), name);
    return read_json(folder / name);
}

std::string family_of(std::int64_t text_width) {
    return text_width == 768 ? "Stable Diffusion 1.x" : text_width == 1024 ? "Stable Diffusion 2.x" : fmt::format("a model that reads text of width {}", text_width);
}

// Stands for weights when only names and shapes matter: holds them against the file and hands out zeros that take no memory.
class ShapesOnly final : public nn::WeightSource {
  public:
    explicit ShapesOnly(const FileWeights& file) : file_(file) {}
    Tensor get(const std::string& key, at::IntArrayRef shape) override {
        file_.check(key, shape);
        return at::zeros({}, at::kFloat).expand(shape);
    }
    bool has(const std::string& key) const override { return file_.has(key); }

  private:
    const FileWeights& file_;
};

double available_bytes() {
    std::ifstream info("/proc/meminfo");
    for (std::string word; info >> word;)
        if (word == "MemAvailable:") {
            double kib = 0;
            info >> kib;
            return kib * 1024;
        }
    return 0;
}
std::string gib(double bytes) { return fmt::format("{:.1f} GiB", bytes / (1 << 30)); }

nn::Sampler sampler_named(const std::string& name) {
    if (name == "euler-ancestral") return nn::Sampler::euler_ancestral;
    if (name == "ddim") return nn::Sampler::ddim;
    if (name == "unipc") return nn::Sampler::unipc;
    throw UsageError("--panorama-sampler: expected euler-ancestral, ddim or unipc, found \"{}\"", name);
}

// Latents as colors by the slopes that fit Stable Diffusion's decoder: a glance, not a picture.
ImageRgb8 glance(const Tensor& latents) {
    const Tensor slopes = at::tensor(std::vector<double>{.298, .207, .208, .187, .286, .173, -.158, .189, .264, -.184, -.271, -.473}, at::kFloat).reshape({4, 3});
    const Tensor color = latents[0].permute({1, 2, 0}).to(at::kFloat).matmul(slopes);
    const Tensor bytes = at::clamp((color / 2 + 0.5) * 255, 0, 255).to(at::kByte).contiguous();
    ImageRgb8 out(static_cast<int>(bytes.size(1)), static_cast<int>(bytes.size(0)));
    std::copy_n(reinterpret_cast<const Rgb8*>(bytes.data_ptr<std::uint8_t>()), out.size(), out.pixels.data());
    return out;
}

ImageRgb8 picture_of(const Tensor& decoded) {
    const Tensor bytes = at::round(at::clamp(decoded[0] / 2 + 0.5, 0, 1) * 255).permute({1, 2, 0}).to(at::kByte).contiguous();
    ImageRgb8 out(static_cast<int>(bytes.size(1)), static_cast<int>(bytes.size(0)));
    std::copy_n(reinterpret_cast<const Rgb8*>(bytes.data_ptr<std::uint8_t>()), out.size(), out.pixels.data());
    return out;
}

}  // namespace

struct Diffusion360::Parts {
    Diffusion360Settings settings;
    Diffusion360Info info;
    fs::path base;
    at::TensorOptions options;
    nn::UNetConfig unet_config;
    nn::VaeConfig vae_config;
    nn::ClipTower tower;
    nn::ScheduleConfig schedule;
    nn::Sampler sampler{};
    std::unique_ptr<ClipTokenizer> tokenizer;
    std::unique_ptr<FileWeights> unet, vae, text;

    void open();
    void check_families() const;
    void check_shapes();
    void estimate(const Run& run);
};

void Diffusion360::Parts::open() {
    unet_config = nn::unet_config(config_in(base / "unet"), (base / "unet/config.json").string());
    vae_config = nn::vae_config(config_in(base / "vae"), (base / "vae/config.json").string());
    tower = nn::clip_tower(config_in(base / "text_encoder"), (base / "text_encoder/config.json").string());
    schedule = nn::schedule_config(config_in(base / "scheduler", "scheduler_config.json"), (base / "scheduler/scheduler_config.json").string(), sampler);
    tokenizer = std::make_unique<ClipTokenizer>(base / "tokenizer");
    unet = std::make_unique<FileWeights>(base / "unet", options);
    vae = std::make_unique<FileWeights>(base / "vae", at::kFloat);  // a 16-bit decoder overflows on some pictures
    text = std::make_unique<FileWeights>(base / "text_encoder", at::kFloat);
}

// The shapes in the files decide, whatever the configurations say.
void Diffusion360::Parts::check_families() const {
    const auto looks = unet->shape_of("down_blocks.0.attentions.0.transformer_blocks.0.attn2.to_k.weight");
    const auto words = text->shape_of("text_model.embeddings.token_embedding.weight");
    if (looks.size() == 2 && words.size() == 2 && looks[1] != words[1])
        throw Error("{}: expected components of one model, found unet/ of {} (reads text of width {}) and text_encoder/ of {} (writes width {})", base.string(),
                    family_of(looks[1]), looks[1], family_of(words[1]), words[1]);
    if (unet_config.text_width != tower.width)
        throw Error("{}: expected unet/config.json and text_encoder/config.json to agree on the width of text, found cross_attention_dim {} and hidden_size {}",
                    base.string(), unet_config.text_width, tower.width);
    if (unet_config.in_channels != vae_config.latent_channels || unet_config.out_channels != vae_config.latent_channels)
        throw Error("{}: expected unet/ to turn {} latent channels (vae/) into as many, found {} to {} (an inpainting or depth model?)", base.string(),
                    vae_config.latent_channels, unet_config.in_channels, unet_config.out_channels);
    if (vae_config.factor() != kFactor) throw Error("{}: expected a VAE of {} pixels per latent, found {}", (base / "vae").string(), kFactor, vae_config.factor());
}

// Walks through every network at its smallest, so that a missing or misshaped tensor is told now and not after minutes.
void Diffusion360::Parts::check_shapes() {
    ShapesOnly words(*text), denoiser(*unet), decoder(*vae);
    nn::clip_text(Scope(words), tower, at::full({1, 2}, ClipTokenizer::kEnd, at::kLong));
    nn::unet(Scope(denoiser), unet_config, at::zeros({1, unet_config.in_channels, 8, 8}), 1, at::zeros({1, 2, unet_config.text_width}));
    nn::vae_decode(Scope(decoder), vae_config, at::zeros({1, vae_config.latent_channels, 1, 1}));
}

void Diffusion360::Parts::estimate(const Run& run) {
    info.family = family_of(unet_config.text_width);
    info.prediction = schedule.prediction == nn::Prediction::noise ? "epsilon" : "v_prediction";
    info.parameters = unet->bytes() / options.dtype().itemsize();
    const double pixels = 0.5 * settings.width * settings.width;
    // Working memory as measured at 1024 x 512, which grows with the area: denoiser 1.6 GiB, decoder 3.2 GiB.
    const double share = pixels / (1024.0 * 512), giga = 1 << 30;
    const double denoise = static_cast<double>(unet->bytes()) + (settings.low_memory ? 0 : static_cast<double>(text->bytes())) + 1.6 * giga * share;
    const double decode = static_cast<double>(vae->bytes()) + (settings.low_memory ? 0 : static_cast<double>(unet->bytes() + text->bytes())) + 3.2 * giga * share;
    info.peak_bytes = static_cast<std::int64_t>(std::max(denoise, decode) + 0.3 * giga);
    const double need = static_cast<double>(info.peak_bytes), have = available_bytes();
    run.note(fmt::format("diffusion360: {}, {:.0f} million parameters, needs about {} of memory ({} available)", info.family, static_cast<double>(info.parameters) / 1e6,
                         gib(need), gib(have)));
    if (have > 0 && !(need <= have))
        throw Error("diffusion360: expected {} of free memory for {} x {} in {}, found {}; close programs{}{}, or make it smaller with --panorama-width", gib(need),
                    settings.width, settings.width / 2, settings.precision, gib(have), settings.low_memory ? "" : ", use --panorama-low-memory",
                    settings.precision == "bf16" ? "" : ", use --panorama-precision bf16");
}

Diffusion360::Diffusion360(const fs::path& weights, const Diffusion360Settings& settings, const Run& run) : parts_(std::make_unique<Parts>()) {
    if (settings.width < 256 || settings.width % 128) throw UsageError("--panorama-width: expected a multiple of 128 from 256 for diffusion360, found {}", settings.width);
    if (settings.precision != "float" && settings.precision != "bf16") throw UsageError("--panorama-precision: expected float or bf16, found \"{}\"", settings.precision);
    const c10::InferenceMode inference;
    use_our_threads();
    Parts& p = *parts_;
    p.settings = settings;
    p.base = base_of(weights);
    p.options = settings.precision == "bf16" ? at::kBFloat16 : at::kFloat;
    p.sampler = sampler_named(settings.sampler);
    p.open();
    p.check_families();
    p.check_shapes();
    p.estimate(run);
}
Diffusion360::~Diffusion360() = default;

const Diffusion360Info& Diffusion360::info() const { return parts_->info; }

ImageRgb8 Diffusion360::paint(const std::string& prompt, const Run& run, const Preview& preview) const {
    const c10::InferenceMode inference;
    Parts& p = *parts_;
    bool cut = false;
    const std::string negative = p.settings.negative.empty() ? std::string(kDiffusion360Negative) : p.settings.negative;
    const auto tokens = weighted_tokens(*p.tokenizer, {diffusion360_prompt(prompt), negative}, p.tokenizer->pad(), &cut);
    if (cut) run.warn(fmt::format("the prompt is longer than {} tokens: what lies beyond is not read", kMaxChunks * kChunkTokens));
    const Scope words(*p.text);
    const Tensor text = at::cat({nn::embed_prompt(words, p.tower, tokens[1]).states, nn::embed_prompt(words, p.tower, tokens[0]).states}, 0).to(p.options);
    if (p.settings.low_memory) p.text->release();

    at::Generator random = at::detail::createCPUGenerator(run.seed);
    const auto scheduler = nn::make_scheduler(p.sampler, p.schedule, p.settings.steps);
    Progress progress(run, "panorama", p.settings.steps + 2);  // the decoder takes about as long as two steps
    nn::TextToPanorama how;
    how.guidance = p.settings.guidance;
    how.seam = p.settings.published_seam ? nn::Seam::published : nn::Seam::closed;
    how.blend_columns = p.settings.width / kFactor / 32;
    how.noise = [&](int, const Tensor& like) { return at::randn(like.sizes(), random, at::TensorOptions(at::kFloat)); };
    how.check_stop = [&] { run.check_stop(); };
    how.listener = [&](int, double, const Tensor& latents) {
        progress.advance();
        if (preview) preview(glance(latents.narrow(3, 0, p.settings.width / kFactor)));
    };
    const Tensor start = at::randn({1, p.vae_config.latent_channels, p.settings.width / 2 / kFactor, p.settings.width / kFactor}, random, at::TensorOptions(at::kFloat));
    const Tensor latents = nn::text_to_panorama(Scope(*p.unet), p.unet_config, *scheduler, start, text, how);
    if (p.settings.low_memory) p.unet->release();

    run.check_stop();
    const std::int64_t tile = p.vae_config.sample_size / kFactor;
    const Tensor decoded = nn::circular_decode(Scope(*p.vae), p.vae_config, latents / p.vae_config.scale, tile);
    if (!at::isfinite(decoded).all().item<bool>())
        throw Error("diffusion360: expected a picture, found values that are not finite; are the weights in {} whole{}?", p.base.string(),
                    p.settings.precision == "bf16" ? ", or is bf16 too coarse for them (--panorama-precision float)" : "");
    progress.advance(2);
    return picture_of(decoded);
}

}  // namespace fastscene
