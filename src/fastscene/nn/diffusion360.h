// Diffusion360 (Feng et al. 2023): Stable Diffusion fine-tuned on panoramas, with ends that meet. The whole of it
// behind plain data: a sentence in, an equirectangular picture out. Weights are the user's: a folder as diffusers saves
// it.
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
    std::string sampler = "euler-ancestral";  // or ddim, unipc
    std::string device = "auto";              // or cpu, cuda; auto: CUDA where libtorch has it
    std::string precision = "float";          // or bf16; on CUDA fp16, too
    bool published_seam = false;              // the repository's text path, whose left 32 columns repeat the right ones
    bool low_memory = false;                  // weights are read layer by layer, the picture is decoded in tiles
    std::string negative;                     // empty: the published negative prompt
    std::string upscale = "none";             // what follows the painting (upscale360.h)
    double photo_fov_deg = 90;                // how wide the photo sees, when one is continued all around
};

constexpr double kGuidanceAroundPhoto = 7;  // as published; 7.5 is the text path's

// What a folder holds, told without reading the weights.
struct Diffusion360Info {
    std::string family;           // "Stable Diffusion 1.x" or "2.x"
    std::string prediction;       // "epsilon" or "v_prediction"
    std::int64_t parameters = 0;  // of the denoiser
    std::int64_t peak_bytes = 0;  // what a run will need, estimated
};

class Diffusion360 {
  public:
    enum class From { text, photo };
    // `weights`: unet/ vae/ text_encoder/ tokenizer/ scheduler/, or a folder with them in sd-base/. From a photo: a
    // folder with sr-base/ (such a model) and sd-i2p/ (the ControlNet). Every tensor's name and shape is held against
    // the configuration before anything is computed. Throws Error naming the folder or file, expected and found:
    // missing or damaged components, components of different models, too little memory.
    Diffusion360(const std::filesystem::path& weights, const Diffusion360Settings& settings, const Run& run,
                 From from = From::text);
    ~Diffusion360();
    Diffusion360(Diffusion360&&) noexcept;
    const Diffusion360Info& info() const;

    // Hears along the way what the picture would be if it ended here, decoded at half its size.
    using Preview = std::function<void(const ImageRgb8&)>;
    // settings.width x settings.width / 2, sRGB. The seed means what it means to PyTorch's generator on the CPU.
    ImageRgb8 paint(const std::string& prompt, const Run& run, const Preview& preview = {}) const;
    // The photo in the middle of the panorama, continued all around (From::photo only). The model was trained with
    // square photos of 90°.
    ImageRgb8 paint_around(const ImageRgb8& photo, const std::string& prompt, const Run& run,
                           const Preview& preview = {}) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// The words that the published pipeline puts around the user's.
std::string diffusion360_prompt(const std::string& prompt);
extern const std::string_view kDiffusion360Negative;

}  // namespace fastscene
