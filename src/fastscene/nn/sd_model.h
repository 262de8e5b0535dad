// A Stable Diffusion 1.x or 2.x model in diffusers' layout, opened and validated: names and shapes of all tensors can
// be checked against the configuration before computing. Private to nn/ (torch).
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
    at::ScalarType type = at::kFloat;  // number type of the U-Net; the text encoder runs in float
    at::Device device = at::kCPU;
    Sampler sampler = Sampler::euler_ancestral;
    bool keep = true;      // cache converted weights (file_weights.h)
    bool encoder = false;  // load the VAE's encoder, too

    // Number type of networks on pictures. On a graphics card halves, which have more digits than bfloat16, unless they
    // overflow (without_overflow).
    at::ScalarType picture_type() const { return device.is_cuda() && type != at::kFloat ? at::kHalf : at::kFloat; }
};

// Parses the settings. Throws UsageError naming the flag.
SdOptions sd_options(const std::string& precision, const std::string& device, Sampler sampler, bool low_memory,
                     bool encoder);

struct SdModel {
    // `base`: unet/ vae/ text_encoder/ tokenizer/ scheduler/. Throws Error naming folder or file, expected and actual.
    SdModel(const std::filesystem::path& base, const SdOptions& options);
    // Traverses the networks, which takes some memory. Throws Error for missing or misshaped tensors and insufficient
    // memory.
    void check_shapes() const;

    // [2, L, width]: negative prompt, prompt; in the U-Net's type, on its device. Warns if a prompt is too long.
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

// A ControlNet for such a model, checked against it.
struct ControlModel {
    // `channels`: of its conditioning picture. Throws Error as above.
    ControlModel(const std::filesystem::path& folder, const SdModel& model, std::int64_t channels);
    void check_shapes() const;
    UNetConfig config;
    std::unique_ptr<FileWeights> weights;
};

// make(weights, their type), on a graphics card in float. Where halves overflow, `weights` become floats for good, and
// it is made once more.
at::Tensor without_overflow(std::unique_ptr<FileWeights>& weights, const Run& run,
                            const std::function<at::Tensor(const Scope&, at::ScalarType)>& make);

// Throws Error naming the component whose output is not finite.
void expect_finite(const at::Tensor& output, const std::filesystem::path& component, at::ScalarType type);

// Converts pictures to network input, [1, 3, H, W] in [0, 1], and back (clamped).
at::Tensor unit_picture(const ImageRgb8& image, at::Device device = at::kCPU);
ImageRgb8 picture_of_unit(const at::Tensor& unit);
// float, bf16, or on a GPU fp16. Throws UsageError naming the flag.
at::ScalarType type_of_precision(const std::string& name, at::Device device);
// Runs `make()`; converts a GPU out-of-memory error into an Error with remedies.
ImageRgb8 fitting_the_card(const std::function<ImageRgb8()>& make);

}  // namespace fastscene::nn
