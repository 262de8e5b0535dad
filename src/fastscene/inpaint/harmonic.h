// Harmonic: holes as the solution of Laplace's equation with the rim's colors as boundary. The reference
// inpainter: never brighter or darker than the rim, no edges of its own.
#pragma once

#include "fastscene/inpaint/inpaint.h"

namespace fastscene {

struct HarmonicInpainter final : Inpainter {
    ImageColor fill(const ImageColor& color, const ImageMask& hole, const Run& run) const override;
};

}  // namespace fastscene
