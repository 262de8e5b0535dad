// Adaptive density control as published (Kerbl et al. 2023, section 5): splats with large screen-space gradients are
// cloned if small and split if large, faint ones are removed, and opacities are reset from time to time. Slots of
// removed splats are reused; the number never exceeds the cloud's capacity.
#pragma once

#include <cstdint>

#include "fastscene/scene/view.h"
#include "fastscene/splat/engine.h"

namespace fastscene::splat {

struct Classic {
    float move = 2e-4f;    // threshold on the mean length of dL/d(screen position), in half picture widths
    float large = 0.01f;   // larger ones are split; relative to the scene's extent
    float faint = 0.005f;  // splats below this opacity are removed
    int every = 100, reset_every = 3000;
    float from = 0.03f, until = 0.5f;  // active range, as a share of the run
};

// Size of the scene, metres. The published measure, the spread of the cameras, assumes that they surround the scene.
// Ours stand in its middle and look outward, so their spread is only decimetres: here the distance from the cameras to
// the points counts. Medians make it robust against a stray camera or point.
struct SceneExtent {
    Vec3f middle;  // median camera position
    float radius_m;
};
SceneExtent scene_extent(const ViewSet& set);

// Call after the given step. Returns the number of new splats.
std::int64_t densify(Cloud& cloud, const Classic& how, float extent_m, std::uint64_t seed, int step);
void reset_opacities(Cloud& cloud);
// Copy without the removed splats.
Splats alive(const Splats& splats, float faint);

}  // namespace fastscene::splat
