// The features of OpenCV's quality module: other border, other half size, other products, single precision.
// Private to metrics/; the user's way is brisque.h.
#pragma once

#include <vector>

#include "fastscene/image/image.h"

namespace fastscene {

// 36 features; not finite where the picture is even.
std::vector<double> opencv_brisque_features(const ImageRgb8& image);

}  // namespace fastscene
