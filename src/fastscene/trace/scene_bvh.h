// The room's triangles in Embree. The only header that knows it is not here: Embree stays in scene_bvh.cc.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "fastscene/scene/room.h"

namespace fastscene {

inline constexpr float kFar = std::numeric_limits<float>::infinity();

// How far from a surface a ray starts that leaves it.
inline constexpr float kSurfaceOffset = 4e-4f;
inline Vec3f offset_from(Vec3f position, Vec3f normal) { return position + normal * kSurfaceOffset; }

struct RayHit {
    float distance = kFar;  // +inf: nothing was hit
    int mesh = -1;          // index into Room::meshes
    int triangle = 0;
    float u = 0, v = 0;  // weights of the second and third corner
    Vec3f normal;        // geometric, unit, as the triangle is wound (outward)
    bool back = false;   // the triangle was met from behind
    explicit operator bool() const { return mesh >= 0; }
};

class SceneBvh {
  public:
    explicit SceneBvh(const Room& room);  // keeps no reference
    ~SceneBvh();
    SceneBvh(const SceneBvh&) = delete;
    SceneBvh& operator=(const SceneBvh&) = delete;

    // `direction` of length 1.
    RayHit first_hit(Vec3f origin, Vec3f direction, float near_m = 0.f, float far_m = kFar) const;
    // The same for light on its way: clear glass (is_clear) is not there.
    RayHit first_lit(Vec3f origin, Vec3f direction) const;
    // Whether light is: clear glass lets it through.
    bool blocked(Vec3f origin, Vec3f direction, float near_m, float far_m) const;
    // Distance to the nearest triangle, at most limit_m.
    float nearest(Vec3f point, float limit_m) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Whether every edge of the mesh has a neighbour: then its back faces are its inside.
bool is_closed(const Mesh& mesh);

}  // namespace fastscene
