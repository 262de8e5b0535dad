// What tools and games need besides a room's appearance: labels of its things, the walkable area, a floor plan.
// Coordinates are those of room.glb (kGltfAxes), metres.
#pragma once

#include <string>

#include "fastscene/base/json.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// Per thing: id, class, NYU40 label, oriented box, area, materials, what it stands on.
Json labels_json(const TracedRoom& room);
// Polygons that one can walk in, spawn points, doors.
Json walkable_floor_json(const TracedRoom& room);
// A floor plan seen from above with dimensions and names, as SVG.
std::string plan_svg(const TracedRoom& room);

}  // namespace fastscene
