// Color maps for visualization.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Google's Turbo color map (Mikhailov 2019), polynomial approximation, at t in 0..1: dark blue, green, yellow, dark
// red.
Rgb8 turbo(float t);
// Maps `low` (blue) to `high` (red); 0, NaN and infinity are unknown and become black.
ImageRgb8 colored(const ImageF& values, float low, float high);

}  // namespace fastscene
