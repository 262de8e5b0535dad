// Standable floor: where a person can stand in a room. Computed from the surfaces, so no floor plan is needed and
// adjoining rooms behind a doorway are included.
#pragma once

#include "fastscene/scene/standable_floor.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// The person's size, in metres. People turn sideways to pass between a bed and a wall, but keep more distance when
// standing.
struct Body {
    float clear_m = 0.25f;      // free radius where the person stands
    float pass_m = 0.15f;       // … and where it passes
    float step_over_m = 0.05f;  // rugs and sills: anything lower is ignored; on tiers, steps too
    float height_m = 1.75f;
};
// The cells, 0.1 m wide, where that body has its clear radius and that it can walk to from below panorama 0 (the
// world's origin), through doorways and up steps (scene/raised_floor.h) too. Empty if no cell within 1.5 m of the
// origin is free. Deterministic; needs no light.
StandableFloor standable_floor(const TracedRoom& room, const Body& body = {});
// Where that body can just fit in: the area that visitors may walk on.
inline StandableFloor passable_floor(const TracedRoom& room, Body body = {}) {
    body.clear_m = body.pass_m;
    return standable_floor(room, body);
}
// Whether a camera at this point has a free ball of that radius around it.
inline bool has_air(const TracedRoom& room, Vec3f viewpoint, float radius_m) {
    return room.clearance(viewpoint, radius_m) >= radius_m;
}

}  // namespace fastscene
