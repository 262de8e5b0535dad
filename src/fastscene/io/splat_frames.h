// The axes of the splat formats, verified against other programs with asymmetric splats. All are half turns, so the
// same matrix converts in both directions. PLY, compressed PLY and SOG use the world's axes. Private to io/.
#pragma once

#include "fastscene/math/rigid.h"

namespace fastscene {

// SPZ: x right, y up, z back.
inline constexpr Mat3d kSpzFromWorld{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
// glTF and the viewer: x left, y up, z forward.
inline constexpr Mat3d kGltfFromWorld{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};

}  // namespace fastscene
