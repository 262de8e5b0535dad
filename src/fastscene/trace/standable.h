// Standable: where a person can stand in a room, found from its surfaces: no plan is needed, and a second room behind a
// doorway counts.
#pragma once

#include "fastscene/scene/standable_floor.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// Who stands there. A person turns sideways to get through between a bed and a wall, and wants more air to stand still.
struct Body {
    float clear_m = 0.25f;      // kept clear around the body's axis where it stands
    float pass_m = 0.15f;       // … and where it passes
    float step_over_m = 0.05f;  // rugs and sills: lower things do not count
    float height_m = 1.75f;
};
// The cells, 0.1 m wide, on which that body stands clear of everything and to which it can walk from where panorama 0
// stands (the world's origin); through doorways too. No cell is standable when there is no free one within 1.5 m of the
// origin. Deterministic; needs no light.
StandableFloor standable_floor(const TracedRoom& room, const Body& body = {});
// Wherever that body can squeeze in: what visitors may walk on.
inline StandableFloor passable_floor(const TracedRoom& room, Body body = {}) {
    body.clear_m = body.pass_m;
    return standable_floor(room, body);
}
// Whether an viewpoint at this point has so much air around it.
inline bool has_air(const TracedRoom& room, Vec3f viewpoint, float radius_m) {
    return room.clearance(viewpoint, radius_m) >= radius_m;
}

}  // namespace fastscene
