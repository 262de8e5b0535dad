// The outside of a known room as seen through its windows. No viewpoint of the walk need see all of it: close to a
// window the ground below is visible, which the wall hides from the middle of the room.
#pragma once

#include "fastscene/base/run.h"
#include "fastscene/scene/outside.h"
#include "fastscene/trace/standable.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// `pano`: rotation from panorama 0's frame to the world. The room's light must have been gathered. Empty pictures if
// the outside is not visible from anywhere. Deterministic in run.seed.
Outside outside_of_room(const TracedRoom& room, const StandableFloor& floor, const Mat3f& pano, EquirectSize size,
                        const Run& run);

}  // namespace fastscene
