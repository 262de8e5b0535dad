// Inpainting: fills the holes of a picture. Paper: AOT-GAN, retrained ("aotgan": with the built-in weights,
// models/aotgan-rooms.md, or the user's). "harmonic" is the reference and needs no weights: a smooth interpolation
// (Laplace's equation).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/registry.h"
#include "fastscene/base/run.h"
#include "fastscene/image/image.h"

namespace fastscene {

// Fills one picture per call: a cube face or any other perspective picture.
struct Inpainter {
    virtual ~Inpainter() = default;
    // `hole`: nonzero = to be filled. Other pixels are returned unchanged, bit for bit.
    virtual ImageColor fill(const ImageColor& color, const ImageMask& hole, const Run& run) const = 0;
    // Whether it paints large holes better than a smooth fill does.
    virtual bool invents() const { return false; }
};
// The same for a panorama: an inpainter that invents sees its columns continued across the seam, on both sides.
ImageColor fill_panorama(const Inpainter& inpainter, const ImageColor& panorama, const ImageMask& hole, const Run& run);
// A way to fill holes, in a source file of its own under inpaint/inpainters/: what is there is what --walk-inpainter
// offers, and what the contract test asks.
struct InpaintBackend {
    std::string name = {};   // as its source file
    std::string about = {};  // half a sentence, for --help
    std::string model = {};  // of models/registry.cc, whose file in the cache serves as its weights; empty: none
    bool runs_code = false;  // its weights are a program, which runs only if the user trusts it
    // `weights`: a checkpoint; empty: the shipped ones. `device`: of a network. `trusted`: files whose code may run
    // (models/trust.h). Throws UsageError if there are no weights, no such device or no trust, Error naming the file if
    // it is no such checkpoint.
    std::unique_ptr<Inpainter> (*make)(const std::filesystem::path& weights, const std::string& device,
                                       const std::vector<std::string>& trusted) = nullptr;
};
// `device`: of --walk-device. Throws UsageError with the names for an unknown one.
std::unique_ptr<Inpainter> make_inpainter(std::string_view name, const std::filesystem::path& weights = {},
                                          const std::string& device = "auto",
                                          const std::vector<std::string>& trusted = {});

}  // namespace fastscene
