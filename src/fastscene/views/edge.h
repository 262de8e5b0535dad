// The direction of a picture's edges on a surface, so that splats can begin aligned with them.
#pragma once

#include "fastscene/image/image.h"
#include "fastscene/math/vec.h"

namespace fastscene {

// The tangent of the surface at pixel (x, y) along which the color changes least, with the coherence of the gradients
// around the pixel as its length: 1 on a straight edge, 0 where no direction is preferred or nothing but noise changes
// (structure tensor, Bigun and Granlund 1987). `color`: linear, its columns wrap. `normal`: unit. `across`, `down`: how
// far the surface point moves per column and per row. All in one frame.
Vec3f edge_at(const ImageColor& color, int x, int y, Vec3f normal, Vec3f across, Vec3f down);

}  // namespace fastscene
