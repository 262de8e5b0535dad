// A model folder as diffusers saves it, small enough for tests: random weights, a vocabulary of made-up merges.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/error.h"
#include "fastscene/nn/tiny_tokenizer.h"

namespace fastscene {

// unet/ vae/ text_encoder/ tokenizer/ scheduler/. `text_width` of the denoiser and of the text encoder may differ: a
// mixed-up folder.
struct TinyModel {
    int denoiser_text_width = 32, encoder_text_width = 32;
    std::string prediction = "epsilon";
    std::string salt = {};  // other weights
    int sample_size = 64;   // pixels that the VAE decodes at once
};
void write_tiny_model(const std::filesystem::path& folder, const TinyModel& model = {});
// A ControlNet for such a model; `channels` of the picture it holds on to.
void write_tiny_control(const std::filesystem::path& folder, int channels, int text_width = 32);
// Real-ESRGAN for twice the size, with two blocks; everything inside of "params_ema", as in the official file.
void write_tiny_enlarger(const std::filesystem::path& file);

// The denoiser's file in two, with an index, as large models are saved; `part` is given the part's number. What a file
// is, its first bytes tell.
void save_in_parts(const std::filesystem::path& unet, fmt::format_string<int> part, const std::string& index);

// What an act complains of; empty: nothing.
template <class Act>
std::string message_of(const Act& act) {
    try {
        act();
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

}  // namespace fastscene
