// The U-Net of Stable Diffusion 1.x and 2.x (Rombach et al. 2022), and ControlNet (Zhang et al. 2023), a copy of its
// encoder with a conditioning picture. Keys and configuration as in diffusers' folders unet/ and controlnet. Private to
// nn/ (torch).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/nn/scope.h"

namespace fastscene::nn {

struct UNetConfig {
    std::int64_t in_channels = 4, out_channels = 4;
    std::vector<std::int64_t> channels;              // per level
    std::vector<bool> down_attention, up_attention;  // whether the level attends to the text
    std::vector<std::int64_t>
        heads;  // number per level, on the way down ("attention_head_dim" in the files, a misnomer)
    std::int64_t layers = 2, groups = 32, text_width = 768, down_pad = 1;
    double eps = 1e-5;  // of the residual blocks' group norms
    double frequency_shift = 0;
    bool cos_first = true, linear_projection = false, attention_in_float = false;
    // ControlNet only.
    std::int64_t picture_channels = 3;
    bool picture_reversed = false;  // its channels are in reverse order: blue, green, red
    std::vector<std::int64_t> picture_widths{16, 32, 96, 256};
};
// Parses config.json of a UNet2DConditionModel, or of a ControlNetModel, which has no decoder. `where` names it in
// errors. Throws Error for unsupported block types.
UNetConfig unet_config(const Json& json, const std::string& where);
UNetConfig controlnet_config(const Json& json, const std::string& where);

// What a ControlNet adds to the U-Net's skip connections and middle block.
struct Residuals {
    std::vector<at::Tensor> down;
    at::Tensor middle;
};

// A timestep as the networks read it: [N, channels[0]], for latents `like` [N, 4, H, W] at one timestep t.
at::Tensor waves_of_time(double t, const UNetConfig& config, const at::Tensor& like);
// latent [N, 4, H, W], text [N, L, text_width] -> predicted noise (or v) [N, 4, H, W].
at::Tensor unet(const Scope& s, const UNetConfig& config, const at::Tensor& latent, const at::Tensor& waves,
                const at::Tensor& text, const Residuals* add = nullptr);
at::Tensor unet(const Scope& s, const UNetConfig& config, const at::Tensor& latent, double t, const at::Tensor& text,
                const Residuals* add = nullptr);
// picture [N, picture_channels, 8 H, 8 W] in [0, 1].
Residuals controlnet(const Scope& s, const UNetConfig& config, const at::Tensor& latent, const at::Tensor& waves,
                     const at::Tensor& text, const at::Tensor& picture, double strength = 1);
Residuals controlnet(const Scope& s, const UNetConfig& config, const at::Tensor& latent, double t,
                     const at::Tensor& text, const at::Tensor& picture, double strength = 1);

}  // namespace fastscene::nn
