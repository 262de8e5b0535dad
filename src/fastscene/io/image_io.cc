#include "fastscene/io/image_io.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "fastscene/base/file.h"
#include "fastscene/io/exif.h"
#include "fastscene/io/formats.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

enum class Format { png, jpeg, webp, tiff, heif, jpeg_xl, exr, pfm, radiance };

// Recognizes unsupported picture formats by their first bytes, for error messages.
std::string other_format(std::string_view bytes) {
    using namespace std::string_view_literals;
    if (bytes.empty()) return "an empty file";
    if (bytes.size() >= 12 && bytes.substr(4, 4) == "ftyp") {
        return "a film";
    }
    static constexpr std::pair<std::string_view, const char*> kBegins[] = {
        {"GIF8"sv, "GIF"},
        {"BM"sv, "BMP"},
        {"\0\0\0\x0cjP  "sv, "JPEG 2000"},
        {"\xff\x4f\xff\x51"sv, "JPEG 2000"},
        {"8BPS"sv, "Photoshop"},
        {"P5"sv, "PNM"},
        {"P6"sv, "PNM"},
        {"<!DOCTYPE"sv, "a web page"},
        {"<html"sv, "a web page"},
        {"<svg"sv, "SVG"},
        {"%PDF"sv, "PDF"},
        {"\x93NUMPY"sv, "a NumPy array"},
        {"version https://git-lfs"sv, "a pointer of Git LFS: fetch the file itself (git lfs pull)"}};
    for (const auto& [begin, name] : kBegins)
        if (bytes.starts_with(begin)) return name;
    return "something else";
}

// By content instead of extension: users rename files.
Format format_of(const fs::path& path, std::string_view bytes) {
    const auto begins = [&](std::string_view with) { return bytes.substr(0, with.size()) == with; };
    if (begins("\x89PNG\r\n\x1a\n")) return Format::png;
    if (begins("\xff\xd8")) return Format::jpeg;
    if (begins("RIFF") && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP") return Format::webp;
    for (const std::string_view tiff :
         {std::string_view("II\x2a\0", 4), std::string_view("MM\0\x2a", 4),  // BigTIFF, for more than 4 GiB
          std::string_view("II\x2b\0", 4), std::string_view("MM\0\x2b", 4)})
        if (begins(tiff)) return Format::tiff;
    if (is_heif(bytes)) return Format::heif;
    if (is_jpeg_xl(bytes)) return Format::jpeg_xl;
    if (begins("\x76\x2f\x31\x01")) return Format::exr;
    if (begins("Pf") || begins("PF")) return Format::pfm;
    if (begins("#?")) return Format::radiance;
    throw Error("{}: expected a PNG, JPEG, WebP, TIFF, HEIC, AVIF, JPEG XL, OpenEXR, Radiance or PFM picture, found {}",
                path.string(), other_format(bytes));
}

PictureInfo info_of(const fs::path& path, std::string_view bytes, Format format) {
    switch (format) {
        case Format::png: return png_info(path, bytes);
        case Format::jpeg: return jpeg_info(path, bytes);
        case Format::webp: return webp_info(path, bytes);
        case Format::tiff: return tiff_info(path, bytes);
        case Format::heif: return heif_info(bytes, path.string());
        case Format::jpeg_xl: return jpeg_xl_info(bytes, path.string());
        case Format::exr: return exr_info(bytes, path.string());
        case Format::pfm: return pfm_info(path, bytes);
        case Format::radiance: return radiance_info(path, bytes);
    }
    return {};
}

bool is_opaque(const ImageMask& alpha) {
    return std::all_of(alpha.pixels.begin(), alpha.pixels.end(), [](std::uint8_t a) { return a == 255; });
}

}  // namespace

bool has_picture_ending(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(kPictureEndings.begin(), kPictureEndings.end(), ending) != kPictureEndings.end();
}

PictureInfo picture_info(const fs::path& path) { return picture_info(read_file(path), path.string()); }

PictureInfo picture_info(std::string_view bytes, const std::string& where) {
    const Format format = format_of(where, bytes);
    PictureInfo info = info_of(where, bytes, format);
    if (format == Format::tiff) return info;
    info.orientation = exif_orientation(bytes);
    info.light = format == Format::exr || format == Format::pfm || format == Format::radiance;
    return info;
}

