// Validates the first panorama before a walk.
#pragma once

#include "fastscene/base/run.h"
#include "fastscene/scene/panorama.h"

namespace fastscene {

// Pixels without a valid range (0, negative, NaN, infinite, below a millimetre) become sky, with a warning unless they
// were sky already; sets `known`. Throws Error if color and range do not match, no pixel has a range, or there is no
// free space to walk in.
Panorama ready_to_walk(Panorama first, const Run& run);

}  // namespace fastscene
