#include <png.h>

#include <csetjmp>
#include <cstring>
#include <string>
#include <vector>

#include "fastscene/base/file.h"
#include "fastscene/io/color_maps.h"
#include "fastscene/io/formats.h"

// libpng reports errors by longjmp. Therefore everything that owns memory is declared before setjmp, and nothing with a
// destructor is created after it.
namespace fastscene {
namespace {

namespace fs = std::filesystem;

struct Source {
    const std::string* bytes;
    std::size_t at = 0;
    std::string message;
    std::vector<png_bytep> rows;  // a member, since longjmp may discard changes of locals
};

void on_error(png_structp png, png_const_charp message) {
    static_cast<Source*>(png_get_error_ptr(png))->message = message;
    png_longjmp(png, 1);
}
void on_warning(png_structp, png_const_charp) {}
void on_read(png_structp png, png_bytep out, png_size_t size) {
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (source->bytes->size() - source->at < size) png_error(png, "the file ends too early");
    std::memcpy(out, source->bytes->data() + source->at, size);
    source->at += size;
}

// Separate from the function that calls setjmp, whose locals must not change.
[[gnu::noinline]] void make_rows(Source& source, std::vector<png_byte>& pixels, std::size_t stride,
                                 std::size_t height) {
    pixels.resize(stride * height);
    source.rows.resize(height);
    for (std::size_t y = 0; y < height; ++y) source.rows[y] = pixels.data() + y * stride;
}

enum class Wanted { rgb8, rgba8, rgb16, gray8, gray16 };

// Decodes rows of 1, 3 or 4 bytes, or of 1 or 3 numbers of 2 bytes (big endian), per pixel. Never inlined, so that
// setjmp does not affect a caller's variables.
[[gnu::noinline]] bool decode(const std::string& bytes, Wanted wanted, int& width, int& height,
                              std::vector<png_byte>& pixels, std::string& message) {
    Source source{&bytes, 0, {}, {}};
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, on_error, on_warning);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png))) {
        png_destroy_read_struct(&png, &info, nullptr);
        message = source.message;
        return false;
    }
    png_set_read_fn(png, &source, on_read);
    png_set_user_limits(png, kMaxPictureSide, kMaxPictureSide);
    // Samples are treated as sRGB whatever the file says; with a gamma chunk libpng would blend alpha in linear light,
    // without one not.
    static constexpr png_byte kColorChunks[] = "gAMA\0sRGB\0cHRM\0iCCP";
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kColorChunks, 4);
    png_read_info(png, info);
    const png_byte type = png_get_color_type(png, info);
    // Deflate compresses by at most about 1032:1, so a short file with a huge header is refused before memory is
    // allocated.
    if (!plausible_size(png_get_image_width(png, info), png_get_image_height(png, info)) ||
        png_get_rowbytes(png, info) * png_get_image_height(png, info) / 1100 > bytes.size())
        png_error(png, "a size that the file cannot hold");
    png_set_expand(png);
    if (wanted != Wanted::gray16 && wanted != Wanted::rgb16) png_set_scale_16(png);
    if (wanted == Wanted::rgba8) {
        png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
    } else if (type & PNG_COLOR_MASK_ALPHA || png_get_valid(png, info, PNG_INFO_tRNS)) {
        png_color_16 black{};
        png_set_background(png, &black, PNG_BACKGROUND_GAMMA_SCREEN, 0, 1.0);
    }
    const bool colors = wanted == Wanted::rgb8 || wanted == Wanted::rgba8 || wanted == Wanted::rgb16;
    if (colors && !(type & PNG_COLOR_MASK_COLOR)) png_set_gray_to_rgb(png);
    if (!colors && (type & PNG_COLOR_MASK_COLOR)) png_set_rgb_to_gray_fixed(png, 1, -1, -1);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    width = static_cast<int>(png_get_image_width(png, info));
    height = static_cast<int>(png_get_image_height(png, info));
    const std::size_t stride = png_get_rowbytes(png, info);
    const std::size_t expected = static_cast<std::size_t>(width) * (wanted == Wanted::rgb8    ? 3
                                                                    : wanted == Wanted::rgba8 ? 4
                                                                    : wanted == Wanted::rgb16 ? 6
                                                                    : wanted == Wanted::gray8 ? 1
                                                                                              : 2);
    if (stride != expected) png_error(png, "an unusual pixel layout");
    make_rows(source, pixels, stride, static_cast<std::size_t>(height));
    png_read_image(png, source.rows.data());
    png_read_end(png, nullptr);
    png_destroy_read_struct(&png, &info, nullptr);
    return true;
}

