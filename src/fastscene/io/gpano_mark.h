// GPano, Google's Photo Sphere XMP: marks a picture as a 360 degree panorama, so that viewers and map services show it
// as one. In JPEG an APP1 segment, in PNG an iTXt chunk. gpano.h reads it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "fastscene/image/image.h"

namespace fastscene {

struct SphereMark {
    int full_width = 0, full_height = 0;           // of the whole sphere, twice as wide as high
    int left = 0, top = 0, width = 0, height = 0;  // the part of it that the picture shows
    float heading_deg = 0;                         // compass direction of its middle
};
// Of a picture of the whole sphere.
SphereMark whole_sphere(int width, int height);

// The content of a JPEG or PNG file with that mark; an earlier mark is replaced. Throws Error for other formats.
std::string with_gpano(std::string_view file, const SphereMark& pano, const std::string& where);

// An equirectangular picture of the whole sphere, marked as such: .jpg, .jpeg or .png.
void save_panorama(const std::filesystem::path& path, const ImageRgb8& image);

}  // namespace fastscene
