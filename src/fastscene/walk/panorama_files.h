// Finds panoramas with range in folders: our datasets, Structured3D as downloaded, or any others.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/scene/panorama.h"

namespace fastscene {

struct PanoramaFiles {
    std::filesystem::path color, range;
    std::string
        place;         // identifies the room (our sets) or house (Structured3D) of the picture; otherwise the file name
    std::string name;  // the color file's path relative to the searched folder, independent of where that is
};
// Sorted by path:
// - sets made by `fastscene rooms dataset`: the panoramas among their pictures;
// - Structured3D: .../scene_NNNNN/2D_rendering/ROOM/panorama/full/ rgb_rawlight.png with depth.png;
// - NAME.png, .jpg, .webp or .tif beside NAME.range.exr, .pfm, .tif or .png (16 bit, millimetres along the ray; 0 =
// unknown or outside).
// Throws UsageError if it is not a folder or holds no such pair.
std::vector<PanoramaFiles> find_panoramas(const std::filesystem::path& folder);

// Throws Error naming the file: unreadable, not 2:1, or a range map of another aspect ratio. A range map of another
// size is resampled with nearest neighbours.
Panorama load_panorama(const PanoramaFiles& files);

}  // namespace fastscene
