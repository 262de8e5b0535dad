// Diffusion360 (Feng et al. 2023): Stable Diffusion fine-tuned for seamless 360 degree panoramas, behind a plain-data
// interface: text in, equirectangular picture out. Users provide the weights, in diffusers' folder layout.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"

namespace fastscene {

struct Diffusion360Settings {
    int width = 1024;  // multiple of 128; the model was trained at 1024; height is half of it
    int steps = 20;
    double guidance = 7.5;
    std::string sampler = "euler-ancestral";  // euler-ancestral, ddim or unipc
    std::string device = "auto";              // auto, cpu or cuda; auto: CUDA if libtorch supports it
    std::string precision = "float";          // float or bf16; on CUDA also fp16
    // reproduces the published text pipeline, in which the left 32 columns repeat the right ones
    bool published_seam = false;
    bool low_memory = false;       // weights are loaded layer by layer, and the picture is decoded in tiles
    std::string negative;          // empty: the published negative prompt
    std::string upscale = "none";  // upscaling after generation (upscale360.h)
    double photo_fov_deg = 90;     // horizontal field of view of the photo, if one is outpainted
};

constexpr double kGuidanceAroundPhoto = 7;  // published value; that of the text pipeline is 7.5

// What a weights folder contains, determined without reading the weights.
struct Diffusion360Info {
    std::string family;           // "Stable Diffusion 1.x" or "2.x"
    std::string prediction;       // "epsilon" or "v_prediction"
    std::int64_t parameters = 0;  // of the U-Net
    std::int64_t peak_bytes = 0;  // estimated peak memory of a run
};

class Diffusion360 {
  public:
    enum class From { text, photo };
    // `weights`: unet/ vae/ text_encoder/ tokenizer/ scheduler/, or a folder that has them in sd-base/. From::photo: a
    // folder with sr-base/ (such a model) and sd-i2p/ (the ControlNet). Checks names and shapes of all tensors against
    // the configuration before computing. Throws Error naming folder or file, expected and actual: missing, damaged or
    // mismatched components, insufficient memory.
    Diffusion360(const std::filesystem::path& weights, const Diffusion360Settings& settings, const Run& run,
                 From from = From::text);
    ~Diffusion360();
    Diffusion360(Diffusion360&&) noexcept;
    const Diffusion360Info& info() const;

    // Receives intermediate results at half size: what the picture would be if sampling ended now.
    using Preview = std::function<void(const ImageRgb8&)>;
    // Returns an sRGB picture of settings.width x settings.width / 2. run.seed has the same meaning as in PyTorch's CPU
    // generator.
    ImageRgb8 paint(const std::string& prompt, const Run& run, const Preview& preview = {}) const;
    // Outpaints a photo, placed in the center, to a panorama (From::photo only). The model was trained on square photos
    // with a field of view of 90°.
    ImageRgb8 paint_around(const ImageRgb8& photo, const std::string& prompt, const Run& run,
                           const Preview& preview = {}) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// Embeds the user's prompt into the published prompt template.
std::string diffusion360_prompt(const std::string& prompt);
extern const std::string_view kDiffusion360Negative;

}  // namespace fastscene
