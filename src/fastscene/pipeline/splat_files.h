// Splat files in any format: those of io/, SOG via the program splat-transform, and the scene of a run folder.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/run.h"
#include "fastscene/io/splat_io.h"

namespace fastscene {

// Supported extensions, as a phrase for messages.
inline constexpr const char* kSplatFileNames = ".ply, .compressed.ply, .spz, .glb or .sog";
// Whether a file of this name can be written. Includes SOG, even if its program is missing.
bool is_splat_file_name(const std::filesystem::path& path);

// Axes of a format, by file name, as in io's file_from_world; SOG's are PLY's.
Mat3d splat_file_from_world(const std::filesystem::path& path);

// Loads a splat file, the splat/scene.ply of a run folder, or the scene.ply in any folder. Warns about splats that
// cannot be drawn. Throws Error naming the file; UsageError if a folder contains no scene.
LoadedSplats load_scene(const std::filesystem::path& place, const Run& run);
std::filesystem::path scene_file(const std::filesystem::path& place);

// The format follows from the extension. Throws UsageError for an unknown one, Error if the file cannot be written or
// splat-transform is missing.
void save_scene(const std::filesystem::path& path, const Splats& splats, const SplatWriting& writing, const Run& run);

}  // namespace fastscene
