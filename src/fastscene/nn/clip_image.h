// Preprocessing of pictures as in CLIP's training.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Bit-exact reimplementation of Pillow's bicubic resize (a = -0.5, antialiased, 8-bit values with 22-bit weights,
// horizontal pass first).
ImageRgb8 pillow_bicubic(const ImageRgb8& image, int width, int height);

// Resizes the shorter side to `side`, then center-crops to side x side.
ImageRgb8 clip_crop(const ImageRgb8& image, int side = 224);

}  // namespace fastscene