std::vector<png_byte> decoded(const std::string& bytes, const std::string& where, Wanted wanted, int& width,
                              int& height) {
    std::vector<png_byte> pixels;
    std::string message;
    if (!decode(bytes, wanted, width, height, pixels, message))
        throw Error("{}: expected a whole PNG picture, found: {}", where, message);
    return pixels;
}
std::vector<png_byte> decoded(const fs::path& path, Wanted wanted, int& width, int& height) {
    return decoded(read_file(path), path.string(), wanted, width, height);
}

bool encode(const png_byte* pixels, int width, int height, int type, int depth, std::string& out,
            std::string& message) {
    Source state{nullptr, 0, {}, {}};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &state, on_error, on_warning);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png))) {
        png_destroy_write_struct(&png, &info);
        message = state.message;
        return false;
    }
    png_set_write_fn(
        png, &out,
        [](png_structp p, png_bytep data, png_size_t size) {
            static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(data), size);
        },
        [](png_structp) {});
    // Level 4 with the filter choice left to libpng: a third of the default's time, 3 % larger files.
    png_set_compression_level(png, 4);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), depth, type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    const std::size_t stride = png_get_rowbytes(png, info);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) png_write_row(png, pixels + y * stride);
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return true;
}

void save(const fs::path& path, const void* pixels, int width, int height, int type, int depth) {
    std::string bytes, message;
    if (!encode(static_cast<const png_byte*>(pixels), width, height, type, depth, bytes, message))
        throw Error("{}: cannot be written as PNG: {}", path.string(), message);
    write_file(path, bytes);
}

}  // namespace

PictureInfo png_info(const fs::path& path, std::string_view bytes) {
    // Signature (8), then the chunk IHDR: length, name, width, height.
    if (bytes.size() < 24 || bytes.substr(12, 4) != "IHDR")
        throw Error("{}: expected a PNG header, found {} bytes", path.string(), bytes.size());
    const auto number = [&](std::size_t at) {
        std::uint32_t v = 0;
        for (std::size_t i = 0; i < 4; ++i) v = v << 8 | static_cast<unsigned char>(bytes[at + i]);
        return static_cast<int>(std::min<std::uint32_t>(v, 0x7fffffff));
    };
    return {number(16), number(20)};
}

ImageRgb8 decode_png_rgb8(std::string_view bytes, const std::string& where) {
    int width = 0, height = 0;
    const std::vector<png_byte> pixels = decoded(std::string(bytes), where, Wanted::rgb8, width, height);
    ImageRgb8 image(width, height);
    std::memcpy(image.pixels.data(), pixels.data(), pixels.size());
    return image;
}

ImageMask load_mask_png(const fs::path& path) {
    ImageMask image;
    image.pixels = decoded(path, Wanted::gray8, image.width, image.height);
    return image;
}

namespace {

bool has_png_alpha(std::string_view bytes) {
    constexpr std::size_t kTypeAt = 25;  // in the chunk IHDR
    return bytes.size() > kTypeAt && (static_cast<unsigned char>(bytes[kTypeAt]) & PNG_COLOR_MASK_ALPHA ||
                                      bytes.find("tRNS") != std::string_view::npos);
}

}  // namespace

ColorAndAlpha decode_png_color_and_alpha(std::string_view bytes, const std::string& where) {
    if (!has_png_alpha(bytes)) return {decode_png_rgb8(bytes, where), {}};
    int width = 0, height = 0;
    const std::vector<png_byte> pixels = decoded(std::string(bytes), where, Wanted::rgba8, width, height);
    return split_rgba(width, height, pixels.data());
}

