#include "fastscene/nn/sd_model.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/nn/panorama_loops.h"
#include "fastscene/nn/precision.h"
#include "fastscene/nn/shapes_only.h"
#include "fastscene/nn/stoppable.h"

namespace fastscene::nn {
namespace fs = std::filesystem;

using at::Tensor;

namespace {

constexpr float kLargestWeight = 1000;  // maximum weight of a word in a prompt; far larger ones overflow
constexpr const char* kWords = "text_model.embeddings.token_embedding.weight";

Json config_in(const fs::path& folder, const char* name = "config.json") {
    if (!fs::exists(folder / name)) throw Error("{}: expected {}, found none", folder.string(), name);
    return read_json(folder / name);
}

std::string with_article(const std::string& name) {
    return (std::string_view("AEIO").find(name.substr(0, 1)) == std::string_view::npos ? "a " : "an ") + name;
}

// Loads the configuration of a component and checks that it is of `kind`, if the file states it: diffusers writes
// "_class_name", transformers "architectures".
Json component_config(const fs::path& folder, const std::string& kind) {
    const Json json = config_in(folder);
    if (!json.is_object()) return json;  // the parser will complain
    Json name = json.value("_class_name", Json());
    if (const Json all = json.value("architectures", Json()); name.is_null() && all.is_array() && !all.empty())
        name = all[0];
    if (name.is_string() && name != kind && name != kind + "WithProjection")
        throw Error("{}: expected {}, found {} (components mixed up?)", (folder / "config.json").string(),
                    with_article(kind), with_article(name.get<std::string>()));
    return json;
}

// "[16 reading text, 32], layers_per_block 1, in_channels 4".
std::string outline(const UNetConfig& config) {
    std::string levels;
    for (std::size_t i = 0; i < config.channels.size(); ++i)
        levels += fmt::format("{}{}{}", i ? ", " : "", config.channels[i],
                              config.down_attention[i] ? " reading text" : "");
    return fmt::format("[{}], layers_per_block {}, in_channels {}", levels, config.layers, config.in_channels);
}

std::string family_of(std::int64_t text_width) {
    return text_width == 768    ? "Stable Diffusion 1.x"
           : text_width == 1024 ? "Stable Diffusion 2.x"
                                : fmt::format("a model that reads text of width {}", text_width);
}

}  // namespace

SdOptions sd_options(const std::string& precision, const std::string& device, Sampler sampler, bool low_memory,
                     bool encoder) {
    const at::Device where = device_named(device, "--panorama-device");
    return {type_of_precision(precision, where), where, sampler, !low_memory, encoder};
}

SdModel::SdModel(const fs::path& folder, const SdOptions& with) : base(folder), options(with) {
    unet_config = nn::unet_config(component_config(base / "unet", "UNet2DConditionModel"),
                                  (base / "unet/config.json").string());
    vae_config = nn::vae_config(component_config(base / "vae", "AutoencoderKL"), (base / "vae/config.json").string());
    tower = clip_text_tower(component_config(base / "text_encoder", "CLIPTextModel"),
                            (base / "text_encoder/config.json").string());
    schedule = schedule_config(config_in(base / "scheduler", "scheduler_config.json"),
                               (base / "scheduler/scheduler_config.json").string(), with.sampler);
    tokenizer = std::make_unique<ClipTokenizer>(base / "tokenizer");
    unet = std::make_unique<FileWeights>(base / "unet", at::TensorOptions(with.device).dtype(with.type), with.keep,
                                         "conv_in.weight");
    vae = std::make_unique<FileWeights>(base / "vae", at::TensorOptions(with.device).dtype(with.picture_type()),
                                        with.keep, "decoder.conv_in.weight");
    text = std::make_unique<FileWeights>(base / "text_encoder", at::TensorOptions(with.device).dtype(at::kFloat),
                                         with.keep, kWords);
    check_text();
    check_families();
}

void SdModel::check_text() const {
    if (tower.vocabulary <= ClipTokenizer::kEnd || tower.positions < ClipTokenizer::kContext)
        throw Error("{}: expected a \"vocab_size\" from {} and \"max_position_embeddings\" from {}, found {} and {}",
                    (base / "text_encoder/config.json").string(), ClipTokenizer::kEnd + 1, ClipTokenizer::kContext,
                    tower.vocabulary, tower.positions);
}

// The shapes in the files are decisive, whatever the configurations say.
void SdModel::check_families() const {
    const auto looks = unet->shape_of("down_blocks.0.attentions.0.transformer_blocks.0.attn2.to_k.weight");
    const auto words = text->shape_of(kWords);
    if (looks.size() == 2 && words.size() == 2 && looks[1] != words[1])
        throw Error(
            "{}: expected components of one model, found unet/ of {} (reads text of width {}) and text_encoder/ of {} "
            "(writes width {})",
            base.string(), family_of(looks[1]), looks[1], family_of(words[1]), words[1]);
    if (unet_config.text_width != tower.width)
        throw Error(
            "{}: expected unet/config.json and text_encoder/config.json to agree on the width of text, found "
            "cross_attention_dim {} and hidden_size {}",
            base.string(), unet_config.text_width, tower.width);
    if (unet_config.in_channels != vae_config.latent_channels || unet_config.out_channels != vae_config.latent_channels)
        throw Error(
            "{}: expected unet/ to turn {} latent channels (vae/) into as many, found {} to {} (an inpainting or depth "
            "model?)",
            base.string(), vae_config.latent_channels, unet_config.in_channels, unet_config.out_channels);
    if (vae_config.factor() != kPixelsPerLatent)
        throw Error("{}: expected a VAE of {} pixels per latent, found {}", (base / "vae").string(), kPixelsPerLatent,
                    vae_config.factor());
}

// Traverses every network with minimal input, so that missing or misshaped tensors are reported now and not after
// minutes.
void SdModel::check_shapes() const {
    ShapesOnly words(*text), denoiser(*unet), pictures(*vae);
    clip_text(Scope(words), tower, at::full({1, 2}, ClipTokenizer::kEnd, at::kLong));
    nn::unet(Scope(denoiser), unet_config, at::zeros({1, unet_config.in_channels, 8, 8}), 1,
             at::zeros({1, 2, unet_config.text_width}));
    vae_decode(Scope(pictures), vae_config, at::zeros({1, vae_config.latent_channels, 1, 1}));
    if (options.encoder) vae_encode(Scope(pictures), vae_config, at::zeros({1, 3, kPixelsPerLatent, kPixelsPerLatent}));
    denoiser.expect_all_of({"down_blocks.", "mid_block.", "up_blocks.", "class_embedding.", "add_embedding."});
    pictures.expect_all_of({"decoder."});
}

Tensor SdModel::read_prompt(const std::string& prompt, const std::string& negative, const Run& run) const {
    const std::vector<std::string> names{"the prompt", "the negative prompt"};
    std::vector<bool> cut;
    const auto tokens = weighted_tokens(*tokenizer, {prompt, negative}, tokenizer->pad(), &cut);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (cut[i])
            run.warn(
                fmt::format("{} is longer than {} tokens: the rest is ignored", names[i], kMaxChunks * kChunkTokens));
    if (const auto& added = tokenizer->unread(); !added.empty())
        run.warn(
            fmt::format("{}: {} pieces beyond CLIP's vocabulary, such as \"{}\", are not read: the model sees their "
                        "letters instead",
                        (base / "tokenizer/added_tokens.json").string(), added.size(), added.front()));
    for (std::size_t i = 0; i < names.size(); ++i)
        for (const float weight : tokens[i].weights)
            if (!(std::abs(weight) <= kLargestWeight))
                throw UsageError("{}: expected words weighted by up to {:g}, found {:g}", names[i], kLargestWeight,
                                 weight);
    StoppableWeights weights(*text, run);
    const Scope words(weights);
    const Tensor both = at::cat(
        {embed_prompt(words, tower, tokens[1]).states, embed_prompt(words, tower, tokens[0]).states}, 0);
    expect_finite(both, base / "text_encoder", at::kFloat);
    return both.to(options.device, options.type);
}

std::string SdModel::family() const { return family_of(unet_config.text_width); }

ControlModel::ControlModel(const fs::path& folder, const SdModel& model, std::int64_t channels)
    : config(nn::controlnet_config(component_config(folder, "ControlNetModel"), (folder / "config.json").string())),
      weights(std::make_unique<FileWeights>(folder, at::TensorOptions(model.options.device).dtype(model.options.type),
                                            model.options.keep, "conv_in.weight")) {
    if (config.text_width != model.unet_config.text_width)
        throw Error("{}: expected a ControlNet for {} of {}, found one for {}", folder.string(), model.family(),
                    model.base.string(), family_of(config.text_width));
    if (config.picture_channels != channels)
        throw Error("{}: expected a ControlNet that takes {} channels, found {} (the one for another task?)",
                    folder.string(), channels, config.picture_channels);
    const UNetConfig& other = model.unet_config;  // whose skip connections it adds to
    if (config.channels != other.channels || config.layers != other.layers ||
        config.down_attention != other.down_attention || config.in_channels != other.in_channels)
        throw Error("{}: expected a ControlNet with the levels of {} ({}), found {}", folder.string(),
                    (model.base / "unet").string(), outline(other), outline(config));
    if (const int widths = std::bit_width(static_cast<std::uint64_t>(kPixelsPerLatent));
        static_cast<int>(config.picture_widths.size()) != widths)
        throw Error(
            "{}: expected {} widths in \"conditioning_embedding_out_channels\" ({} pixels to a latent), found {}",
            (folder / "config.json").string(), widths, kPixelsPerLatent, config.picture_widths.size());
}

void ControlModel::check_shapes() const {
    ShapesOnly shapes(*weights);
    controlnet(Scope(shapes), config, at::zeros({1, config.in_channels, 8, 8}), 1, at::zeros({1, 2, config.text_width}),
               at::zeros({1, config.picture_channels, 8 * kPixelsPerLatent, 8 * kPixelsPerLatent}));
    shapes.expect_all_of({"down_blocks.", "mid_block.", "controlnet_", "class_embedding."});
}

Tensor without_overflow(std::unique_ptr<FileWeights>& weights, const Run& run,
                        const std::function<Tensor(const Scope&, at::ScalarType)>& make) {
    const auto made = [&] {
        StoppableWeights stoppable(*weights, run);
        const Tensor out = make(Scope(stoppable), weights->type());
        return out.is_cuda() ? out.to(at::kFloat) : out;
    };
    if (weights->type() == at::kHalf) {
        const Tensor found = made();
        if (at::isfinite(found).all().item<bool>()) return found;
        weights = weights->in_type(at::kFloat);
    }
    return made();
}

void expect_finite(const Tensor& output, const fs::path& component, at::ScalarType type) {
    if (at::isfinite(output).all().item<bool>()) return;
    throw Error("{}: expected finite network output, found NaN or infinity; are its weights complete{}?",
                component.string(),
                type == at::kFloat ? ""
                                   : fmt::format(", or are 16 bits too {} for them (--panorama-precision float)",
                                                 type == at::kHalf ? "narrow" : "coarse"));
}

Tensor unit_picture(const ImageRgb8& image, at::Device device) {
    const Tensor bytes =
        at::from_blob(const_cast<Rgb8*>(image.pixels.data()), {image.height, image.width, 3}, at::kByte).to(device);
    return (bytes.permute({2, 0, 1}).to(at::kFloat) / 255).unsqueeze(0).contiguous();
}

ImageRgb8 picture_of_unit(const Tensor& unit) {
    const Tensor bytes = at::round(at::clamp(unit[0], 0, 1) * 255).permute({1, 2, 0}).to(at::kByte).contiguous();
    ImageRgb8 out(static_cast<int>(bytes.size(1)), static_cast<int>(bytes.size(0)));
    at::from_blob(out.pixels.data(), bytes.sizes(), at::kByte).copy_(bytes);
    return out;
}

at::ScalarType type_of_precision(const std::string& name, at::Device device) {
    if (name == "float") return at::kFloat;
    if (name == "bf16") return at::kBFloat16;
    if (name != "fp16") throw UsageError("--panorama-precision: expected float, bf16 or fp16, found \"{}\"", name);
    // libtorch has no half-precision convolution on a CPU.
    if (device.is_cpu())
        throw UsageError(
            "--panorama-precision: expected float or bf16 on a CPU, found fp16 (a graphics card's: --panorama-device "
            "cuda)");
    return at::kHalf;
}

ImageRgb8 fitting_the_card(const std::function<ImageRgb8()>& make) {
    try {
        return make();
    } catch (const c10::OutOfMemoryError& error) {
        throw Error(
            "--panorama-device cuda: expected more memory on the graphics card ({}); use --panorama-precision fp16, "
            "--panorama-low-memory or "
            "--panorama-device cpu",
            error.what_without_backtrace());
    }
}

}  // namespace fastscene::nn
