// EGformer: predicts relative depth from an equirectangular picture (the paper's panoramic depth estimation). Yun, Lee,
// Rhee, "EGformer: Equirectangular Geometry-biased Transformer for 360 Depth Estimation", ICCV 2023.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/device.h"
#include "fastscene/weights/weights.h"

namespace fastscene {

// The official network is 512 x 1024 with 32 channels; smaller ones have the same structure.
struct EgformerShape {
    int height = 512, width = 1024;  // multiples of 32; width = 2 height
    int channels = 32;               // of the first stage; a multiple of 4 (the second stage has 4 heads)
    // Our extension, absent in official checkpoints: a learned depth prior per latitude, added before the final
    // activation. Floors are near below and walls far ahead; with that given, the network learns the rest sooner.
    bool latitude_prior = false;
};

class Egformer {
  public:
    // Loads the official .pkl or a .safetensors. The number of channels follows from the checkpoint; height and width
    // from the file's metadata, or else the official ones. Throws Error naming a missing or misshaped key, UsageError
    // naming the flag of a device that is not there.
    static Egformer load(const std::filesystem::path& weights, const DeviceChoice& device = {});
    // Loads weights built into the program (weights/shipped.h) by name.
    static Egformer shipped(std::string_view name, const DeviceChoice& device = {});
    Egformer(Egformer&&) noexcept;
    Egformer& operator=(Egformer&&) noexcept;
    ~Egformer();

    const EgformerShape& shape() const;
    // Linear color of any 2:1 size -> relative depth in (0, 1) at shape()'s size. Its scale and shift relative to range
    // are unknown (depth/metric_range.h estimates them). `augmentations`: test-time augmentation, the mean over 1 to 8
    // variants of the picture: original, mirrored, rotated by 90 degrees, rotated and mirrored … The true depth is
    // equivariant under these, so averaging reduces the network's error.
    ImageF relative_depth(const ImageColor& color, int augmentations = 1) const;

  private:
    struct State;
    static Egformer of(Weights weights, const DeviceChoice& device);
    explicit Egformer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace fastscene
