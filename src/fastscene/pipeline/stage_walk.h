// The walk as it meets the disk.
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

// The published walks estimate range anew after each step where the depth stage estimated it; `depth` says how. `room`:
// what make_panorama returned; null: it is made and lit again where it is needed, and is the same.
void make_walk(const SceneSource& source, const PanoramaParams& panorama, const DepthParams& depth,
               const RunFolder& folder, const WalkParams& params, std::shared_ptr<const TracedRoom> room,
               const std::filesystem::path& out, const Run& run);

}  // namespace fastscene
