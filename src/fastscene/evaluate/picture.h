// Pictures for people to look at: thumbnails, and maps of where two pictures differ.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Reduced to `width` by the mean over areas; a narrower picture stays as it is.
ImageRgb8 thumbnail(const ImageRgb8& image, int width);
// Mean absolute difference of the three channels: 0 black, over violet and orange to white at `white` (of 255) and
// above. Sizes must be equal.
ImageRgb8 error_map(const ImageRgb8& a, const ImageRgb8& b, double white = 48);
// The part of an image; must lie inside.
ImageRgb8 cut_out(const ImageRgb8& image, int x, int y, int width, int height);

}  // namespace fastscene
