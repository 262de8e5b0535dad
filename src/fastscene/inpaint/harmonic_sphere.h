// The smoothest fill of an equirectangular picture's holes, on the sphere: columns wrap, rows continue across the
// poles, and a step along a row counts by its length. Fills of any size, such as the missing floor of a partial
// panorama.
#pragma once

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"

namespace fastscene {

// `hole`: nonzero = to be filled; other pixels are returned unchanged. Black if nothing is known.
ImageColor filled_on_sphere(const ImageColor& color, const ImageMask& hole, const Run& run);

}  // namespace fastscene
