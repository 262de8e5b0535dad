// What visitors see through the windows of a known room. No viewpoint need look there: close to a window one sees
// the ground below it, which from the middle of the room is hidden by the wall.
#pragma once

#include "fastscene/base/run.h"
#include "fastscene/scene/outside.h"
#include "fastscene/trace/standable.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// `pano`: world from panorama 0's axes. The room's light must have been gathered. Empty pictures where nobody can look
// out. Deterministic in run.seed.
Outside outside_of_room(const TracedRoom& room, const StandableFloor& floor, const Mat3f& pano, EquirectSize size,
                        const Run& run);

}  // namespace fastscene
