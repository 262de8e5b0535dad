// AOT-GAN as an inpainter: a generator checkpoint and pictures in, pictures out. The interface is free of libtorch.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/device.h"
#include "fastscene/weights/weights.h"

namespace fastscene {

class Aotgan {
  public:
    // Loads the official G*.pt, or a .safetensors with the same keys; width, number of blocks and branches come from
    // the file. Throws Error naming the file, the missing or misshaped key, the expected and the actual shape;
    // UsageError naming the flag of a device that is not there.
    static Aotgan load(const std::filesystem::path& weights, const DeviceChoice& device = {});
    // From weights in memory, such as those built into the program (weights/shipped.h).
    static Aotgan of(Weights weights, const DeviceChoice& device = {});
    Aotgan(Aotgan&&) noexcept;
    Aotgan& operator=(Aotgan&&) noexcept;
    ~Aotgan();

    // Whether the network expects the harmonic fill in the holes and adds to it; otherwise the contents of holes are
    // ignored. Stated by the file's metadata ("holes": "harmonic"); official files have none.
    bool adds_to_fill() const;

    // Sides must be multiples of kMultiple and at least kSmallest.
    static constexpr int kMultiple = 8, kSmallest = 64;
    struct Picture {
        ImageColor color;  // sRGB values in 0..1
        ImageMask hole;    // nonzero = inpaint
    };
    // All pictures must have the same size. Known pixels are changed too (how much indicates how well the network
    // fits). Values in 0..1.
    std::vector<ImageColor> paint(const std::vector<Picture>& pictures, const Run& run) const;

  private:
    struct State;
    explicit Aotgan(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace fastscene
