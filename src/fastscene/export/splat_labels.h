// What each splat of a known room belongs to.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/scene/splats.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// The instance (instances.h) with the surface nearest to each splat's mean; 0, the outside, for those far from all.
std::vector<std::uint16_t> splat_labels(const Splats& splats, const TracedRoom& room, const Run& run);

}  // namespace fastscene
