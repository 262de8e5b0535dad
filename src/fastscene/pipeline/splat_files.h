// Splats of a file in any format, or of a run's folder.
#pragma once

#include <filesystem>

#include "fastscene/base/run.h"
#include "fastscene/io/splat_io.h"

namespace fastscene {

// What `place` holds: a splat file, or the folder of a run (its splat/scene.ply) or any folder with a scene.ply in it.
// Warns about splats that could not be drawn. Throws Error naming the file; UsageError when a folder holds no scene.
LoadedSplats load_scene(const std::filesystem::path& place, const Run& run);
std::filesystem::path scene_file(const std::filesystem::path& place);

}  // namespace fastscene
