// Repeats: what a picture of a plane repeats. A rug's pattern comes back a lozenge further and, mirrored, at its other
// end; tiles and a wall's panels do. A hidden part that such a motion carries onto a seen one is copied from there, rim
// and all.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Fills pixels of `hole` (nonzero) that are close to what is seen, where a shift or a mirror image of the picture
// agrees with what is seen about them, and takes them out of `hole`. What has no pattern is left. The picture is head
// on, `metres_per_pixel` the side of a pixel. Deterministic.
void fill_from_repeats(ImageColor& color, ImageMask& hole, float metres_per_pixel);

}  // namespace fastscene
