// Upscaling of a generated panorama (Diffusion360's super-resolution chain): tiled regeneration under a ControlNet at
// three times the width; then Real-ESRGAN to six times; then one more regeneration. Tiles wrap around, so memory is
// bounded and no seam appears.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"

namespace fastscene {

struct Upscale360Settings {
    std::string to = "6";             // "3", "6" or "6-refined": factor of the original width
    std::string precision = "float";  // float or bf16
    std::string device = "auto";      // auto, cpu or cuda
    bool low_memory = false;
    std::string negative;  // negative prompt; empty: the published one
    int steps = 7;         // sampling steps, of which the share `strength` is executed
    double strength = 0.8, guidance = 15, refined_guidance = 17;
    int tile = 768;  // tile size in pixels of the picture
};

class Upscale360 {
  public:
    // `weights`: a folder with sr-base/ (a diffusers model), sr-control/ (its ControlNet) and, from a factor of six on,
    // RealESRGAN_x2plus.pth. Checked as in Diffusion360. width: of the panorama to upscale. Throws Error.
    Upscale360(const std::filesystem::path& weights, int width, const Upscale360Settings& settings, const Run& run);
    ~Upscale360();
    Upscale360(Upscale360&&) noexcept;
    // Called before each stage ("3", "6", "6-refined"); returns `make()`'s result, or a stored one of an earlier run.
    using Keep = std::function<ImageRgb8(const std::string& step, const std::function<ImageRgb8()>& make)>;
    // `prompt` as the user wrote it.
    ImageRgb8 enlarge(const ImageRgb8& panorama, const std::string& prompt, const Run& run,
                      const Keep& keep = {}) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// Estimated duration in multiples of the generation at `width` with `painting_steps`, from the networks' sizes.
double times_the_painting(int width, int painting_steps, const Upscale360Settings& settings);

}  // namespace fastscene
