// Walkable area: where visitors may move in the result of a walk.
#pragma once

#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/standable_floor.h"
#include "fastscene/scene/walkable.h"

namespace fastscene {

// For a known room: its floor, with eye heights from crouching to a tall adult. The floor must have a standable cell.
WalkableArea walkable_room(const StandableFloor& floor);

// How much of a panorama of the walk was not observed, as shares of the sphere.
struct Invention {
    Vec3f position_m;           // world
    double invented_share = 0;  // inpainted in this panorama
    double carried_share = 0;   // inpainted at an earlier viewpoint
};
Invention invention_of(const Panorama& panorama);
Json to_json(const std::vector<Invention>& inventions);

// For a walk around a picture: the convex hull of the viewpoints where little had to be invented, with a small margin.
// `floor_y`: of the floor, world.
WalkableArea walkable_of(const std::vector<Invention>& inventions, float floor_y);
// Where the floor is, as far as panorama 0's range straight down tells.
float floor_below(const Panorama& first);

}  // namespace fastscene
