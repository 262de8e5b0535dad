// Splats in files. World frame inside is COLMAP's (x right, y down, z forward); the frame of each format is met here
// and nowhere else (docs/formats.md has the table), spherical harmonics turned with it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fastscene/scene/splat_edit.h"
#include "fastscene/scene/splats.h"

namespace fastscene {

enum class SplatFormat { ply, compressed_ply, spz, glb };
// By the name's ending: .ply, .compressed.ply, .spz, .glb.
std::optional<SplatFormat> splat_format_of_name(const std::filesystem::path& path);

// The axes of a format's numbers: p_file = file_from_world(format) * p_world.
Mat3d file_from_world(SplatFormat format);

struct LoadedSplats {
    Splats splats;     // all numbers can be drawn; no bands of zeros
    Cleaning cleaned;  // what it took
    SplatFormat format = SplatFormat::ply;
};
// Any of the formats, by the file's first bytes. Throws Error naming the file, the byte or line, what was expected and
// found; asks for no more memory than the file's size accounts for.
LoadedSplats load_splats(const std::filesystem::path& path);

enum class PlyBands {
    all,
    present
};  // always degree 3, as several readers insist (62 floats a splat); or only what there is
struct SplatWriting {
    PlyBands ply_bands = PlyBands::all;
    int spz_version = 3;  // 2, 3 or 4: 3 is read most widely
};
void save_splats(const std::filesystem::path& path, const Splats& splats, SplatFormat format,
                 const SplatWriting& writing = {});

// INRIA's PLY, binary little endian, normals 0.
void save_splat_ply(const std::filesystem::path& path, const Splats& splats, PlyBands bands = PlyBands::all);
// Splats of a .ply or .compressed.ply; as load_splats, without what it took.
Splats load_splat_ply(const std::filesystem::path& path);

// PlayCanvas' compressed PLY: chunks of 256 splats in Morton order.
void save_compressed_ply(const std::filesystem::path& path, const Splats& splats);
std::string compressed_ply_bytes(const Splats& splats);

// Niantic's SPZ, versions 2 and 3 (gzip) and 4 (zstd). Positions beyond 2048 m do not fit: Error.
std::string spz_bytes(const Splats& splats, int version);
// glTF binary with KHR_gaussian_splatting.
std::string splat_glb_bytes(const Splats& splats);

}  // namespace fastscene
