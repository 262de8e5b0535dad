// A walkable area in JSON, as in report.json under `walkable`:
// polygon_m: [[x, z], …], the outline with the largest area, sufficient for readers that need a single polygon;
// eye_heights_m: [low, high], above the floor;
// floor_y_m: the floor in the world frame, whose y points down;
// rings_m: all outlines and holes, even-odd rule; includes polygon_m;
// levels: only of a floor with tiers or steps: its parts, [{"floor_y_m": …, "rings_m": …}, …], each of one height. Eye
// heights are above the part that one stands on; floor_y_m is that of the lowest.
#pragma once

#include <string>

#include "fastscene/base/json.h"
#include "fastscene/scene/walkable.h"

namespace fastscene {

Json walkable_json(const WalkableArea& area);
// `where` names the file in messages. Without rings_m, polygon_m is used.
WalkableArea walkable_from_json(const Json& json, const std::string& where);

}  // namespace fastscene
