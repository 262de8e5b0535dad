// AOT-GAN as a painter of holes: a checkpoint of the generator and pictures in, pictures out. No libtorch in sight.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/weights.h"

namespace fastscene {

class Aotgan {
  public:
    // The official G*.pt, or a .safetensors of the same names; width, blocks and branches are the file's.
    // Throws Error naming the file, the key that is missing or has another shape, what was expected and found.
    static Aotgan load(const std::filesystem::path& weights);
    // Weights that are in memory: those that come with the program (nn/shipped.h).
    static Aotgan of(Weights weights);
    Aotgan(Aotgan&&) noexcept;
    Aotgan& operator=(Aotgan&&) noexcept;
    ~Aotgan();

    // Whether the network wants to find the harmonic fill in the holes, to which it adds; else what stands there does
    // not matter. Said by the file's metadata ("holes": "harmonic"); the official files say nothing.
    bool adds_to_fill() const;

    // Sides must be multiples of kMultiple and at least kSmallest.
    static constexpr int kMultiple = 8, kSmallest = 64;
    struct Picture {
        ImageColor color;  // sRGB values in 0..1
        ImageMask hole;    // nonzero = to be painted
    };
    // All of one size; known pixels are repainted too (the difference there tells how well the network fits). Values in
    // 0..1.
    std::vector<ImageColor> paint(const std::vector<Picture>& pictures, const Run& run) const;

  private:
    struct State;
    explicit Aotgan(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace fastscene
