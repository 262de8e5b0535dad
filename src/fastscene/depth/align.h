// A network sees at its own size; its depth is brought to the picture's, with the edges where the picture has them.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// `coarse` (equirectangular, any size) at the picture's size. Each pixel takes the weighted median of its coarse
// neighbours, those of its own color first: a median, for the mean of two surfaces lies on neither. What a neighbour
// says is where the pixel's ray meets the plane that the neighbour lies on: so walls and floors stay flat, whatever is
// painted on them. Columns wrap. Joint bilateral upsampling (Kopf et al. 2007) with the median in place of the mean,
// and planes in place of values.
ImageF aligned_to_picture(const ImageF& coarse, const ImageColor& picture);

}  // namespace fastscene
