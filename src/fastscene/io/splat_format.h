// The splat formats: one entry each, in a source file of its own under io/splat_formats/ (docs/extend/splat-format.md
// shows how to add one). Everything that lists or chooses formats takes it from here: loaders, `convert`, --help,
// errors and the contract test io/splat_contract_test.cc.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fastscene/base/registry.h"
#include "fastscene/scene/splats.h"

namespace fastscene {

enum class PlyBands {
    all,
    present
};  // always degree 3, as several readers insist (62 floats a splat); or only what there is
struct SplatWriting {
    PlyBands ply_bands = PlyBands::all;
    int spz_version = 3;  // 2, 3 or 4: 3 is read most widely
    Vec3d offset_m = {};  // world: added to all positions, in double; for formats that keep it
};

// What a reader found in a file.
struct ReadSplats {
    Splats splats;
    std::vector<std::string> warnings = {};  // without the file's name
    Vec3d offset_m = {};                     // world: the positions of the file are those of `splats` plus this
    ReadSplats(Splats read) : splats(std::move(read)) {}
};
// Positions beyond this are taken relative to an offset, if the file has them in double: a float's step there is 1 mm.
inline constexpr double kFarFromOrigin_m = 16384;
// What to subtract from positions around `middle`: whole kilometres, or nothing if they are near the origin.
Vec3d offset_for(Vec3d middle_m);

// Largest errors after writing and reading again; 0: exact up to rounding. In the units of Splats' members.
struct SplatPrecision {
    float mean_m = 0;  // within a room
    float log_scale = 0;
    float rotation = 0;       // of the local axes, as the length of a difference
    float opacity_logit = 0;  // for opacities of 5 to 95 %
    float sh0 = 0;
    float sh_rest = 0;  // root of the mean square, where harmonics share a codebook
};

struct SplatFormat {
    std::string name = {};     // as its source file
    std::string ending = {};   // of file names, with its dot, lower case; where two fit, the longer one counts
    std::string about = {};    // what it is, in half a sentence
    std::string readers = {};  // other programs that read it
    int sh_degree = 3;         // the highest degree that it keeps
    bool antialias = true;     // keeps FootprintFilter::antialias
    bool low_pass = true;      // keeps FootprintFilter::low_pass_px2
    bool keeps_order = true;   // splats come back in the order that they were written in
    bool empty = true;         // can hold no splats at all
    bool offset = false;       // keeps SplatWriting::offset_m
    SplatPrecision precision = {};
    Mat3d file_from_world = {};  // axes of its numbers: p_file = file_from_world * p_world
    // Whether a file starts like one of this format. Null: the format has no signature, and the ending tells.
    bool (*recognizes)(std::string_view bytes) = nullptr;
    // `file` is for errors: they name it, the byte or line, what was expected and found.
    ReadSplats (*read)(const std::filesystem::path& file, std::string_view bytes) = nullptr;
    // Splats are finite, of at most sh_degree, in the world's frame. Throws Error for what the format cannot hold.
    std::string (*write)(const Splats& splats, const SplatWriting& writing) = nullptr;
};

// How formats with names for values call the low-pass, in square pixels. Our own; they say nothing of the usual one.
inline constexpr const char* kLowPassKey = "lowPass";
// The low-pass that a file records, or the usual one if no renderer could draw with it.
float low_pass_px2_from(double recorded);
// By the name's ending, upper or lower case; null if it has none of a format.
const SplatFormat* splat_format_of_name(const std::filesystem::path& path);
// ".compressed.ply, .glb, .ply, .sog, .splat or .spz"
std::string splat_endings();
// The axes in words: "x right, y down, z forward".
std::string axes_in_words(const Mat3d& file_from_world);

}  // namespace fastscene
