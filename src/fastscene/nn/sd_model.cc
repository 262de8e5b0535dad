#include "fastscene/nn/sd_model.h"

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/nn/panorama_loops.h"

namespace fastscene::nn {
namespace fs = std::filesystem;

using at::Tensor;

namespace {

Json config_in(const fs::path& folder, const char* name = "config.json") {
    if (!fs::exists(folder / name)) throw Error("{}: expected {}, found none", folder.string(), name);
    return read_json(folder / name);
}

std::string family_of(std::int64_t text_width) {
    return text_width == 768 ? "Stable Diffusion 1.x" : text_width == 1024 ? "Stable Diffusion 2.x" : fmt::format("a model that reads text of width {}", text_width);
}

// Stands for weights when only names and shapes matter: holds them against the file and hands out zeros that take no memory.
class ShapesOnly final : public WeightSource {
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

}  // namespace

SdModel::SdModel(const fs::path& folder, const SdOptions& with) : base(folder), options(with) {
    unet_config = nn::unet_config(config_in(base / "unet"), (base / "unet/config.json").string());
    vae_config = nn::vae_config(config_in(base / "vae"), (base / "vae/config.json").string());
    tower = clip_text_tower(config_in(base / "text_encoder"), (base / "text_encoder/config.json").string());
    schedule = schedule_config(config_in(base / "scheduler", "scheduler_config.json"), (base / "scheduler/scheduler_config.json").string(), with.sampler);
    tokenizer = std::make_unique<ClipTokenizer>(base / "tokenizer");
    unet = std::make_unique<FileWeights>(base / "unet", with.type, with.keep);
    vae = std::make_unique<FileWeights>(base / "vae", at::kFloat, with.keep);  // a 16-bit decoder overflows on some pictures
    text = std::make_unique<FileWeights>(base / "text_encoder", at::kFloat, with.keep);
    check_families();
    check_shapes();
}

// The shapes in the files decide, whatever the configurations say.
void SdModel::check_families() const {
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
    if (vae_config.factor() != kPixelsPerLatent)
        throw Error("{}: expected a VAE of {} pixels per latent, found {}", (base / "vae").string(), kPixelsPerLatent, vae_config.factor());
}

// Walks through every network at its smallest, so that a missing or misshaped tensor is told now and not after minutes.
void SdModel::check_shapes() const {
    ShapesOnly words(*text), denoiser(*unet), pictures(*vae);
    clip_text(Scope(words), tower, at::full({1, 2}, ClipTokenizer::kEnd, at::kLong));
    nn::unet(Scope(denoiser), unet_config, at::zeros({1, unet_config.in_channels, 8, 8}), 1, at::zeros({1, 2, unet_config.text_width}));
    vae_decode(Scope(pictures), vae_config, at::zeros({1, vae_config.latent_channels, 1, 1}));
    if (options.encoder) vae_encode(Scope(pictures), vae_config, at::zeros({1, 3, kPixelsPerLatent, kPixelsPerLatent}));
}

Tensor SdModel::read_prompt(const std::string& prompt, const std::string& negative, const Run& run) const {
    bool cut = false;
    const auto tokens = weighted_tokens(*tokenizer, {prompt, negative}, tokenizer->pad(), &cut);
    if (cut) run.warn(fmt::format("the prompt is longer than {} tokens: what lies beyond is not read", kMaxChunks * kChunkTokens));
    const Scope words(*text);
    return at::cat({embed_prompt(words, tower, tokens[1]).states, embed_prompt(words, tower, tokens[0]).states}, 0).to(options.type);
}

std::string SdModel::family() const { return family_of(unet_config.text_width); }

ControlModel::ControlModel(const fs::path& folder, const SdModel& model, std::int64_t channels)
    : config(nn::unet_config(config_in(folder), (folder / "config.json").string())),
      weights(std::make_unique<FileWeights>(folder, model.options.type, model.options.keep)) {
    if (config.text_width != model.unet_config.text_width)
        throw Error("{}: expected a ControlNet for {} of {}, found one for {}", folder.string(), model.family(), model.base.string(), family_of(config.text_width));
    if (config.picture_channels != channels)
        throw Error("{}: expected a ControlNet that takes {} channels, found {} (the one for another task?)", folder.string(), channels, config.picture_channels);
    ShapesOnly shapes(*weights);
    controlnet(Scope(shapes), config, at::zeros({1, config.in_channels, 8, 8}), 1, at::zeros({1, 2, config.text_width}),
               at::zeros({1, channels, 8 * kPixelsPerLatent, 8 * kPixelsPerLatent}));
}

Tensor unit_picture(const ImageRgb8& image) {
    const Tensor bytes = at::from_blob(const_cast<Rgb8*>(image.pixels.data()), {image.height, image.width, 3}, at::kByte);
    return (bytes.permute({2, 0, 1}).to(at::kFloat) / 255).unsqueeze(0).contiguous();
}

ImageRgb8 picture_of_unit(const Tensor& unit) {
    const Tensor bytes = at::round(at::clamp(unit[0], 0, 1) * 255).permute({1, 2, 0}).to(at::kByte).contiguous();
    ImageRgb8 out(static_cast<int>(bytes.size(1)), static_cast<int>(bytes.size(0)));
    std::copy_n(reinterpret_cast<const Rgb8*>(bytes.data_ptr<std::uint8_t>()), out.size(), out.pixels.data());
    return out;
}

at::ScalarType type_of_precision(const std::string& name) {
    if (name == "float") return at::kFloat;
    if (name == "bf16") return at::kBFloat16;
    throw UsageError("--panorama-precision: expected float or bf16, found \"{}\"", name);
}

}  // namespace fastscene::nn
