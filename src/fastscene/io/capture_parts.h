// Shared by the capture readers. Private to io/.
#pragma once

#include <functional>

#include "fastscene/io/capture_io.h"
#include "fastscene/scene/capture.h"

namespace fastscene {

// A non-empty relative path without "..".
bool is_name_below(const std::string& name);
void sort_by_name(std::vector<Photo>& photos);
// Moves a capture far from its origin to near it, in double, and remembers by how much; whole units of thousands.
void take_offset_out(Capture& capture);
// Of pairs of a photo and a point, evenly chosen, the share in which the photo has the point in view.
double share_in_view(const std::vector<Photo>& photos, const std::vector<CapturePoint>& points);
// Finds each photo's file in `images` (or `images`_N for a downscale of N, if that folder exists) and its mask, if any,
// in `masks`: masks/NAME.png (COLMAP's), masks/NAME, or the name with a different or an additional picture extension.
void name_files(Capture& capture, std::filesystem::path images, const std::filesystem::path& masks, int downscale);
std::filesystem::path mask_for(const std::filesystem::path& masks, const std::string& name);
// The same for captures that call pictures by labels: file names without folders, often without ending. Default folder:
// images/ in `dir`, else `dir`.
void name_labelled_files(Capture& capture, const CaptureFolders& folders, const std::filesystem::path& dir);
// Calls give(lens, width, height) for each photo with the size in its picture's header; a photo whose picture cannot be
// read, and which will be dropped for that, has another's.
void give_sizes(Capture& capture, const std::function<void(Lens&, int, int)>& give);
// What all readers end with: points of the user's file, sorted photos, the offset taken out.
void finish_capture(Capture& capture, const CaptureFolders& folders);
// x y z and red green blue (or diffuse_red …) of a .ply; without colors the points are gray.
std::vector<CapturePoint> points_of_ply(const std::filesystem::path& path);

}  // namespace fastscene
