// A furnished room as a page draws it: a floor plan with things in their colors.
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/rooms/document.h"

namespace fastscene::studio {

// Room frame, metres, degrees: {type, style, width, depth, height, floor, wall, blocks, openings, things, camera,
// looks, next}. A thing: {id, kind, name, x, z (what an edit moves), yaw_deg, cx, cz, w, d (its box from above), y, h,
// mount, on, color, flat, overhead, asked}. The lowest things first.
Json plan_view(const DocumentRoom& room);

}  // namespace fastscene::studio
