// Adaptive density control as published (Kerbl et al. 2023, section 5): splats whose place on screen is pulled about
// are cloned where small and split where large, faint ones go, opacities are reset now and then. The slots of the dead
// are used again and the number never exceeds the cloud's capacity.
#pragma once

#include <cstdint>

#include "fastscene/scene/view.h"
#include "fastscene/splat/engine.h"

namespace fastscene::splat {

struct Classic {
    float move = 2e-4f;    // mean length of dL/d(position on screen, half pictures)
    float large = 0.01f;   // of the extent: larger ones are split
    float faint = 0.005f;  // opacity
    int every = 100, reset_every = 3000;
    float from = 0.03f, until = 0.5f;  // of the run
};

// Size of the scene, metres. Cameras that stand around a scene span it; ours stand in its middle and look outward,
// where the published measure (the cameras' spread) is a few decimetres: then the distance from them to the points
// counts. Medians: one stray camera or point does not matter.
struct SceneExtent {
    Vec3f middle;  // of the cameras
    float radius_m;
};
SceneExtent scene_extent(const ViewSet& set);

// After the given step. Returns how many splats are new.
std::int64_t densify(Cloud& cloud, const Classic& how, float extent_m, std::uint64_t seed, int step);
void reset_opacities(Cloud& cloud);
// Without the dead ones.
Splats alive(const Splats& splats, float faint);

}  // namespace fastscene::splat
