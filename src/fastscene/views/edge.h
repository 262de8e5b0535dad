// A picture's edges: how strong they are, and their direction on the surface, with which splats begin aligned.
#pragma once

#include "fastscene/image/image.h"
#include "fastscene/math/vec.h"

namespace fastscene {

// How much the brightness (square root of luminance) changes over two pixels, across plus down. `color`: linear, its
// columns wrap.
float edge_strength(const ImageColor& color, int x, int y);

// The tangent of the surface at pixel (x, y) along which the color changes least, with the coherence of the gradients
// around the pixel as its length: 1 on a straight edge, 0 where no direction is preferred or nothing but noise changes
// (structure tensor, Bigun and Granlund 1987). `color`: linear, its columns wrap. `normal`: unit. `across`, `down`: how
// far the surface point moves per column and per row. All in one frame.
Vec3f edge_at(const ImageColor& color, int x, int y, Vec3f normal, Vec3f across, Vec3f down);

}  // namespace fastscene
