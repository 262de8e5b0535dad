// The axes of the splat formats, measured with one-sided splats against other programs. All are half turns, and so
// their own inverse: the same matrix leads to the file and back. PLY, compressed PLY and SOG have the world's axes.
// Private to io/.
#pragma once

#include "fastscene/math/rigid.h"

namespace fastscene {

// SPZ: x right, y up, z back.
inline constexpr Mat3d kSpzFromWorld{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
// glTF and the viewer: x left, y up, z forward.
inline constexpr Mat3d kGltfFromWorld{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};

}  // namespace fastscene
