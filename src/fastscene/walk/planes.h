// Planes: walls, floor, ceiling and the flat faces of furniture, found in panorama 0. What a piece of furniture
// hides is mostly the rest of such a plane.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/scene/panorama.h"

namespace fastscene {

// normal . p = offset, in the frame of panorama 0; the normal looks towards panorama 0, so offset < 0.
struct ScenePlane {
    Vec3f normal;
    float offset = 0;
    bool hull = false;  // (nearly) nothing of the scene lies behind it: a wall, the floor, the ceiling
    bool on_hull =
        false;  // parallel to such a plane and close to it: a door in a wall, the wall above its tiles, a rug
    bool all_along =
        false;        // behind it and seen as wide or as high, so that it ends only where another was seen nearer by
    Vec3f u, v;       // axes in the plane
    Vec2f low, high;  // its extent along them, metres
    Vec3f at(Vec2f p) const { return normal * offset + u * p.x + v * p.y; }
};
// How far a point may lie off a plane and still belong to it.
inline float plane_tolerance(float range) { return 0.012f + 0.006f * range; }

// Tiles on a wall, a door in it: of planes so near to each other only one is there.
inline bool are_side_by_side(const ScenePlane& a, const ScenePlane& b) {
    return dot(a.normal, b.normal) > 0.97f && std::fabs(a.offset - b.offset) < 0.2f;
}

// Largest first, then the layers of hull planes. Deterministic: the draws are counted, not timed.
std::vector<ScenePlane> find_planes(const ImageF& range, std::uint64_t seed);
// The plane of every pixel, or -1.
Image<std::int16_t> label_planes(const ImageF& range, const std::vector<ScenePlane>& planes);

}  // namespace fastscene
