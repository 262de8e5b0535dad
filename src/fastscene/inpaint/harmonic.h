// Harmonic inpainting: solves Laplace's equation in the holes with the rim's colors as boundary values. The reference
// inpainter: never brighter or darker than the rim, and smooth.
#pragma once

#include "fastscene/inpaint/inpaint.h"

namespace fastscene {

struct HarmonicInpainter final : Inpainter {
    ImageColor fill(const ImageColor& color, const ImageMask& hole, const Run& run) const override;
};

}  // namespace fastscene
