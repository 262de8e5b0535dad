// Room walk: behind a prompt stands a room of which everything is known. It is looked at from viewpoints all over it,
// so that visitors may walk wherever one can stand. Nothing is warped and nothing is painted.
#pragma once

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/standable_floor.h"
#include "fastscene/trace/trace.h"
#include "fastscene/walk/walk.h"

namespace fastscene {

// Panorama 0 and then one panorama a viewpoint (viewpoints.h), each with range, all known, in panorama 0's
// orientation. `shot`: how panorama 0 was shot. The room's light must have been gathered. Where nobody can stand, the
// viewpoints are those of choose_viewpoints. Returns what the record of the stage should say.
Json walk_through_room(const Panorama& first, const TracedRoom& room, const StandableFloor& floor,
                       const WalkParams& params, const ShotParts& shot, const Run& run, const TakePanorama& take);

}  // namespace fastscene