ImageRgb8 decode_rgb8(std::string_view bytes, const std::string& where) {
    switch (format_of(where, bytes)) {
        case Format::png: return decode_png_rgb8(bytes, where);
        case Format::jpeg: return decode_jpeg(bytes, where);
        case Format::webp: return decode_webp_rgb8(bytes, where);
        case Format::tiff: return decode_tiff_rgb8(bytes, where);
        case Format::heif: return decode_heif_rgb8(bytes, where);
        case Format::jpeg_xl: return decode_jpeg_xl_rgb8(bytes, where);
        default:
            throw Error(
                "{}: expected a color picture (PNG, JPEG, WebP, TIFF, HEIC, AVIF or JPEG XL), found floats (OpenEXR, "
                "Radiance or PFM)",
                where);
    }
}

ImageRgb8 load_rgb8(const fs::path& path) { return decode_rgb8(read_file(path), path.string()); }

ImageColor load_light(const fs::path& path) { return decode_light(read_file(path), path.string()); }

ImageColor decode_light(std::string_view bytes, const std::string& where) {
    switch (format_of(where, bytes)) {
        case Format::exr: return decode_exr_color(bytes, where);
        case Format::pfm: return decode_pfm_color(where, bytes);
        case Format::radiance: return decode_radiance(where, bytes);
        case Format::tiff: return decode_tiff_light(bytes, where);
        default:
            throw Error("{}: expected a picture of floats (OpenEXR, Radiance, PFM or TIFF), found 8 or 16 bits", where);
    }
}

ImageMask load_alpha(const fs::path& path) { return decode_alpha(read_file(path), path.string()); }

ImageMask decode_alpha(std::string_view bytes, const std::string& where) {
    const Format format = format_of(where, bytes);
    ImageMask alpha = format == Format::png       ? png_alpha(bytes, where)
                      : format == Format::webp    ? webp_alpha(bytes, where)
                      : format == Format::tiff    ? tiff_alpha(bytes, where)
                      : format == Format::heif    ? heif_alpha(bytes, where)
                      : format == Format::jpeg_xl ? jpeg_xl_alpha(bytes, where)
                                                  : ImageMask{};
    return is_opaque(alpha) ? ImageMask{} : alpha;
}

ColorAndAlpha split_rgba(int width, int height, const std::uint8_t* pixels) {
    ColorAndAlpha out{ImageRgb8(width, height), ImageMask(width, height)};
    for (std::size_t i = 0; i < out.color.size(); ++i, pixels += 4)
        out.color.pixels[i] = {pixels[0], pixels[1], pixels[2]}, out.alpha.pixels[i] = pixels[3];
    return out;
}

ColorAndAlpha decode_color_and_alpha(std::string_view bytes, const std::string& where) {
    const Format format = format_of(where, bytes);
    if (format != Format::png && format != Format::webp) return {decode_rgb8(bytes, where), decode_alpha(bytes, where)};
    ColorAndAlpha out = format == Format::png ? decode_png_color_and_alpha(bytes, where)
                                              : decode_webp_color_and_alpha(bytes, where);
    if (is_opaque(out.alpha)) out.alpha = {};
    return out;
}

ImageMask load_mask(const fs::path& path) {
    if (format_of(path, read_file(path)) == Format::png) return load_mask_png(path);
    const ImageRgb8 picture = load_rgb8(path);
    ImageMask mask(picture.width, picture.height);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        const Rgb8 p = picture.pixels[i];
        mask.pixels[i] = static_cast<std::uint8_t>((54 * p.r + 183 * p.g + 19 * p.b) / 256);
    }
    return mask;
}

ImageF load_float(const fs::path& path, float unit) {
    const std::string bytes = read_file(path);
    switch (format_of(path, bytes)) {
        case Format::png: return load_png_float(path, unit);
        case Format::exr: return decode_exr(bytes, path.string());
        case Format::pfm: return decode_pfm(path, bytes);
        case Format::tiff: return decode_tiff_float(bytes, path.string(), unit);
        default:
            throw Error(
                "{}: expected a float map (EXR, PFM, TIFF or 16-bit PNG), found a JPEG, WebP or Radiance picture",
                path.string());
    }
}

}  // namespace fastscene
