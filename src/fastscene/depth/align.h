// A network sees at its own size; its depth is brought to the picture's, with the edges where the picture has them.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// `coarse` (equirectangular, any size) at the picture's size. Each pixel takes the weighted median of its coarse
// neighbours, those of its own color first: a median, for the mean of two surfaces lies on neither. Columns wrap.
// Joint bilateral upsampling (Kopf et al. 2007) with the median in place of the mean.
ImageF aligned_to_picture(const ImageF& coarse, const ImageColor& picture);

}  // namespace fastscene
