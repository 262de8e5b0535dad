// Range edges: where neighbouring pixels of a range map lie on different surfaces.
#pragma once

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"

namespace fastscene {

// Bits of a pixel in the map of cuts.
inline constexpr std::uint8_t kCutRight = 1;  // no surface between this pixel and the one to its right
inline constexpr std::uint8_t kCutDown = 2;   // nor the one below
inline constexpr std::uint8_t kFarSide = 4;   // lies behind a neighbour across a cut: its color is mixed with it
inline constexpr std::uint8_t kNearSide = 8;  // lies in front of one

// 1/metres; the sky (+inf) becomes the farthest surface that still has a place.
inline constexpr float kFarthestRange = 10000.f;
inline float inverse_range(float range) { return range < kFarthestRange ? 1.f / range : 1.f / kFarthestRange; }

// A plane's inverse range is nearly linear from pixel to pixel, so a slanted floor is no jump: a jump is what
// neither side's slope explains. `range`: equirectangular, > 0, columns wrap.
ImageMask range_edges(const ImageF& range);

}  // namespace fastscene
