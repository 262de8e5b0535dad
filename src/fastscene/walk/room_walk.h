// Room walk: a scene from a prompt has a known room, which is rendered from viewpoints all over it, so that visitors
// may walk wherever one can stand. Nothing is warped or inpainted.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/standable_floor.h"
#include "fastscene/trace/trace.h"
#include "fastscene/walk/walk.h"

namespace fastscene {

// The walk through the room before it was edited.
struct EarlierWalk {
    std::shared_ptr<const TracedRoom> room;               // lit
    std::vector<Vec3f> positions_m;                       // of its panoramas, without panorama 0
    std::function<Panorama(std::size_t index)> panorama;  // its color and range (through mirrors), by that index
};

// Emits panorama 0, then one panorama per viewpoint (room_viewpoints.h), each with range, all pixels known, in panorama
// 0's orientation. `shot`: the settings panorama 0 was rendered with. The room's light must have been gathered. If
// nobody can stand in the room, falls back to choose_viewpoints. With `earlier`, its viewpoints are kept, and of its
// panoramas only pixels that the edit changed are rendered again. Returns the record for stage.json.
Json walk_through_room(const Panorama& first, const TracedRoom& room, const StandableFloor& floor,
                       const WalkParams& params, const ShotParts& shot, const Run& run, const TakePanorama& take,
                       const EarlierWalk* earlier = nullptr);

}  // namespace fastscene
