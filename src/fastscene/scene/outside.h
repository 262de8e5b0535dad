// Outside: the view through the windows of a known room.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// So distant that its color depends on direction alone. Equirectangular pictures of equal size, in panorama 0's
// orientation, linear radiance.
struct Outside {
    ImageColor color;
    ImageMask seen;  // nonzero: visible from somewhere in the room; 255: from everywhere
};

}  // namespace fastscene
