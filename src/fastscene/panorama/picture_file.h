// A user's panorama, decoded once, with the remarks about it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"
#include "fastscene/panorama/sphere_part.h"

namespace fastscene {

// Exactly one of the two pictures is set; both are upright, level and cover the whole sphere.
struct PictureFile {
    ImageRgb8 rgb;                     // 8 or 16 bit sources: four times smaller than linear color
    ImageColor light;                  // floating-point sources, tone mapped
    ImageMask missing;                 // 255: the file has nothing there; empty: it has everything
    std::vector<std::string> remarks;  // rotated by EXIF, tone mapped, a part of a panorama …
    EquirectSize size() const;
    ImageColor color() const&;  // linear
    ImageColor color() &&;
};
// Throws Error naming the file if it is not a picture, not a panorama by its shape, its XMP or `layout`, too small or
// too large; based on the header, before decoding.
PictureFile picture_file_from(std::string_view bytes, const std::filesystem::path& file,
                              const PictureLayout& layout = {});
// The same of a folder with the six faces of a cube, named px nx py ny pz nz, right left up down front back, or by the
// first letters of those, each perhaps after other words (room_px.jpg).
PictureFile picture_file_of_faces(const std::filesystem::path& folder);
// Its files: right, left, up, down, front, back. Throws Error naming the folder if one is missing.
std::vector<std::filesystem::path> cube_face_files(const std::filesystem::path& folder);
// Missing pixels of a downsampled panorama: those that cover any.
ImageMask reduced_missing(const ImageMask& missing, int width);

}  // namespace fastscene
