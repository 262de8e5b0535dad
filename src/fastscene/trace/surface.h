// Surface attributes at a ray's hit point.
#pragma once

#include "fastscene/scene/room.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/texture.h"

namespace fastscene {

struct SurfacePointInfo {
    Vec3f position;  // world
    Vec3f normal;    // shading normal, unit, facing the ray's origin
    Vec3f bumped;    // with the pattern's relief applied
    const Material* material = nullptr;
    TextureValue texture;
    bool back = false;  // hit from behind

    Vec3f emission() const { return material->emission * texture.shown; }
};

// `footprint_m`: width of the sample on the surface. `with_relief`: compute `bumped` (otherwise it equals `normal`).
SurfacePointInfo surface_at(const Room& room, const RayHit& hit, Vec3f origin, Vec3f direction, float footprint_m,
                            bool with_relief);
// Only the shading normal: for secondary bounces.
Vec3f shading_normal(const Mesh& mesh, const RayHit& hit);

}  // namespace fastscene
