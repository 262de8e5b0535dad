// For tests: maximum difference between two pictures of equal size.
#pragma once

#include <algorithm>

#include "fastscene/image/image.h"

namespace fastscene {

inline float greatest_difference(const ImageColor& a, const ImageColor& b) {
    float most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a.pixels[i] - b.pixels[i]));
    return most;
}

}  // namespace fastscene
