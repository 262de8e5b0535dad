// Makes the independently estimated ranges of several panoramas of one place consistent. Their poses are known, so a
// wall seen in two of them tells by how much one range map is too large or too small.
#pragma once

#include "fastscene/scene/panorama.h"

namespace fastscene {

// The factor to multiply `other`'s range by so that it agrees with `first`'s: the median ratio over the pixels of
// `other` that `first` sees too. 1 if they share too little. Both in the same orientation, with positions in
// world_from_pano.
float scale_to_agree(const Panorama& first, const Panorama& other);

}  // namespace fastscene
