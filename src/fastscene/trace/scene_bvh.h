// Ray tracing of the room's triangles. Embree is an implementation detail of scene_bvh.cc.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "fastscene/scene/room.h"

namespace fastscene {

inline constexpr float kFar = std::numeric_limits<float>::infinity();

// Offset in metres of a ray's origin from the surface that it leaves.
inline constexpr float kSurfaceOffset = 4e-4f;
inline Vec3f offset_from(Vec3f position, Vec3f normal) { return position + normal * kSurfaceOffset; }

struct RayHit {
    float distance = kFar;  // metres; +inf: no hit
    int mesh = -1;          // index into Room::meshes
    int triangle = 0;
    float u = 0, v = 0;  // barycentric weights of the second and third vertex
    Vec3f normal;        // geometric normal, unit, by the winding order (outward)
    bool back = false;   // hit from behind
    explicit operator bool() const { return mesh >= 0; }
};

// Settings for rtcNewDevice. Embree's kernels of each instruction set round differently, so those for AVX2 are used on
// processors with AVX-512 too, where they are as fast for single rays: a room looks the same on both, byte by byte.
const char* embree_settings();

class SceneBvh {
  public:
    explicit SceneBvh(const Room& room);  // does not keep a reference
    ~SceneBvh();
    SceneBvh(const SceneBvh&) = delete;
    SceneBvh& operator=(const SceneBvh&) = delete;

    // The first hit between near_m and far_m. `direction`: unit length.
    RayHit first_hit(Vec3f origin, Vec3f direction, float near_m = 0.f, float far_m = kFar) const;
    // The same as light sees it: clear glass and flames (lets_light_pass) do not exist.
    RayHit first_lit(Vec3f origin, Vec3f direction) const;
    // Whether an occluder lies in between; clear glass and flames are none.
    bool blocked(Vec3f origin, Vec3f direction, float near_m, float far_m) const;
    // Distance in metres to the nearest triangle, at most limit_m.
    float nearest(Vec3f point, float limit_m) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Whether the mesh is watertight: every edge has a neighbour, so back faces mean inside.
bool is_closed(const Mesh& mesh);

}  // namespace fastscene
