// Shade: what a camera ray brings back.
#pragma once

#include "fastscene/base/random.h"
#include "fastscene/scene/room.h"
#include "fastscene/trace/irradiance.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/scene_bvh.h"

namespace fastscene {

struct ShadeScene {
    const Room& room;
    const SceneBvh& bvh;
    const Lights& lights;
    const IrradianceCache& light;
};

struct Shaded {
    Vec3f radiance;
    Vec3f albedo;
};
// Radiance along a ray: diffuse light from the cache, sun by its own shadow ray, one mirror-like reflection, emission.
// `pixel_angle`: how wide the sample is, radians; patterns finer than that fade to their mean.
Shaded shade_ray(const ShadeScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, Random& random);

}  // namespace fastscene
