// Repeats: fills hidden parts of a plane's picture by its symmetries. Patterns of rugs, tiles and wall panels recur,
// translated or mirrored. A hidden part that such a motion maps to a seen one is copied from there.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Fills `hole` (nonzero) pixels near seen ones where a translation or reflection of the picture agrees with the seen
// surroundings, and clears them in `hole`. Untextured parts are left. The picture is rectified, with
// `metres_per_pixel`. Deterministic.
void fill_from_repeats(ImageColor& color, ImageMask& hole, float metres_per_pixel);

}  // namespace fastscene
