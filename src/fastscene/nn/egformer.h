// EGformer: equirectangular color -> relative depth, by a network (paper: panoramic depth).
// Yun, Lee, Rhee, "EGformer: Equirectangular Geometry-biased Transformer for 360 Depth Estimation", ICCV 2023.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/weights.h"

namespace fastscene {

// The official network is 512 x 1024 with 32 channels; smaller ones keep its form.
struct EgformerShape {
    int height = 512, width = 1024;  // multiples of 32; width = 2 height
    int channels = 32;               // of the first stage; a multiple of 4 (its second has 4 heads)
    // Ours, absent in official checkpoints: the depth to be expected at each latitude is a parameter of its own, beside
    // the last layer. Floors are near below and walls far ahead; a network that need not learn that learns the rest
    // sooner.
    bool latitude_prior = false;
};

class Egformer {
  public:
    // Reads the official .pkl or a .safetensors. The number of channels is the checkpoint's; height and width are what
    // the file's metadata say, else the official ones. Throws Error naming the key that is missing or has another
    // shape.
    static Egformer load(const std::filesystem::path& weights);
    // The weights that the program carries (shipped.h), by name.
    static Egformer shipped(std::string_view name);
    Egformer(Egformer&&) noexcept;
    Egformer& operator=(Egformer&&) noexcept;
    ~Egformer();

    const EgformerShape& shape() const;
    // Linear color of any 2:1 size -> relative depth in (0, 1) at shape() size: an unknown scale and an unknown shift
    // away from range (depth/metric_range.h finds them). Mean of 1 to 8 looks at the picture: as it is, mirrored,
    // turned by a quarter, that mirrored … A panorama has no beginning and no handedness, and what a network says
    // otherwise is its error.
    ImageF relative_depth(const ImageColor& color, int augmentations = 1) const;

  private:
    struct State;
    static Egformer of(Weights weights);
    explicit Egformer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace fastscene
