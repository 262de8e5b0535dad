// Painted rooms: boxes in a box, colored at random, one of them in a few hundredths of a second. A network learns on
// them where walls, floor and things stand whatever they look like; furnished and traced rooms (docs/dataset.md) teach
// it the rest. After the domain randomisation of Tobin et al. 2017: what varies wildly in training is taken for a
// variation when it is met.
#pragma once

#include "fastscene/base/random.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/nn/egformer_training.h"

namespace fastscene {

// Width 2 to 9 m, niches and pillars, up to 14 pieces of furniture made of boxes and ellipsoids, windows whose depth is
// unknown, one to three lamps with their shadows. The camera is upright, 0.7 to 2 m above the floor. Range is exact at
// the pixels' centers. Depends on the rng only.
DepthExample painted_room(EquirectSize size, Random& rng);

}  // namespace fastscene
