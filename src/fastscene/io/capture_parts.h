// Shared by the capture readers. Private to io/.
#pragma once

#include "fastscene/scene/capture.h"

namespace fastscene {

// A non-empty relative path without "..".
bool is_name_below(const std::string& name);
void sort_by_name(std::vector<Photo>& photos);
// Finds each photo's file in `images` (or `images`_N for a downscale of N, if that folder exists) and its mask, if any,
// in `masks`: masks/NAME.png (COLMAP's), masks/NAME, or the name with a different or an additional picture extension.
void name_files(Capture& capture, std::filesystem::path images, const std::filesystem::path& masks, int downscale);
std::filesystem::path mask_for(const std::filesystem::path& masks, const std::string& name);
// x y z and red green blue (or diffuse_red …) of a .ply; without colors the points are gray.
std::vector<CapturePoint> points_of_ply(const std::filesystem::path& path);

}  // namespace fastscene
