// Synthetic rooms made of randomly textured boxes, rendered in a few hundredths of a second each. Networks learn from
// them where walls, floor and objects are regardless of appearance; path traced rooms (docs/dataset.md) teach the rest.
// Domain randomization (Tobin et al. 2017): with enough variation in training, reality looks like another variation.
#pragma once

#include "fastscene/base/random.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/nn/egformer_training.h"

namespace fastscene {

// Width 2 to 9 m, niches and pillars, up to 14 pieces of furniture made of boxes and ellipsoids, windows with unknown
// depth, one to three lamps with shadows. The camera is level, 0.7 to 2 m above the floor. Range is exact at pixel
// centers. Depends on the rng only.
DepthExample painted_room(EquirectSize size, Random& rng);

}  // namespace fastscene
