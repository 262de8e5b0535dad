// Outside: what lies beyond the windows of a room that is known.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// So far away that its color depends on the direction alone. Equirectangular pictures of one size, in panorama 0's
// orientation, linear light.
struct Outside {
    ImageColor color;
    ImageMask seen;  // nonzero: somebody in the room can look there
};

}  // namespace fastscene
