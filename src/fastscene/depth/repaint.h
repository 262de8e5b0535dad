// A furnished room in other colors: what training changes so that a network reads the shape of things, and not what our
// rooms like to paint them (domain randomisation, Tobin et al. 2017, on furnished rooms).
#pragma once

#include "fastscene/base/random.h"
#include "fastscene/nn/egformer_training.h"

namespace fastscene {

// A surface: the piece that it belongs to (0: the bare shell), and the axis of the camera's frame that it faces most (0
// x, 1 y, 2 z).
SurfaceId surface_id(int piece, int axis);
int piece_of(SurfaceId id);
int axis_of(SurfaceId id);

// Floor, ceiling, walls and things each get another paint (paint.h) with `share` of a chance, laid on in metres; light
// and shade stay. Where range is not known nothing changes. The example as it is where its surfaces are not known.
DepthExample repainted(const DepthExample& example, float share, Random& rng);

}  // namespace fastscene
