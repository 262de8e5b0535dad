// Pictures with known range as training data: our own rooms (docs/dataset.md), and the layouts of Structured3D and
// Pano3D.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/nn/egformer_training.h"

namespace fastscene {

struct DepthFiles {
    std::filesystem::path color, range;
    std::filesystem::path normals, pieces = {};  // for our rooms (docs/dataset.md); empty: none
    std::string place;  // pictures with the same place (room, scene) are never split between training and validation
    bool held_out = false;
};

// All pictures of a folder, sorted by name, without perspective views. Held out are every tenth of our rooms (9, 19 …),
// Structured3D's scenes from 3000 on, as published, and a tenth of Pano3D's places by name. The kind of folder is
// recognized by its contents:
// rooms: shard-NNNNN/NNNNNNNN.json
// Structured3D:
// scene_NNNNN/2D_rendering/ROOM/panorama/{full,simple,empty}/{rgb_rawlight,rgb_warmlight,rgb_coldlight,depth}.png
// (millimetres)
// Pano3D: *_color_*.png beside *_depth_*.exr (metres)
// Throws Error if the folder contains none of these.
std::vector<DepthFiles> find_depth_files(const std::filesystem::path& folder);

// At the network's size: color is area-averaged, range and surfaces use nearest neighbours. Throws Error naming the
// file if a picture is not a panorama or the two do not match.
DepthExample load_example(const DepthFiles& files, EquirectSize size, bool with_surfaces = false);

// Loads all examples with the given `held_out`; training examples include surfaces. At 256 x 128 a thousand take 230
// MB. Unreadable pairs are reported and skipped.
std::vector<DepthExample> load_examples(const std::vector<DepthFiles>& files, bool held_out, EquirectSize size,
                                        const Run& run);

// Mean range by latitude, metres, from the top; rows without data copy their neighbour's.
std::vector<float> mean_range_by_latitude(const std::vector<DepthExample>& examples);

}  // namespace fastscene
