// Panoramas with range as they lie in folders: ours, Structured3D's as downloaded, or anybody's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/scene/panorama.h"

namespace fastscene {

struct PanoramaFiles {
    std::filesystem::path color, range;
    std::string
        place;  // pictures of one room (ours), of one house (Structured3D) have one place; else the name of the file
    std::string name;  // the color file's path below the folder that was searched: the same from wherever and however
                       // that is named
};
// In the order of their paths:
//   - what `fastscene rooms dataset` made: the panoramas among its pictures;
//   - Structured3D: .../scene_NNNNN/2D_rendering/ROOM/panorama/full/ rgb_rawlight.png with depth.png;
//   - NAME.png, .jpg, .webp or .tif beside NAME.range.exr, .pfm, .tif or .png (16 bit, millimetres along the ray; 0 =
//   unknown or outside).
// Throws UsageError when the folder is none or holds no such pair.
std::vector<PanoramaFiles> find_panoramas(const std::filesystem::path& folder);

// Throws Error naming the file: not readable, not twice as wide as high, range of another shape. A range map of another
// size is picked from, pixel by pixel.
Panorama load_panorama(const PanoramaFiles& files);

}  // namespace fastscene
