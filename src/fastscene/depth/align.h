// Upsamples the depth of a network to the picture's resolution, with edges aligned to the picture's.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Resizes `coarse` (equirectangular, any size) to the picture's size. Each pixel takes the weighted median of its
// coarse neighbours, preferring those of similar color; a median, because the mean of two surfaces lies on neither.
// Each neighbour contributes the intersection of the pixel's ray with the neighbour's plane, so walls and floors stay
// flat whatever their texture. Columns wrap. Joint bilateral upsampling (Kopf et al. 2007) with medians in place of
// means, and planes in place of values.
ImageF aligned_to_picture(const ImageF& coarse, const ImageColor& picture);

}  // namespace fastscene
