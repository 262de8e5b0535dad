// What the readers of captures share. Private to io/.
#pragma once

#include "fastscene/scene/capture.h"

namespace fastscene {

// Not empty, relative, and without a way up.
bool is_name_below(const std::string& name);
void sort_by_name(std::vector<Photo>& photos);
// Gives each photo its file below `images` (below `images`_N for a downscale of N, where that folder is there) and its
// mask below `masks`, where there is one: masks/NAME.png (COLMAP's), masks/NAME, or the name with another ending of a
// picture, or one behind it.
void name_files(Capture& capture, std::filesystem::path images, const std::filesystem::path& masks, int downscale);
std::filesystem::path mask_for(const std::filesystem::path& masks, const std::string& name);
// x y z and red green blue (or diffuse_red …) of a .ply; without colors the points are gray.
std::vector<CapturePoint> points_of_ply(const std::filesystem::path& path);

}  // namespace fastscene
