// A panorama of the user's as it came out of its file, decoded once: what is made of it, and what is to be said of it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"

namespace fastscene {

// One of the two pictures is empty; both are upright.
struct PictureFile {
    ImageRgb8 rgb;                     // of 8 or 16 bits: four times smaller than its linear color
    ImageColor light;                  // of floats, exposed as a film would
    std::vector<std::string> remarks;  // turned as EXIF says, exposed, see-through parts made black
    EquirectSize size() const;
    ImageColor color() const&;  // linear
    ImageColor color() &&;
};
// Throws Error naming the file when it is no picture, not 2:1, too small or too large; also while it is still small:
// from the header alone.
PictureFile picture_file_from(std::string_view bytes, const std::filesystem::path& file);

}  // namespace fastscene
