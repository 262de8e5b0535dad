// A painted panorama made larger (Diffusion360's super-resolution chain): painted anew, tile by tile, held by a
// ControlNet at three times the width; then Real-ESRGAN, six times; then painted once more. Every step works in tiles
// whose columns wrap, so memory does not grow with the picture and no seam appears.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"

namespace fastscene {

struct Upscale360Settings {
    std::string to = "6";             // "3", "6", or "6-refined": times the width it was painted at
    std::string precision = "float";  // or bf16
    std::string device = "auto";      // or cpu, cuda
    bool low_memory = false;
    std::string negative;  // empty: the published words
    int steps = 7;         // of which `strength` are made
    double strength = 0.8, guidance = 15, refined_guidance = 17;
    int tile = 768;  // pixels, of the painting
};

class Upscale360 {
  public:
    // `weights`: a folder with sr-base/ (as diffusers saves a model), sr-control/ (its ControlNet) and, from six times
    // on, RealESRGAN_x2plus.pth. Checked as Diffusion360 checks. width: of the panorama that will come. Throws Error.
    Upscale360(const std::filesystem::path& weights, int width, const Upscale360Settings& settings, const Run& run);
    ~Upscale360();
    Upscale360(Upscale360&&) noexcept;
    // Hears of each step before it is made ("3", "6", "6-refined": what its picture is) and returns `make()`, or what
    // that returned earlier.
    using Keep = std::function<ImageRgb8(const std::string& step, const std::function<ImageRgb8()>& make)>;
    // `prompt` as the user wrote it.
    ImageRgb8 enlarge(const ImageRgb8& panorama, const std::string& prompt, const Run& run,
                      const Keep& keep = {}) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// How many times as long as the painting, of `width` in `painting_steps`, all of this takes: an estimate from the sizes
// of the networks.
double times_the_painting(int width, int painting_steps, const Upscale360Settings& settings);

}  // namespace fastscene
