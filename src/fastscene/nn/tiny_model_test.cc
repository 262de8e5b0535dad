#include "fastscene/nn/tiny_model.h"

#include <c10/core/InferenceMode.h>

#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/nn/clip.h"
#include "fastscene/nn/hashed.h"
#include "fastscene/nn/rrdbnet.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/tokenizer.h"
#include "fastscene/nn/unet.h"
#include "fastscene/nn/vae.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene {

namespace fs = std::filesystem;
using nn::HashedWeights;
using nn::Scope;

namespace {

void save(const HashedWeights& weights, const fs::path& file, const std::string& inside = "") {
    Weights out;
    for (const auto& [key, tensor] : weights.seen()) out.tensors[inside + key] = nn::weight_of(tensor);
    save_safetensors(file, out);
}

}  // namespace

void write_tiny_model(const fs::path& folder, const TinyModel& model) {
    const c10::InferenceMode inference;
    for (const char* part : {"unet", "vae", "text_encoder", "tokenizer", "scheduler"}) make_directories(folder / part);
    write_tiny_tokenizer(folder / "tokenizer");

    const Json unet = {{"_class_name", "UNet2DConditionModel"},
                       {"in_channels", 4},
                       {"out_channels", 4},
                       {"norm_num_groups", 8},
                       {"block_out_channels", {16, 32}},
                       {"layers_per_block", 1},
                       {"attention_head_dim", 4},
                       {"cross_attention_dim", model.denoiser_text_width},
                       {"down_block_types", {"CrossAttnDownBlock2D", "DownBlock2D"}},
                       {"up_block_types", {"UpBlock2D", "CrossAttnUpBlock2D"}}};
    write_json(folder / "unet/config.json", unet);
    HashedWeights denoiser(at::kFloat, model.salt);
    nn::unet(Scope(denoiser), nn::unet_config(unet, "unet"), at::zeros({1, 4, 4, 4}), 1,
             at::zeros({1, 2, model.denoiser_text_width}));
    save(denoiser, folder / "unet/diffusion_pytorch_model.safetensors");

    const Json vae = {{"_class_name", "AutoencoderKL"},
                      {"block_out_channels", {8, 8, 16, 16}},
                      {"layers_per_block", 1},
                      {"latent_channels", 4},
                      {"norm_num_groups", 4},
                      {"sample_size", model.sample_size},
                      {"down_block_types", Json::array({"DownEncoderBlock2D", "DownEncoderBlock2D",
                                                        "DownEncoderBlock2D", "DownEncoderBlock2D"})},
                      {"up_block_types",
                       Json::array({"UpDecoderBlock2D", "UpDecoderBlock2D", "UpDecoderBlock2D", "UpDecoderBlock2D"})}};
    write_json(folder / "vae/config.json", vae);
    HashedWeights decoder(at::kFloat, model.salt);
    nn::vae_decode(Scope(decoder), nn::vae_config(vae, "vae"), at::zeros({1, 4, 2, 2}));
    nn::vae_encode(Scope(decoder), nn::vae_config(vae, "vae"), at::zeros({1, 3, 8, 8}));
    save(decoder, folder / "vae/diffusion_pytorch_model.safetensors");

    const Json text = {{"hidden_size", model.encoder_text_width},
                       {"intermediate_size", 64},
                       {"num_hidden_layers", 1},
                       {"num_attention_heads", 2},
                       {"hidden_act", "quick_gelu"}};
    write_json(folder / "text_encoder/config.json", text);
    HashedWeights encoder(at::kFloat, model.salt);
    nn::clip_text(Scope(encoder), nn::clip_text_tower(text, "text"), at::full({1, 2}, ClipTokenizer::kEnd, at::kLong));
    save(encoder, folder / "text_encoder/model.safetensors");

    write_json(folder / "scheduler/scheduler_config.json", {{"_class_name", "PNDMScheduler"},
                                                            {"beta_start", 0.00085},
                                                            {"beta_end", 0.012},
                                                            {"beta_schedule", "scaled_linear"},
                                                            {"num_train_timesteps", 1000},
                                                            {"set_alpha_to_one", false},
                                                            {"steps_offset", 1},
                                                            {"prediction_type", model.prediction}});
}

void write_tiny_control(const fs::path& folder, int channels, int text_width) {
    const c10::InferenceMode inference;
    make_directories(folder);
    const Json config = {{"_class_name", "ControlNetModel"},
                         {"in_channels", 4},
                         {"norm_num_groups", 8},
                         {"block_out_channels", {16, 32}},
                         {"layers_per_block", 1},
                         {"attention_head_dim", 4},
                         {"cross_attention_dim", text_width},
                         {"down_block_types", {"CrossAttnDownBlock2D", "DownBlock2D"}},
                         {"conditioning_channels", channels},
                         {"conditioning_embedding_out_channels", {4, 4, 8, 8}}};
    write_json(folder / "config.json", config);
    HashedWeights weights;
    nn::controlnet(Scope(weights), nn::controlnet_config(config, "control"), at::zeros({1, 4, 4, 4}), 1,
                   at::zeros({1, 2, text_width}), at::zeros({1, channels, 32, 32}));
    save(weights, folder / "diffusion_pytorch_model.safetensors");
}

void write_tiny_enlarger(const fs::path& file) {
    const c10::InferenceMode inference;
    HashedWeights weights;
    nn::rrdbnet(Scope(weights), {8, 2, 4, 2}, at::zeros({1, 3, 4, 4}));
    save(weights, file, "params_ema.");
}

void save_in_parts(const fs::path& unet, fmt::format_string<int> part_name, const std::string& index) {
    const Weights all = load_weights(unet / "diffusion_pytorch_model.safetensors");
    Weights parts[2];
    Json map = Json::object();
    std::size_t i = 0;
    for (const auto& [key, tensor] : all.tensors) {
        const int part = 2 * i++ < all.tensors.size() ? 0 : 1;
        parts[part].tensors[key] = tensor;
        map[key] = fmt::format(part_name, part + 1);
    }
    for (int part = 0; part < 2; ++part) save_safetensors(unet / fmt::format(part_name, part + 1), parts[part]);
    write_json(unet / index, {{"weight_map", map}});
    fs::remove(unet / "diffusion_pytorch_model.safetensors");
}

}  // namespace fastscene
