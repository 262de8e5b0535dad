// A mesh of panoramas with range, for scenes without a known room: photographs and paintings.
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/panorama.h"

namespace fastscene {

// What one panorama shows that none before it did. World frame.
struct RangeSurface {
    std::vector<Vec3f> positions;
    std::vector<Vec2f> uv;                 // (0, 0) is the panorama's top left corner; columns wrap beyond 1
    std::vector<std::uint32_t> triangles;  // facing the viewpoint
};
// Vertices are the pixels of a grid over the range map; flat areas get few triangles. Surfaces end at silhouettes:
// nothing hangs between an edge and what is behind it. At most about `most_triangles`, coarser if need be. The result
// has a surface per panorama. Panoramas without pixels of their own have an empty one.
// `closed`: what is behind a silhouette goes on behind it a little, so that the viewpoint sees no gaps.
std::vector<RangeSurface> range_surfaces(const std::vector<Panorama>& panoramas, int most_triangles, bool closed,
                                         const Run& run);

inline constexpr int kMostRangeTriangles = 250000;

// glTF binary: an unlit mesh per panorama, with its picture as texture (`texture_size`: its greatest width).
std::string range_mesh_glb_bytes(const std::vector<Panorama>& panoramas, int texture_size, const Run& run);
// The same surfaces in at most 5,000 triangles, without materials.
std::string range_collision_glb_bytes(const std::vector<Panorama>& panoramas, const Run& run);

}  // namespace fastscene
