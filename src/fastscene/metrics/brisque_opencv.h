// The features of OpenCV's quality module, which differ in padding, downsampling, products and precision. Private to
// metrics/; the public interface is brisque.h.
#pragma once

#include <vector>

#include "fastscene/image/image.h"

namespace fastscene {

// 36 features; not finite in uniform pictures.
std::vector<double> opencv_brisque_features(const ImageRgb8& image);

}  // namespace fastscene
