// Splats of a scene that has changed in places.
#pragma once

#include <functional>
#include <vector>

#include "fastscene/splat/splat.h"

namespace fastscene {

inline constexpr float kOutside_m = 100.f;  // larger than any room: what is farther away is scenery

// The `earlier` splats outside of what changed, and initial ones (initial_splats) at points that changed or that no
// splat is near, in the density that count_for gives. `is_changed`: of a position, world.
Splats continued_splats(const Splats& earlier, const std::vector<SurfacePoint>& points,
                        const std::function<bool(Vec3f)>& is_changed, const SplatParams& params, const Run& run);

}  // namespace fastscene
