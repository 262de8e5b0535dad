// A Stable Diffusion 1.x or 2.x as diffusers saves it, opened and checked: every tensor's name and shape can be held
// against the configurations before anything is computed. Private to nn/ (torch).
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/clip.h"
#include "fastscene/nn/file_weights.h"
#include "fastscene/nn/scheduler.h"
#include "fastscene/nn/tokenizer.h"
#include "fastscene/nn/unet.h"
#include "fastscene/nn/vae.h"

namespace fastscene::nn {

constexpr std::int64_t kPixelsPerLatent = 8;

struct SdOptions {
    at::ScalarType type = at::kFloat;  // of the denoiser; text and pictures are read and made in float
    at::Device device = at::kCPU;      // of denoiser and pictures; text is short and read by the processor
    Sampler sampler = Sampler::euler_ancestral;
    bool keep = true;      // converted weights stay (file_weights.h)
    bool encoder = false;  // pictures go in, too
};

// Of the settings' words. Throws UsageError naming the flag.
SdOptions sd_options(const std::string& precision, const std::string& device, Sampler sampler, bool low_memory,
                     bool encoder);

struct SdModel {
    // `base`: unet/ vae/ text_encoder/ tokenizer/ scheduler/. Throws Error naming folder or file, expected and found.
    SdModel(const std::filesystem::path& base, const SdOptions& options);
    // Walks through the networks, which takes some memory. Throws Error for what is missing, misshaped or too much.
    void check_shapes() const;

    // [2, L, width]: negative prompt, prompt; in the denoiser's type, on its device. Warns of what is too long to be
    // read.
    at::Tensor read_prompt(const std::string& prompt, const std::string& negative, const Run& run) const;
    std::string family() const;
    std::int64_t bytes() const { return unet->bytes() + vae->bytes() + text->bytes(); }

    std::filesystem::path base;
    SdOptions options;
    UNetConfig unet_config;
    VaeConfig vae_config;
    ClipTower tower;
    ScheduleConfig schedule;
    std::unique_ptr<ClipTokenizer> tokenizer;
    std::unique_ptr<FileWeights> unet, vae, text;

  private:
    void check_text() const;
    void check_families() const;
};

// A ControlNet beside such a model, checked against it.
struct ControlModel {
    // `channels` of the picture it must take. Throws Error as above.
    ControlModel(const std::filesystem::path& folder, const SdModel& model, std::int64_t channels);
    void check_shapes() const;
    UNetConfig config;
    std::unique_ptr<FileWeights> weights;
};

// Throws Error naming the component that put out what is not finite.
void expect_finite(const at::Tensor& output, const std::filesystem::path& component, at::ScalarType type);

// Pictures as networks see them, [1, 3, H, W] in [0, 1], and back (values outside are cut off).
at::Tensor unit_picture(const ImageRgb8& image);
ImageRgb8 picture_of_unit(const at::Tensor& unit);
// float, bf16, or on a graphics card fp16. Throws UsageError naming the flag.
at::ScalarType type_of_precision(const std::string& name, at::Device device);
// `make()`; a graphics card whose memory is too small for it is told as an Error with what helps.
ImageRgb8 fitting_the_card(const std::function<ImageRgb8()>& make);

}  // namespace fastscene::nn
