// Walkable: how far a visitor may walk in what a walk has made.
#pragma once

#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/standable_floor.h"
#include "fastscene/scene/walkable.h"

namespace fastscene {

// Of a known room: its floor, from a crouch to a tall adult's eyes. The floor must have a standable cell.
WalkableArea walkable_room(const StandableFloor& floor);

// How much of what one of the walk's panoramas shows was not observed, as shares of the sphere.
struct Invention {
    Vec3f position_m;           // world
    double invented_share = 0;  // painted there
    double carried_share = 0;   // painted at an earlier viewpoint
};
Invention invention_of(const Panorama& panorama);
Json to_json(const std::vector<Invention>& inventions);

// Of a picture whose room nobody knows: the scene holds at viewpoints where little had to be invented, and between
// them. The convex hull of those, grown by a hand's breadth. `floor_y`: of the floor, world.
WalkableArea walkable_of(const std::vector<Invention>& inventions, float floor_y);
// Where the floor is, as far as panorama 0's range straight down tells.
float floor_below(const Panorama& first);

}  // namespace fastscene
