// Range edges: where neighbouring pixels of a range map belong to different surfaces (depth discontinuities).
#pragma once

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"

namespace fastscene {

// Bits of a pixel in the edge map.
inline constexpr std::uint8_t kCutRight = 1;  // no surface between this pixel and its right neighbour
inline constexpr std::uint8_t kCutDown = 2;   // nor between it and the one below
inline constexpr std::uint8_t kFarSide = 4;   // behind a neighbour across a cut: the two colors are mixed
inline constexpr std::uint8_t kNearSide = 8;  // in front of one

// 1/metres; the sky (+inf) becomes the farthest representable surface.
inline constexpr float kFarthestRange = 10000.f;
inline float inverse_range(float range) { return range < kFarthestRange ? 1.f / range : 1.f / kFarthestRange; }

// A plane's inverse range is nearly linear in pixels, so a slanted floor is not an edge: an edge is a step that the
// slope on neither side explains. `range`: equirectangular, > 0, columns wrap.
ImageMask range_edges(const ImageF& range);

}  // namespace fastscene
