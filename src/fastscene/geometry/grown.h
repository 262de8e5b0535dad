// Mask dilation.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Nonzero within `reach` pixels of a nonzero pixel, horizontally and vertically (a square). `wraps`: columns are
// circular.
ImageMask grown(const ImageMask& mask, int reach, bool wraps);

}  // namespace fastscene
