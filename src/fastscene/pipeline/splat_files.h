// Splats in any file: the formats of io/, SOG by way of the program splat-transform, and the scene of a run's folder.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/run.h"
#include "fastscene/io/splat_io.h"

namespace fastscene {

// Names that a splat file may end in, as a sentence for people.
inline constexpr const char* kSplatFileNames = ".ply, .compressed.ply, .spz, .glb or .sog";
// Whether a file of this name can be written. SOG counts, also where its program is missing.
bool is_splat_file_name(const std::filesystem::path& path);

// Axes of the numbers in a file of this name, as io's file_from_world; SOG has those of PLY.
Mat3d splat_file_from_world(const std::filesystem::path& path);

// What `place` holds: a splat file, or the folder of a run (its splat/scene.ply) or any folder with a scene.ply in it.
// Warns about splats that could not be drawn. Throws Error naming the file; UsageError when a folder holds no scene.
LoadedSplats load_scene(const std::filesystem::path& place, const Run& run);
std::filesystem::path scene_file(const std::filesystem::path& place);

// By the name's ending. Throws UsageError for another one, Error when it cannot be written or splat-transform is
// missing.
void save_scene(const std::filesystem::path& path, const Splats& splats, const SplatWriting& writing, const Run& run);

}  // namespace fastscene
