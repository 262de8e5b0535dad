// Inpaint: fills the holes of a picture. Paper: AOT-GAN, retrained ("aotgan": with the weights that come with the
// program, models/aotgan-rooms.md, or the user's); "harmonic" is the reference and needs none: each hole pixel is the
// harmonic mean of its surroundings (Laplace's equation).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"

namespace fastscene {

// One method, one picture a call: a cube face, or any other flat picture.
struct Inpainter {
    virtual ~Inpainter() = default;
    // `hole`: nonzero = to be filled. Pixels that are no hole come back unchanged, bit for bit.
    virtual ImageColor fill(const ImageColor& color, const ImageMask& hole, const Run& run) const = 0;
};
// `weights`: the generator's checkpoint, for "aotgan" only; empty: the program's own. Throws UsageError for an unknown
// name; Error naming the file when it is no such checkpoint.
std::unique_ptr<Inpainter> make_inpainter(std::string_view name, const std::filesystem::path& weights = {});
std::vector<std::string> inpainters();  // names, for --help and the contract test

}  // namespace fastscene
