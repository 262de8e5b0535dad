// Inpainting: fills the holes of a picture. Paper: AOT-GAN, retrained ("aotgan": with the built-in weights,
// models/aotgan-rooms.md, or the user's). "harmonic" is the reference and needs no weights: a smooth interpolation
// (Laplace's equation).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"

namespace fastscene {

// Fills one picture per call: a cube face or any other perspective picture.
struct Inpainter {
    virtual ~Inpainter() = default;
    // `hole`: nonzero = to be filled. Other pixels are returned unchanged, bit for bit.
    virtual ImageColor fill(const ImageColor& color, const ImageMask& hole, const Run& run) const = 0;
};
// `weights`: the generator's checkpoint, for "aotgan" only; empty: the built-in one. Throws UsageError for an unknown
// name, Error naming the file if it is not such a checkpoint.
std::unique_ptr<Inpainter> make_inpainter(std::string_view name, const std::filesystem::path& weights = {});
std::vector<std::string> inpainters();  // names, for --help and the contract test

}  // namespace fastscene
