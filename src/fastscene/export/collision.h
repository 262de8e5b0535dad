// Colliders: the room as closed boxes, few enough for any physics engine.
#pragma once

#include <string>
#include <vector>

#include "fastscene/scene/room.h"

namespace fastscene {

inline constexpr int kMostColliderTriangles = 5000;

struct Box {
    Vec3f low, high;
};
// Boxes along a thing's axes (the walls' for the shell) that together hold its surface.
struct Collider {
    std::string id;  // object_ids(), "floor", "walls", "ceiling"
    Rigid world_from_boxes;
    std::vector<Box> boxes;
};
// Things lower than a step (rugs) have none: one walks over them. `floor_y`: of the lowest floor, a flat slab; tiers
// and the steps between them are boxes of their own.
std::vector<Collider> colliders(const Room& room, float floor_y);
// glTF binary with a node per collider, 12 triangles per box; without materials.
std::string collision_glb_bytes(const Room& room, float floor_y);

}  // namespace fastscene
