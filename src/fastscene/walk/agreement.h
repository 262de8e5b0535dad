// Panoramas of one place whose ranges were estimated one by one, made to agree: their poses are known, so what two of
// them see of the same wall says how much too large or small one of them was guessed.
#pragma once

#include "fastscene/scene/panorama.h"

namespace fastscene {

// By what `other`'s range is to be multiplied so that it agrees with `first`'s: the median, over the pixels of `other`
// that the first sees too, of the one over the other. 1 where they share too little. Both in one orientation, with
// positions in world_from_pano.
float scale_to_agree(const Panorama& first, const Panorama& other);

}  // namespace fastscene
