// A model folder in diffusers' layout, small enough for tests: random weights, synthetic merges.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/error.h"
#include "fastscene/nn/tiny_tokenizer.h"

namespace fastscene {

// unet/ vae/ text_encoder/ tokenizer/ scheduler/. The `text_width` of U-Net and text encoder may differ, to simulate
// mixed-up folders.
struct TinyModel {
    int denoiser_text_width = 32, encoder_text_width = 32;
    std::string prediction = "epsilon";
    std::string salt = {};  // varies the weights
    int sample_size = 64;   // tile size in pixels for decoding
};
void write_tiny_model(const std::filesystem::path& folder, const TinyModel& model = {});
// A ControlNet for such a model; `channels`: of its conditioning picture.
void write_tiny_control(const std::filesystem::path& folder, int channels, int text_width = 32);
// Real-ESRGAN x2 with two blocks, inside "params_ema" as in the official file.
void write_tiny_enlarger(const std::filesystem::path& file);

// Splits the U-Net's weights into two shards with an index, as large models are saved; `part` receives the shard
// number. File types are recognized by their first bytes.
void save_in_parts(const std::filesystem::path& unet, fmt::format_string<int> part, const std::string& index);

// The error message of an action; empty: none.
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
