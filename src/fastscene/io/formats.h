// Interface of one picture format to image_io.cc, which dispatches on the file's first bytes. Private to io/.
#pragma once

#include <algorithm>
#include <string_view>

#include "fastscene/base/error.h"
#include "fastscene/io/image_io.h"

namespace fastscene {

// Decoders refuse larger sides before allocating memory.
inline constexpr int kMaxPictureSide = 32768;
inline constexpr std::int64_t kMaxPicturePixels = std::int64_t{1} << 28;

inline bool plausible_size(std::int64_t width, std::int64_t height) {
    return width >= 1 && height >= 1 && width <= kMaxPictureSide && height <= kMaxPictureSide &&
           width * height <= kMaxPicturePixels;
}

// Of rows of red, green, blue and alpha.
ColorAndAlpha split_rgba(int width, int height, const std::uint8_t* pixels);

PictureInfo png_info(const std::filesystem::path& path, std::string_view bytes);
ImageRgb8 decode_png_rgb8(std::string_view bytes, const std::string& where);
// Empty if the file has no alpha.
ImageMask png_alpha(std::string_view bytes, const std::string& where);
ColorAndAlpha decode_png_color_and_alpha(std::string_view bytes, const std::string& where);
ImageF load_png_float(const std::filesystem::path& path, float unit);

PictureInfo jpeg_info(const std::filesystem::path& path, std::string_view bytes);
ImageRgb8 decode_jpeg(std::string_view bytes, const std::string& where);

PictureInfo webp_info(const std::filesystem::path& path, std::string_view bytes);
ImageRgb8 decode_webp_rgb8(std::string_view bytes, const std::string& where);
ImageMask webp_alpha(std::string_view bytes, const std::string& where);
ColorAndAlpha decode_webp_color_and_alpha(std::string_view bytes, const std::string& where);

// Also fills `light` and `orientation`. Range: 16 bits times `unit`, or 32-bit float as stored.
PictureInfo tiff_info(const std::filesystem::path& path, std::string_view bytes);
ImageRgb8 decode_tiff_rgb8(std::string_view bytes, const std::string& where);
ImageMask tiff_alpha(std::string_view bytes, const std::string& where);
ImageF decode_tiff_float(std::string_view bytes, const std::string& where, float unit);
ImageColor decode_tiff_light(std::string_view bytes, const std::string& where);

// HEIC and AVIF, and JPEG XL: throw Error if the build has no library for them. Sizes and pictures are upright.
bool is_heif(std::string_view bytes);
PictureInfo heif_info(std::string_view bytes, const std::string& where);
ImageRgb8 decode_heif_rgb8(std::string_view bytes, const std::string& where);
ImageMask heif_alpha(std::string_view bytes, const std::string& where);
bool is_jpeg_xl(std::string_view bytes);
PictureInfo jpeg_xl_info(std::string_view bytes, const std::string& where);
ImageRgb8 decode_jpeg_xl_rgb8(std::string_view bytes, const std::string& where);
ImageMask jpeg_xl_alpha(std::string_view bytes, const std::string& where);

PictureInfo exr_info(std::string_view bytes, const std::string& where);
ImageF decode_exr(std::string_view bytes, const std::string& where);
ImageColor decode_exr_color(std::string_view bytes, const std::string& where);

PictureInfo pfm_info(const std::filesystem::path& path, std::string_view bytes);
ImageF decode_pfm(const std::filesystem::path& path, std::string_view bytes);
ImageColor decode_pfm_color(const std::filesystem::path& path, std::string_view bytes);

PictureInfo radiance_info(const std::filesystem::path& path, std::string_view bytes);
ImageColor decode_radiance(const std::filesystem::path& path, std::string_view bytes);

}  // namespace fastscene
