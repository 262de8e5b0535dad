// The depth stage: range of panorama 0, and of those of --more.
#pragma once

#include <filesystem>

#include "fastscene/depth/depth.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/pipeline/source_files.h"

namespace fastscene {

void make_depth(const SceneSource& source, const PanoramaParams& panorama, const DepthParams& params,
                SourceFiles& files, const RunFolder& folder, const std::filesystem::path& out, const Run& run);

}  // namespace fastscene
