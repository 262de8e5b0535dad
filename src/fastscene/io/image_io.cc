#include "fastscene/io/image_io.h"

#include "fastscene/base/file.h"
#include "fastscene/io/exif.h"
#include "fastscene/io/formats.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

enum class Format { png, jpeg, exr, pfm, radiance };

// By content, not by name: users rename files.
Format format_of(const fs::path& path, std::string_view bytes) {
    if (bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n") return Format::png;
    if (bytes.substr(0, 2) == "\xff\xd8") return Format::jpeg;
    if (bytes.substr(0, 4) == "\x76\x2f\x31\x01") return Format::exr;
    if (bytes.substr(0, 2) == "Pf" || bytes.substr(0, 2) == "PF") return Format::pfm;
    if (bytes.substr(0, 2) == "#?") return Format::radiance;
    throw Error("{}: expected a PNG, JPEG, OpenEXR, Radiance or PFM picture, found {}", path.string(),
                bytes.empty() ? "an empty file" : "something else");
}

}  // namespace

namespace {

PictureInfo size_of(const fs::path& path, std::string_view bytes, Format format) {
    switch (format) {
        case Format::png: return png_info(path, bytes);
        case Format::jpeg: return jpeg_info(path, bytes);
        case Format::exr: return exr_info(path);
        case Format::pfm: return pfm_info(path, bytes);
        case Format::radiance: return radiance_info(path, bytes);
    }
    return {};
}

}  // namespace

PictureInfo picture_info(const fs::path& path) {
    const std::string bytes = read_file(path);
    const Format format = format_of(path, bytes);
    PictureInfo info = size_of(path, bytes, format);
    info.orientation = exif_orientation(bytes);
    info.light = format != Format::png && format != Format::jpeg;
    return info;
}

ImageRgb8 decode_rgb8(std::string_view bytes, const std::string& where) {
    switch (format_of(where, bytes)) {
        case Format::png: return decode_png_rgb8(bytes, where);
        case Format::jpeg: return decode_jpeg(bytes, where);
        default: throw Error("{}: expected a color picture (PNG or JPEG), found floats (OpenEXR, Radiance or PFM)", where);
    }
}

ImageRgb8 load_rgb8(const fs::path& path) { return decode_rgb8(read_file(path), path.string()); }

ImageColor load_light(const fs::path& path) {
    const std::string bytes = read_file(path);
    switch (format_of(path, bytes)) {
        case Format::exr: return load_exr_color(path);
        case Format::pfm: return load_pfm_color(path);
        case Format::radiance: return decode_radiance(path, bytes);
        default: throw Error("{}: expected a picture of floats (OpenEXR, Radiance or PFM), found 8 or 16 bits", path.string());
    }
}

ImageMask load_alpha(const fs::path& path) {
    return format_of(path, read_file(path)) == Format::png ? load_png_alpha(path) : ImageMask{};
}

ImageMask load_mask(const fs::path& path) {
    if (format_of(path, read_file(path)) != Format::jpeg) return load_mask_png(path);
    const ImageRgb8 picture = load_rgb8(path);
    ImageMask mask(picture.width, picture.height);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        const Rgb8 p = picture.pixels[i];
        mask.pixels[i] = static_cast<std::uint8_t>((54 * p.r + 183 * p.g + 19 * p.b) / 256);
    }
    return mask;
}

ImageF load_float(const fs::path& path, float png_unit) {
    switch (format_of(path, read_file(path))) {
        case Format::png: return load_png_float(path, png_unit);
        case Format::exr: return load_exr(path);
        case Format::pfm: return load_pfm(path);
        default: throw Error("{}: expected a float map (EXR, PFM or 16-bit PNG), found a JPEG or Radiance picture", path.string());
    }
}

}  // namespace fastscene
