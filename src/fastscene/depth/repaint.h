// Domain randomization on furnished rooms (Tobin et al. 2017): recolors surfaces, so that a network learns shape
// instead of our rooms' typical colors.
#pragma once

#include "fastscene/base/random.h"
#include "fastscene/nn/egformer_training.h"

namespace fastscene {

// A surface: the object it belongs to (0: the room itself), and the dominant axis of its normal in the camera's frame
// (0 x, 1 y, 2 z).
SurfaceId surface_id(int piece, int axis);
int piece_of(SurfaceId id);
int axis_of(SurfaceId id);

// Gives floor, ceiling, walls and objects each a new texture (paint.h) with probability `share`, scaled in metres;
// shading is kept. Pixels without range stay unchanged, and so does the whole example if its surfaces are unknown.
DepthExample repainted(const DepthExample& example, float share, Random& rng);

}  // namespace fastscene
