// Shade: what a camera ray brings back.
#pragma once

#include "fastscene/scene/room.h"
#include "fastscene/trace/irradiance.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/sampler.h"
#include "fastscene/trace/scene_bvh.h"

namespace fastscene {

struct ShadeScene {
    const Room& room;
    const SceneBvh& bvh;
    const Lights& lights;
    const IrradianceCache& light;
    bool contacts =
        false;            // where the cache is too coarse (edges, corners, small things), light is gathered ray by ray
    bool frugal = false;  // ShotParts::frugal
    float min_alpha = 0;  // ShotParts::min_alpha
};

// What a camera ray brings back, through clear glass from what lies behind it. The parts that chance decides are kept
// apart from the colors they are seen through, so that their noise can be averaged over neighbours without touching a
// texture: radiance = emission + light + sun + mirrored.
struct Shaded {
    Vec3f radiance;
    Vec3f albedo;
    Vec3f light, sun, mirrored;  // radiances: of diffuse light but the sun's, of the sun's, of what the surface mirrors
    Vec3f diffuse, specular;     // what the first two, and the third, were multiplied by
    Vec3f position, normal;      // of the first hit; a normal of zero: none
};
// `pixel_angle`: how wide the sample is, radians; patterns finer than that fade to their mean.
Shaded shade_ray(const ShadeScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, Sampler& sampler);

// Where it would meet a surface, and how that faces, as Shaded has them: a tenth of the work.
struct Met {
    Vec3f position, normal;
};
Met met_by_ray(const ShadeScene& scene, Vec3f origin, Vec3f direction);

}  // namespace fastscene
