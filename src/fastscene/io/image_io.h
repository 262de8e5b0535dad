// Pictures: .png .jpg .webp .tif .heic .avif .jxl .exr .pfm .hdr. One source file per format; this header opens any of
// them, whatever the file is called.
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
    int orientation = 1;        // EXIF orientation (image/orientation.h); load_rgb8 does not apply it
    bool light = false;         // floating point: .exr .pfm .hdr, some .tif
};
// Extensions of color pictures, compared case-insensitively.
inline constexpr std::array kPictureEndings{".png",  ".jpg",  ".jpeg", ".webp", ".tif", ".tiff", ".heic",
                                            ".heif", ".avif", ".jxl",  ".PNG",  ".JPG", ".JPEG", ".HEIC"};
// Whether a file has the extension of a color picture: .png .jpg .jpeg .webp .tif .tiff .heic .heif .avif .jxl, in any
// case.
bool has_picture_ending(const std::filesystem::path& path);
// From the header alone, so that huge or unusual pictures can be refused before decoding. Throws Error naming the file,
// expected and actual.
PictureInfo picture_info(const std::filesystem::path& path);

// 8-bit color from .png, .webp, .tif (any depth, gray, alpha: blended over black) or .jpg; truncated files throw Error.
ImageRgb8 load_rgb8(const std::filesystem::path& path);
// Linear radiance in any unit from .hdr (Radiance), .exr (channels R G B, or a single channel in all three), .pfm or
// floating-point .tif. Negative values, NaN and infinity are passed on to the caller.
ImageColor load_light(const std::filesystem::path& path);
// Opacity per pixel, 255 = opaque; empty if all pixels are opaque or the format has no alpha.
ImageMask load_alpha(const std::filesystem::path& path);
// The same from a file's content; `where` names the picture in errors.
PictureInfo picture_info(std::string_view bytes, const std::string& where);
ImageRgb8 decode_rgb8(std::string_view bytes, const std::string& where);
ImageColor decode_light(std::string_view bytes, const std::string& where);
ImageMask decode_alpha(std::string_view bytes, const std::string& where);
// Colors that alpha has not dimmed, where the format keeps both apart (.png .webp); otherwise as decode_rgb8.
struct ColorAndAlpha {
    ImageRgb8 color;
    ImageMask alpha;  // as decode_alpha's
};
ColorAndAlpha decode_color_and_alpha(std::string_view bytes, const std::string& where);
void save_png(const std::filesystem::path& path, const ImageRgb8& image);
void save_png(const std::filesystem::path& path, const ImageMask& image);  // 8-bit gray
ImageMask load_mask_png(const std::filesystem::path& path);                // 8-bit gray
ImageMask load_mask(const std::filesystem::path& path);                    // from any color picture, converted to gray
void save_png16(const std::filesystem::path& path, const Image<std::uint16_t>& image);  // 16-bit gray
void save_jpeg(const std::filesystem::path& path, const ImageRgb8& image, int quality = 92);
std::string encode_jpeg(const ImageRgb8& image, int quality = 92);

// A single-channel map: .exr (channel Z, depth, Y; R, G and B only if they are equal), .pfm (Pf), floating-point .tif,
// 16-bit gray .png or .tif (`unit` per count, e.g. 0.001 m). A color picture throws Error describing its content.
ImageF load_float(const std::filesystem::path& path, float unit = 0.001f);
void save_exr(const std::filesystem::path& path, const ImageF& image);  // 32-bit float, channel Y, ZIP
void save_pfm(const std::filesystem::path& path, const ImageF& image);

}  // namespace fastscene
