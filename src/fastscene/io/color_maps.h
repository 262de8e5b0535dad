// Maps of three numbers a pixel: light as EXR, counts as 16-bit PNG. load_light (image_io.h) reads the former.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>

#include "fastscene/image/image.h"

namespace fastscene {

using Image3x16 = Image<std::array<std::uint16_t, 3>>;

void save_png16(const std::filesystem::path& path, const Image3x16& image);  // 16-bit RGB
Image3x16 load_png16(const std::filesystem::path& path);
// 16-bit float, channels R, G and B, ZIP. Values beyond its range become the largest that it has.
void save_exr_light(const std::filesystem::path& path, const ImageColor& image);

}  // namespace fastscene
