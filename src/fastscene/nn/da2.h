// DA-2: range from an equirectangular picture, by the network of Li et al., "DA^2: Depth Anything in Any Direction",
// 2025: SphereViT, a vision transformer that is told where each patch looks.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/device.h"

namespace fastscene {

// How a picture comes to the network's size; both are published.
enum class Da2Resize {
    // to 1092 x 546, each pixel a mean of those it covers: the authors' evaluation. The viewing angles that the network
    // is told span the sphere.
    evaluation,
    // by area, to about 600 000 pixels, without antialiasing: the authors' program. Angles fit only a picture of
    // 1092 x 546; others leave a part of the sphere out, or cover it several times.
    inference,
};

class Da2 {
  public:
    // Whether the file holds weights of this network, by their names. False for one that cannot be read.
    static bool is_in(const std::filesystem::path& weights);
    // Throws one Error that names every missing, unexpected and misshaped tensor; UsageError naming the flag of a
    // device that is not there. Parameters are read at their first use. bf16: rounds all products but those of the last
    // layers to bfloat16.
    static Da2 load(const std::filesystem::path& weights, const DeviceChoice& device = {}, bool bf16 = false);
    // Whether that is faster on the device.
    static bool gains_by_bf16(const DeviceChoice& device);
    Da2(Da2&&) noexcept;
    Da2& operator=(Da2&&) noexcept;
    ~Da2();

    // Linear color of any 2:1 size -> distance along each ray, up to one factor: 1092 x 546 (`evaluation`), or of the
    // picture's size. `turns`: 1, as published: nothing is made of the left and right border's being the same place.
    // More: the network sees the panorama this many times, each time turned by the next part of a whole turn, and what
    // it finds is blended so that no border of any pass shows. Throws Stopped.
    ImageF relative_range(const ImageColor& color, Da2Resize resize, int turns, const Run& run) const;

  private:
    struct State;
    explicit Da2(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace fastscene
