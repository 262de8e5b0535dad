// Splat files. The internal world frame is COLMAP's (x right, y down, z forward); all conversions to formats' frames,
// including spherical harmonics, happen here (table in docs/formats.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/io/splat_format.h"
#include "fastscene/scene/splat_edit.h"
#include "fastscene/scene/splats.h"

namespace fastscene {

struct LoadedSplats {
    Splats splats;     // drawable only; all-zero SH degrees dropped
    Cleaning cleaned;  // what was removed
    const SplatFormat* format = nullptr;
    std::vector<std::string> warnings;  // of the reader, without the file's name
    Vec3d offset_m;                     // world: what was subtracted from the file's positions, far from its origin
};
// Loads any of the formats, recognized by its first bytes. Throws Error naming the file, the byte or line, expected and
// actual; memory is bounded by the file's size.
LoadedSplats load_splats(const std::filesystem::path& path);

// By the name's ending. Throws UsageError for another one; Error naming the file for what the format cannot hold, and
// for numbers that are not finite. Harmonics above the format's degree are left out.
void save_splats(const std::filesystem::path& path, const Splats& splats, const SplatWriting& writing = {});

// INRIA's PLY, binary little endian, normals 0.
// A whole number for each splat, in the property "instance", and comments that say what the numbers mean.
struct SplatLabels {
    std::vector<std::uint16_t> values;
    std::vector<std::string> comments;
};
std::string splat_ply_bytes(const Splats& splats, PlyBands bands = PlyBands::all, Vec3d offset_m = {},
                            const SplatLabels& labels = {});
// Splats as they are in the file (not cleaned, so that labels stay beside their splats), and their labels; all comments
// of the file. No splats if the file has no labels.
struct LabelledSplats {
    Splats splats;
    SplatLabels labels;
};
LabelledSplats load_labelled_ply(const std::filesystem::path& path);
// With an offset, positions stay as they are and a comment in the header names it; load_splats reads it.
void save_splat_ply(const std::filesystem::path& path, const Splats& splats, PlyBands bands = PlyBands::all,
                    Vec3d offset_m = {});
// Splats of a .ply or .compressed.ply; like load_splats, without the cleaning report.
Splats load_splat_ply(const std::filesystem::path& path);

// PlayCanvas' compressed PLY: chunks of 256 splats in Morton order.
void save_compressed_ply(const std::filesystem::path& path, const Splats& splats);
std::string compressed_ply_bytes(const Splats& splats);

// Niantic's SPZ, versions 2 and 3 (gzip) and 4 (zstd). Throws Error for positions beyond 2048 m.
std::string spz_bytes(const Splats& splats, int version);
// glTF binary with KHR_gaussian_splatting; an offset becomes the node's translation.
std::string splat_glb_bytes(const Splats& splats, Vec3d offset_m = {});

}  // namespace fastscene
