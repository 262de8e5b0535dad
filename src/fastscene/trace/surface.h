// What a ray that hits the room finds: the surface at that point.
#pragma once

#include "fastscene/scene/room.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/texture.h"

namespace fastscene {

struct SurfacePointInfo {
    Vec3f position;  // world
    Vec3f normal;    // shading normal, unit, towards where the ray came from
    Vec3f bumped;    // the same with the pattern's relief
    const Material* material = nullptr;
    TextureValue texture;
    bool back = false;  // seen from behind
};

// `footprint_m`: width of what the sample stands for. `with_relief`: compute `bumped` (else it equals `normal`).
SurfacePointInfo surface_at(const Room& room, const RayHit& hit, Vec3f origin, Vec3f direction, float footprint_m,
                            bool with_relief);
// Only position and normal: for light that bounces.
Vec3f shading_normal(const Mesh& mesh, const RayHit& hit);

}  // namespace fastscene
