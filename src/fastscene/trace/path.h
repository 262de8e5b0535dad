// Path: what a camera ray brings back by plain path tracing: no cache, nothing kept between pixels, no bias but that of
// the room's own approximations (response.h). The measure of the cached pictures, and of the light's own correctness.
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
// Radiance along a ray. Light is asked directly at every surface and also found by chance, each weighted by how well it
// does (Veach's power heuristic).
Vec3f path_radiance(const PathScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, Sampler& sampler);

}  // namespace fastscene
