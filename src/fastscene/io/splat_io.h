// Splat files. The internal world frame is COLMAP's (x right, y down, z forward); all conversions to formats' frames,
// including spherical harmonics, happen here (table in docs/formats.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fastscene/scene/splat_edit.h"
#include "fastscene/scene/splats.h"

namespace fastscene {

enum class SplatFormat { ply, compressed_ply, spz, glb };
// By extension: .ply, .compressed.ply, .spz, .glb.
std::optional<SplatFormat> splat_format_of_name(const std::filesystem::path& path);

// The axes of a format's numbers: p_file = file_from_world(format) * p_world.
Mat3d file_from_world(SplatFormat format);

struct LoadedSplats {
    Splats splats;     // drawable only; all-zero SH degrees dropped
    Cleaning cleaned;  // what was removed
    SplatFormat format = SplatFormat::ply;
};
// Loads any of the formats, recognized by its first bytes. Throws Error naming the file, the byte or line, expected and
// actual; memory is bounded by the file's size.
LoadedSplats load_splats(const std::filesystem::path& path);

enum class PlyBands { all, present };  // padded to degree 3, as several readers require (62 floats per splat); or as is
struct SplatWriting {
    PlyBands ply_bands = PlyBands::all;
    int spz_version = 3;  // 2, 3 or 4; 3 is the most widely supported
};
void save_splats(const std::filesystem::path& path, const Splats& splats, SplatFormat format,
                 const SplatWriting& writing = {});

// INRIA's PLY, binary little endian, normals 0.
void save_splat_ply(const std::filesystem::path& path, const Splats& splats, PlyBands bands = PlyBands::all);
// Splats of a .ply or .compressed.ply; like load_splats, without the cleaning report.
Splats load_splat_ply(const std::filesystem::path& path);

// PlayCanvas' compressed PLY: chunks of 256 splats in Morton order.
void save_compressed_ply(const std::filesystem::path& path, const Splats& splats);
std::string compressed_ply_bytes(const Splats& splats);

// Niantic's SPZ, versions 2 and 3 (gzip) and 4 (zstd). Throws Error for positions beyond 2048 m.
std::string spz_bytes(const Splats& splats, int version);
// glTF binary with KHR_gaussian_splatting.
std::string splat_glb_bytes(const Splats& splats);

}  // namespace fastscene
