// The outside of the windows, in all directions.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// The outside is so distant that its color depends on direction alone. Extends what panorama 0 saw of it smoothly
// behind walls, frames and curtains: far along rows but only slightly along columns, as outdoor scenes are layered
// (sky, hills, ground). Every color is a mean of visible ones. `range`: infinite where the outside is visible. Empty if
// it is visible nowhere.
ImageColor outside_picture(const ImageColor& color, const ImageF& range);

}  // namespace fastscene
