// Path tracer: the radiance of a camera ray by unidirectional path tracing with next-event estimation. No cache, and no
// bias except the approximations of the reflection model (response.h). The reference for the cached pictures.
#pragma once

#include "fastscene/trace/lights.h"
#include "fastscene/trace/sampler.h"
#include "fastscene/trace/scene_bvh.h"

namespace fastscene {

struct PathScene {
    const Room& room;
    const SceneBvh& bvh;
    const Lights& lights;
};
// Radiance along a ray (`direction` of unit length). Light and BSDF sampling are combined by multiple importance
// sampling with Veach's power heuristic. `pixel_angle`: width of the sample in radians.
Vec3f path_radiance(const PathScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, Sampler& sampler);

}  // namespace fastscene
