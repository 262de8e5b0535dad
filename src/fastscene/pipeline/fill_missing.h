// Fills the parts of a panorama that its picture does not have, before its range is estimated.
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"
#include "fastscene/inpaint/inpaint.h"

namespace fastscene {

// Who fills: the walk's inpainter, by its settings.
struct Filler {
    std::string inpainter, weights, device = "auto";
    std::vector<std::string> trusted;
};

// `missing`: nonzero = to be filled; other pixels are returned unchanged. Missing sides show the rest mirrored; what
// else lies far from the picture is continued smoothly over the sphere. The inpainter continues the structures at the
// picture's rim on overlapping cube faces; one that invents (Inpainter::invents) paints everything, on the panorama
// with its columns continued across the seam.
ImageColor with_missing_filled(const ImageColor& color, const ImageMask& missing, const Inpainter& inpainter,
                               const Run& run);

}  // namespace fastscene
