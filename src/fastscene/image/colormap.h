// Numbers as colors, for people.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Turbo (Mikhailov 2019) at t in 0..1: dark blue, green, yellow, dark red; its polynomial approximation.
Rgb8 turbo(float t);
// Values from `low` (blue) to `high` (red); what is 0, NaN or infinite is black: unknown.
ImageRgb8 colored(const ImageF& values, float low, float high);

}  // namespace fastscene
