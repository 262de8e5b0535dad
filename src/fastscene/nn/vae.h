// Stable Diffusion's VAE: pictures of 8 h x 8 w pixels <-> latents of h x w. Keys and configuration as in diffusers'
// folder vae/ (AutoencoderKL). Private to nn/ (torch).
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/nn/scope.h"

namespace fastscene::nn {

struct VaeConfig {
    std::vector<std::int64_t> channels{128, 256, 512, 512};
    std::int64_t layers = 2, latent_channels = 4, groups = 32, sample_size = 512;
    double scale = 0.18215;  // latents of the U-Net = scale * latents of the encoder
    std::int64_t factor() const { return std::int64_t{1} << (channels.size() - 1); }
};
VaeConfig vae_config(const Json& json, const std::string& where);

// z [N, latent_channels, h, w], already divided by config.scale -> [N, 3, 8 h, 8 w] in [-1, 1].
at::Tensor vae_decode(const Scope& s, const VaeConfig& config, const at::Tensor& z);

struct Gaussian {
    at::Tensor mean, log_variance;
};
Gaussian vae_encode(const Scope& s, const VaeConfig& config, const at::Tensor& picture);

}  // namespace fastscene::nn
