// A user's panorama, decoded once, with the remarks about it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"

namespace fastscene {

// Exactly one of the two pictures is set; both are upright.
struct PictureFile {
    ImageRgb8 rgb;                     // 8 or 16 bit sources: four times smaller than linear color
    ImageColor light;                  // floating-point sources, tone mapped
    std::vector<std::string> remarks;  // rotated by EXIF, tone mapped, transparent parts made black
    EquirectSize size() const;
    ImageColor color() const&;  // linear
    ImageColor color() &&;
};
// Throws Error naming the file if it is not a picture, not 2:1, too small or too large; based on the header, before
// decoding.
PictureFile picture_file_from(std::string_view bytes, const std::filesystem::path& file);

}  // namespace fastscene
