// Plane detection: walls, floor, ceiling and flat furniture faces in panorama 0. What an object hides is mostly the
// continuation of such a plane.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/scene/panorama.h"

namespace fastscene {

// normal . p = offset, in panorama 0's frame; the normal faces panorama 0, so offset < 0.
struct ScenePlane {
    Vec3f normal;
    float offset = 0;
    bool hull = false;  // (nearly) nothing of the scene is behind it: a wall, the floor, the ceiling
    bool on_hull =
        false;  // parallel to a hull plane and close to it: a door in a wall, the wall above its tiles, a rug
    bool all_along =
        // behind the hull plane and seen as wide or as high, so it ends only where another was seen at closer range
        false;
    Vec3f u, v;       // orthonormal axes within the plane
    Vec2f low, high;  // its extent along them, metres
    Vec3f at(Vec2f p) const { return normal * offset + u * p.x + v * p.y; }
};
// Maximum distance of a point that still belongs to a plane.
inline float plane_tolerance(float range) { return 0.012f + 0.006f * range; }

// Tiles on a wall, a door in it: of planes this close to each other only one exists at any position.
inline bool are_side_by_side(const ScenePlane& a, const ScenePlane& b) {
    return dot(a.normal, b.normal) > 0.97f && std::fabs(a.offset - b.offset) < 0.2f;
}

// Largest first, then the layers of hull planes. Deterministic: the number of hypotheses is fixed, not time-limited.
std::vector<ScenePlane> find_planes(const ImageF& range, std::uint64_t seed);
// The plane index of every pixel, or -1.
Image<std::int16_t> label_planes(const ImageF& range, const std::vector<ScenePlane>& planes);

}  // namespace fastscene
