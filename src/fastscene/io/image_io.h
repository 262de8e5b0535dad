// Pictures: .png .jpg .webp .tif .exr .pfm .hdr. One file a format; this header opens any of them, whatever the file is
// called.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "fastscene/image/image.h"

namespace fastscene {

struct PictureInfo {
    int width = 0, height = 0;  // as stored
    int orientation = 1;        // as EXIF says how it is to be turned (image/orientation.h); load_rgb8 turns nothing
    bool light = false;         // floats: .exr .pfm .hdr, some .tif
};
// As color pictures are called, besides other mixes of large and small letters.
inline constexpr std::array kPictureEndings{".png", ".jpg", ".jpeg", ".webp", ".tif", ".tiff", ".PNG", ".JPG", ".JPEG"};
// Whether a file of a folder is called like a color picture: .png .jpg .jpeg .webp .tif .tiff, small or large.
bool has_picture_ending(const std::filesystem::path& path);
// From the header alone, so that a huge or odd picture is refused before it is decoded.
// Throws Error naming the file, what was expected and what was found.
PictureInfo picture_info(const std::filesystem::path& path);

// 8-bit color from .png, .webp, .tif (any depth, gray and alpha too: alpha over black) or .jpg; truncated files throw
// Error.
ImageRgb8 load_rgb8(const std::filesystem::path& path);
// Linear light in any unit from .hdr (Radiance), .exr (channels R G B, else the one of a map in all three), .pfm or
// .tif of floats. Negative values, NaN and infinity are for the caller to judge.
ImageColor load_light(const std::filesystem::path& path);
// How opaque each pixel is, 255 = fully; empty where every pixel is, or the format knows no alpha.
ImageMask load_alpha(const std::filesystem::path& path);
// The same from a file's bytes; `where` names the picture in errors.
PictureInfo picture_info(std::string_view bytes, const std::string& where);
ImageRgb8 decode_rgb8(std::string_view bytes, const std::string& where);
ImageColor decode_light(std::string_view bytes, const std::string& where);
ImageMask decode_alpha(std::string_view bytes, const std::string& where);
void save_png(const std::filesystem::path& path, const ImageRgb8& image);
void save_png(const std::filesystem::path& path, const ImageMask& image);  // 8-bit gray
ImageMask load_mask_png(const std::filesystem::path& path);                // 8-bit gray
ImageMask load_mask(const std::filesystem::path& path);                    // of any color picture, colors as gray
void save_png16(const std::filesystem::path& path, const Image<std::uint16_t>& image);  // 16-bit gray
void save_jpeg(const std::filesystem::path& path, const ImageRgb8& image, int quality = 92);
std::string encode_jpeg(const ImageRgb8& image, int quality = 92);

// A map of one number a pixel: .exr (channel Z, depth, Y; R, G and B only when they are equal), .pfm (Pf), .tif of
// floats, 16-bit gray .png or .tif
// (`unit` per count, e.g. 0.001 m). A color picture throws Error with what was found in it.
ImageF load_float(const std::filesystem::path& path, float unit = 0.001f);
void save_exr(const std::filesystem::path& path, const ImageF& image);  // 32-bit float, channel Y, ZIP
void save_pfm(const std::filesystem::path& path, const ImageF& image);

}  // namespace fastscene
