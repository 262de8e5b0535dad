// Inpaint: fills the holes of a picture. Paper: AOT-GAN, retrained (its own issue); here "harmonic",
// the reference: each hole pixel is the harmonic mean of its surroundings (Laplace's equation).
#pragma once

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
// Throws UsageError for an unknown name.
std::unique_ptr<Inpainter> make_inpainter(std::string_view name);
std::vector<std::string> inpainters();  // names, for --help and the contract test

}  // namespace fastscene
