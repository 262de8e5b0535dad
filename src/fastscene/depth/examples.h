// Pictures whose range is known, as training data: our own rooms (docs/dataset.md), and the layouts of Structured3D and
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
    std::filesystem::path normals, pieces = {};  // of our rooms: docs/dataset.md; empty: none
    std::string place;  // pictures of one room or scene share it: they are trained on together or not at all
    bool held_out = false;
};

// All of a folder, in the order of their names; perspective views are left out. Held out are of our rooms every tenth
// (9, 19 …), of Structured3D the scenes from 3000 on, as published, of Pano3D a tenth of the places by their names.
// Knows a folder by what lies in it:
//   rooms         shard-NNNNN/NNNNNNNN.json
//   Structured3D
//   scene_NNNNN/2D_rendering/ROOM/panorama/{full,simple,empty}/{rgb_rawlight,rgb_warmlight,rgb_coldlight,depth}.png
//   (millimetres) Pano3D        *_color_*.png beside *_depth_*.exr (metres)
// Throws Error when the folder holds none of these.
std::vector<DepthFiles> find_depth_files(const std::filesystem::path& folder);

// At the network's size: color averaged over areas, range and surfaces picked. Throws Error naming the file when a
// picture is no panorama, or the two do not belong together.
DepthExample load_example(const DepthFiles& files, EquirectSize size, bool with_surfaces = false);

// All that `held_out` says, those to train on with their surfaces, loaded once: at 256 x 128 a thousand are 230 MB. A
// pair that cannot be read is told and left out.
std::vector<DepthExample> load_examples(const std::vector<DepthFiles>& files, bool held_out, EquirectSize size,
                                        const Run& run);

// Mean range by latitude, metres, from the top; a row nobody knows takes its neighbour's.
std::vector<float> mean_range_by_latitude(const std::vector<DepthExample>& examples);

}  // namespace fastscene