ImageMask png_alpha(std::string_view bytes, const std::string& where) {
    if (!has_png_alpha(bytes)) return {};
    int width = 0, height = 0;
    const std::vector<png_byte> pixels = decoded(std::string(bytes), where, Wanted::rgba8, width, height);
    ImageMask image(width, height);
    for (std::size_t i = 0; i < image.size(); ++i) image.pixels[i] = pixels[4 * i + 3];
    return image;
}

namespace {

// An 8-bit picture cannot be a range map: only 256 values, in an unknown unit.
void check_map(const fs::path& path, std::string_view bytes) {
    constexpr std::size_t kDepthAt = 24, kTypeAt = 25;  // in the chunk IHDR
    if (bytes.size() <= kTypeAt) return;                // the decoder will report it
    const int depth = static_cast<unsigned char>(bytes[kDepthAt]), type = static_cast<unsigned char>(bytes[kTypeAt]);
    if (depth == 16 && !(type & PNG_COLOR_MASK_COLOR)) return;
    throw Error("{}: expected a map of one number a pixel (PNG: 16-bit gray, in millimetres), found {} bits of {}",
                path.string(), depth, type & PNG_COLOR_MASK_COLOR ? "color" : "gray");
}

}  // namespace

ImageF load_png_float(const fs::path& path, float unit) {
    int width = 0, height = 0;
    const std::string bytes = read_file(path);
    check_map(path, bytes);
    const std::vector<png_byte> pixels = decoded(bytes, path.string(), Wanted::gray16, width, height);
    ImageF image(width, height);
    for (std::size_t i = 0; i < image.size(); ++i)
        image.pixels[i] = unit * static_cast<float>(pixels[2 * i] << 8 | pixels[2 * i + 1]);
    return image;
}

void save_png(const fs::path& path, const ImageRgb8& image) {
    static_assert(sizeof(Rgb8) == 3);
    save(path, image.pixels.data(), image.width, image.height, PNG_COLOR_TYPE_RGB, 8);
}
void save_png(const fs::path& path, const ImageMask& image) {
    save(path, image.pixels.data(), image.width, image.height, PNG_COLOR_TYPE_GRAY, 8);
}
void save_png16(const fs::path& path, const Image<std::uint16_t>& image) {
    std::vector<png_byte> bytes(image.size() * 2);
    for (std::size_t i = 0; i < image.size(); ++i) {
        bytes[2 * i] = static_cast<png_byte>(image.pixels[i] >> 8);
        bytes[2 * i + 1] = static_cast<png_byte>(image.pixels[i] & 255);
    }
    save(path, bytes.data(), image.width, image.height, PNG_COLOR_TYPE_GRAY, 16);
}
void save_png16(const fs::path& path, const Image3x16& image) {
    std::vector<png_byte> bytes;
    bytes.reserve(image.size() * 6);
    for (const auto& pixel : image.pixels)
        for (const std::uint16_t v : pixel) {
            bytes.push_back(static_cast<png_byte>(v >> 8));
            bytes.push_back(static_cast<png_byte>(v & 255));
        }
    save(path, bytes.data(), image.width, image.height, PNG_COLOR_TYPE_RGB, 16);
}
Image3x16 load_png16(const fs::path& path) {
    int width = 0, height = 0;
    const std::string file = read_file(path);
    constexpr std::size_t kDepthAt = 24, kTypeAt = 25;  // in the chunk IHDR
    if (file.size() > kTypeAt && (file[kDepthAt] != 16 || file[kTypeAt] != PNG_COLOR_TYPE_RGB))
        throw Error("{}: expected 16 bits of color, found {} bits of type {}", path.string(), int{file[kDepthAt]},
                    int{file[kTypeAt]});
    const std::vector<png_byte> bytes = decoded(file, path.string(), Wanted::rgb16, width, height);
    Image3x16 image(width, height);
    for (std::size_t i = 0; i < 3 * image.size(); ++i)
        image.pixels[i / 3][i % 3] = static_cast<std::uint16_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]);
    return image;
}

}  // namespace fastscene
