// The picture as CLIP was trained on it.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Pillow's bicubic resize (a = -0.5, widened against aliasing, 8-bit values with 22-bit weights, rows first), to the
// pixel.
ImageRgb8 pillow_bicubic(const ImageRgb8& image, int width, int height);

// Shorter side to `side`, center crop to side x side.
ImageRgb8 clip_crop(const ImageRgb8& image, int side = 224);

}  // namespace fastscene
