// Where the training of an edited scene begins: at the splats of the run before.
#pragma once

#include <optional>
#include <vector>

#include "fastscene/pipeline/earlier_run.h"
#include "fastscene/splat/splat.h"

namespace fastscene {

// The earlier splats, except where the edit changed surfaces or their looks, and new ones there and wherever none are.
// Nothing if most of what is seen changed, or if they are of another SH degree. `folder`: of the new run.
std::optional<Splats> earlier_splats(const EarlierRun& earlier, const RunFolder& folder,
                                     const std::vector<SurfacePoint>& points, const SplatParams& params,
                                     const Run& run);

}  // namespace fastscene
