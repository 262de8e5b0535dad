// Ready: the first panorama, looked at with suspicion before a walk begins.
#pragma once

#include "fastscene/base/run.h"
#include "fastscene/scene/panorama.h"

namespace fastscene {

// Pixels without a range (0, negative, NaN, infinite, less than a millimetre) become sky, with a warning unless they
// were sky already; `known` is set. Throws Error when color and range do not fit together, nothing has a range, or
// there is no free space to walk in.
Panorama ready_to_walk(Panorama first, const Run& run);

}  // namespace fastscene
