// The walk stage.
#pragma once

#include <filesystem>
#include <memory>

#include "fastscene/depth/depth.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/trace/trace.h"
#include "fastscene/walk/walk.h"

namespace fastscene {

struct EarlierRun;

// The published walks estimate range anew after each step if the depth stage estimated it; `depth` has the settings.
// `room`: from make_panorama; null: recreated identically if needed.
void make_walk(const SceneSource& source, const PanoramaParams& panorama, const DepthParams& depth,
               const RunFolder& folder, const WalkParams& params, std::shared_ptr<const TracedRoom> room,
               const EarlierRun* earlier, const std::filesystem::path& out, const Run& run);

}  // namespace fastscene
