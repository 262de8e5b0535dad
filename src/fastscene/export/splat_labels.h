// What each splat of a known room belongs to.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/splats.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// The instance (instances.h) of each splat: what cameras at `viewpoints` see where the splat is. 0: the outside. The
// nearest surface would not do: a picture's splats may lie behind its canvas, nearer to the wall, and what a mirror
// shows lies metres behind it.
std::vector<std::uint16_t> splat_labels(const Splats& splats, const TracedRoom& room,
                                        const std::vector<Vec3f>& viewpoints, const Run& run);

}  // namespace fastscene
