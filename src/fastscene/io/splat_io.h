// Splats in files. World frame inside is COLMAP's (x right, y down, z forward); PLY keeps it.
#pragma once

#include <filesystem>

#include "fastscene/scene/splats.h"

namespace fastscene {

// INRIA's PLY, binary little endian, always 62 floats a vertex (degree 3, missing coefficients 0, normals 0).
void save_splat_ply(const std::filesystem::path& path, const Splats& splats);
// Reads any number of f_rest (0, 9, 24, 45) and extra properties; throws Error with file and offset.
Splats load_splat_ply(const std::filesystem::path& path);
// PlayCanvas' compressed PLY: chunks of 256 splats in Morton order.
void save_compressed_ply(const std::filesystem::path& path, const Splats& splats);
std::string compressed_ply_bytes(const Splats& splats);

}  // namespace fastscene
