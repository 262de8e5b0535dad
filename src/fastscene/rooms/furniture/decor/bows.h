// The line of a cord that hangs in bows.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Where a cord that hangs in bows is at t in [0, 1].
Vec3f on_bows(float t, int bows, float width, float top, float sag);

}  // namespace fastscene::furniture
