// Cloth over a mattress.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Flat on top, hanging at the sides, with folds. `mattress`: its width, its top above the floor, its length.
Mesh blanket(Vec3f mattress, float drop, float from_z, float to_z, float lift, float thick, std::uint32_t seed,
             float fold);

}  // namespace fastscene::furniture
