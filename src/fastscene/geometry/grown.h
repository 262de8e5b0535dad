// Grown: a mask and what lies close about it.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Nonzero within `reach` pixels of a nonzero pixel, along the columns and the rows. `wraps`: the last column is the
// first one's neighbour.
ImageMask grown(const ImageMask& mask, int reach, bool wraps);

}  // namespace fastscene
