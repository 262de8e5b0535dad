// A model folder as diffusers saves it, small enough for tests: random weights, a vocabulary of made-up merges.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/nn/tiny_tokenizer.h"

namespace fastscene {

// unet/ vae/ text_encoder/ tokenizer/ scheduler/. `text_width` of the denoiser and of the text encoder may differ: a mixed-up folder.
struct TinyModel {
    int denoiser_text_width = 32, encoder_text_width = 32;
    std::string prediction = "epsilon";
    std::string salt = {};   // other weights
    int sample_size = 64;    // pixels that the VAE decodes at once
};
void write_tiny_model(const std::filesystem::path& folder, const TinyModel& model = {});
// A ControlNet for such a model; `channels` of the picture it holds on to.
void write_tiny_control(const std::filesystem::path& folder, int channels, int text_width = 32);
// Real-ESRGAN for twice the size, with two blocks; everything inside of "params_ema", as in the official file.
void write_tiny_enlarger(const std::filesystem::path& file);

}  // namespace fastscene
