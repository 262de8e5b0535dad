// A tree of boxes over a room's triangles, eight children a node, for traversal on graphics cards (Ylitie, Karras and
// Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs"): boxes are stored in 8 bits
// relative to their node's, and children lie in the slots in which a ray of any octant meets them roughly front to
// back, so that traversal sorts nothing.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fastscene/scene/room.h"

namespace fastscene::vulkan {

// As traverse.glsl reads it, word by word:
//   0-2   low corner of the node's box, floats
//   3     exponents of the steps of x, y and z, a byte each; in the fourth which slots hold nodes
//   4, 5  the first of the children that are nodes, and of the triangles
//   6, 7  a byte a slot: 0 empty; 0x20 | 24 + slot: a node; else triangles: their count in unary << 5 | first of them
//   8-19  a byte a slot: low x, low y, low z, high x, high y, high z, in steps from the low corner
using BvhNode = std::array<std::uint32_t, 20>;

struct BvhTriangle {
    std::array<Vec3f, 3> corners;
    std::uint32_t id;     // number among all triangles of the room, mesh after mesh
    std::uint32_t mesh;   // index into Room::meshes
    std::uint32_t clear;  // lets_light_pass: to light it is not there
};
static_assert(sizeof(BvhTriangle) == 48);

struct Bvh {
    std::vector<BvhNode> nodes;  // the first is the root
    std::vector<BvhTriangle> triangles;
    int depth = 0;  // levels
};
inline constexpr int kMostBvhLevels = 40;  // what traversal has room for
Bvh build_bvh(const Room& room);

}  // namespace fastscene::vulkan
