// Shading of camera rays from the irradiance cache.
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
    bool contacts = false;  // sample the light anew where the cache is too coarse (edges, corners, small objects)
    bool frugal = false;    // ShotParts::frugal
    float min_alpha = 0;    // ShotParts::min_alpha
};

// The result of a camera ray, seen through clear glass. Noisy light is kept separate from the surface colors that
// multiply it, so that it can be denoised without blurring textures: radiance = emission + light + sun + mirrored.
struct Shaded {
    Vec3f radiance;
    Vec3f albedo;
    Vec3f light, sun, mirrored;  // radiance of: diffuse light without direct sun, direct sun, specular reflection
    Vec3f diffuse, specular;     // factors already applied: `diffuse` to light and sun, `specular` to mirrored
    Vec3f position, normal;      // at the first hit, world frame; a zero normal: no hit
};
// `direction`: unit length. `pixel_angle`: width of the sample in radians; finer texture detail fades to its mean.
Shaded shade_ray(const ShadeScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, Sampler& sampler);

// Only position and normal of the hit, as in Shaded: a tenth of the cost.
struct Met {
    Vec3f position, normal;
};
Met met_by_ray(const ShadeScene& scene, Vec3f origin, Vec3f direction);

}  // namespace fastscene
