// Outlook: what lies outside the windows, all around.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// The outside is so far away that its color depends on the direction alone. What panorama 0 saw of it, gone on smoothly
// behind walls, frames and curtains: far along the rows, a little along the columns, for the outside lies in layers
// (sky, hills, ground). Every color is a mean of colors seen. `range`: infinite where the outside was seen. Empty when
// none was.
ImageColor outside_picture(const ImageColor& color, const ImageF& range);

}  // namespace fastscene
