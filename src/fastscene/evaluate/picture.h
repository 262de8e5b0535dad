// Pictures for visual inspection: thumbnails and difference maps.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Downsampled to `width` by area averaging; narrower pictures are unchanged.
ImageRgb8 thumbnail(const ImageRgb8& image, int width);
// Mean absolute difference of the channels as a heat map: 0 black, through violet and orange to white at `white` (of
// 255) and above. Sizes must be equal.
ImageRgb8 error_map(const ImageRgb8& a, const ImageRgb8& b, double white = 48);
// Crops an image; the rectangle must lie inside.
ImageRgb8 cut_out(const ImageRgb8& image, int x, int y, int width, int height);

}  // namespace fastscene
