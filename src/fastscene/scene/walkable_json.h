// A walkable area in JSON, as report.json has it under `walkable`:
//   polygon_m      [[x, z], …], the outline that encloses most floor: all that a reader needs who wants one polygon
//   eye_heights_m  [low, high], above the floor
//   floor_y_m      the floor in the world frame, whose y points down
//   rings_m        all outlines and holes, even-odd rule; polygon_m is one of them
#pragma once

#include <string>

#include "fastscene/base/json.h"
#include "fastscene/scene/walkable.h"

namespace fastscene {

Json walkable_json(const WalkableArea& area);
// `where` names the file in messages. Without rings_m the area is polygon_m.
WalkableArea walkable_from_json(const Json& json, const std::string& where);

}  // namespace fastscene
