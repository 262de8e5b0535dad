#include <half.h>
#include <tiffio.h>

#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "fastscene/io/formats.h"

// Reads the first picture of a file. Color of any kind is converted to 8 bits by libtiff; numeric maps are read as
// stored.
namespace fastscene {
namespace {

namespace fs = std::filesystem;

struct Source {
    std::string_view bytes;
    std::size_t at = 0;
    std::string message;  // libtiff's first message
};

tmsize_t on_read(thandle_t handle, void* out, tmsize_t size) {
    auto* source = static_cast<Source*>(handle);
    if (source->at >= source->bytes.size() || size <= 0) return 0;
    const std::size_t n = std::min(static_cast<std::size_t>(size), source->bytes.size() - source->at);
    std::memcpy(out, source->bytes.data() + source->at, n);
    source->at += n;
    return static_cast<tmsize_t>(n);
}
tmsize_t on_write(thandle_t, void*, tmsize_t) { return 0; }
toff_t on_seek(thandle_t handle, toff_t offset, int whence) {
    auto* source = static_cast<Source*>(handle);
    const toff_t from = whence == SEEK_CUR ? source->at : whence == SEEK_END ? source->bytes.size() : 0;
    source->at = static_cast<std::size_t>(from + offset);
    return source->at;
}
int on_close(thandle_t) { return 0; }
toff_t on_size(thandle_t handle) { return static_cast<Source*>(handle)->bytes.size(); }
int on_error(TIFF*, void* user, const char*, const char* format, va_list arguments) {
    auto* source = static_cast<Source*>(user);
    char text[256];
    std::vsnprintf(text, sizeof text, format, arguments);
    if (source->message.empty()) source->message = text;
    return 1;
}
int on_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

class Tiff {
  public:
    Tiff(std::string_view bytes, std::string where)
        : source_{bytes, 0, {}}, where_(std::move(where)), file_(nullptr, TIFFClose) {
        const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                                   TIFFOpenOptionsFree);
        TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, &source_);
        TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, &source_);
        file_.reset(TIFFClientOpenExt(where_.c_str(), "rm", &source_, on_read, on_write, on_seek, on_close, on_size,
                                      nullptr, nullptr, options.get()));
        if (!file_) refuse("no directory of a picture");
        std::uint32_t width = 0, height = 0;
        TIFFGetField(file_.get(), TIFFTAG_IMAGEWIDTH, &width);
        TIFFGetField(file_.get(), TIFFTAG_IMAGELENGTH, &height);
        constexpr std::uint32_t kMost = std::numeric_limits<int>::max();
        info.width = static_cast<int>(std::min(width, kMost)), info.height = static_cast<int>(std::min(height, kMost));
        info.orientation = number(TIFFTAG_ORIENTATION) >= 1 && number(TIFFTAG_ORIENTATION) <= 8
                               ? number(TIFFTAG_ORIENTATION)
                               : 1;
        bits = number(TIFFTAG_BITSPERSAMPLE), samples = number(TIFFTAG_SAMPLESPERPIXEL);
        info.light = number(TIFFTAG_SAMPLEFORMAT) == SAMPLEFORMAT_IEEEFP;
    }
    Tiff(const Tiff&) = delete;

    // Throws with libtiff's message, or else with ours.
    [[noreturn]] void refuse(const std::string& otherwise) const {
        throw Error("{}: expected a whole TIFF picture, found: {}", where_,
                    source_.message.empty() ? otherwise : source_.message);
    }

    // Packed RGBA words, blended over black, rows as stored.
    std::vector<std::uint32_t> colors() {
        check_size();
        char why[1024] = "";
        if (!TIFFRGBAImageOK(file_.get(), why)) refuse(why);
        std::vector<std::uint32_t> out(static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.height));
        // Requested in the file's own orientation, so nothing is rotated.
        if (!TIFFReadRGBAImageOriented(file_.get(), static_cast<std::uint32_t>(info.width),
                                       static_cast<std::uint32_t>(info.height), out.data(), info.orientation, 1))
            refuse("damaged data");
        return out;
    }

    // Interleaved samples of all pixels, of one type.
    template <class T>
    std::vector<T> numbers() {
        check_size();
        const auto width = static_cast<std::size_t>(info.width), height = static_cast<std::size_t>(info.height),
                   n = static_cast<std::size_t>(samples);
        if (samples > 1 && number(TIFFTAG_PLANARCONFIG) != PLANARCONFIG_CONTIG) refuse("colors in planes of their own");
        std::vector<T> out(width * height * n);
        if (!TIFFIsTiled(file_.get())) {
            if (static_cast<std::size_t>(TIFFScanlineSize64(file_.get())) != width * n * sizeof(T))
                refuse("an unusual pixel layout");
            for (std::size_t y = 0; y < height; ++y)
                if (TIFFReadScanline(file_.get(), &out[y * width * n], static_cast<std::uint32_t>(y), 0) != 1)
                    refuse("damaged data");
            return out;
        }
        const auto tile_width = static_cast<std::size_t>(number32(TIFFTAG_TILEWIDTH)),
                   tile_height = static_cast<std::size_t>(number32(TIFFTAG_TILELENGTH));
        if (tile_width < 1 || tile_height < 1 || tile_width > kMaxPictureSide || tile_height > kMaxPictureSide ||
            static_cast<std::size_t>(TIFFTileSize64(file_.get())) != tile_width * tile_height * n * sizeof(T))
            refuse("an unusual pixel layout");
        std::vector<T> tile(tile_width * tile_height * n);
        for (std::size_t y = 0; y < height; y += tile_height)
            for (std::size_t x = 0; x < width; x += tile_width) {
                if (TIFFReadTile(file_.get(), tile.data(), static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                 0, 0) < 0)
                    refuse("damaged data");
                const std::size_t columns = std::min(tile_width, width - x);
                for (std::size_t j = 0; j < std::min(tile_height, height - y); ++j)
                    std::copy_n(&tile[j * tile_width * n], columns * n, &out[((y + j) * width + x) * n]);
            }
        return out;
    }

    // Converts floats of 16, 32 or 64 bits; programs store maps in any of them.
    std::vector<float> floats() {
        if (bits == 32) return numbers<float>();
        std::vector<float> out;
        if (bits == 64)
            for (const double v : numbers<double>()) out.push_back(static_cast<float>(v));
        else
            for (const std::uint16_t v : numbers<std::uint16_t>()) out.push_back(imath_half_to_float(v));
        return out;
    }
    bool holds_floats() const { return info.light && (bits == 16 || bits == 32 || bits == 64); }
    // Whether the last sample is unassociated alpha (not premultiplied).
    bool has_loose_alpha() const {
        std::uint16_t count = 0, *kinds = nullptr;
        return TIFFGetField(file_.get(), TIFFTAG_EXTRASAMPLES, &count, &kinds) == 1 && count == 1 &&
               kinds[0] == EXTRASAMPLE_UNASSALPHA;
    }

    PictureInfo info;
    int bits = 0, samples = 0;

  private:
    int number(std::uint32_t tag) const {
        std::uint16_t value = 0;
        TIFFGetFieldDefaulted(file_.get(), tag, &value);
        return value;
    }
    std::uint32_t number32(std::uint32_t tag) const {
        std::uint32_t value = 0;
        TIFFGetField(file_.get(), tag, &value);
        return value;
    }
    // Deflate and LZW compress by at most some thousand times, so a short file with a huge directory is refused before
    // memory is allocated.
    void check_size() const {
        if (!plausible_size(info.width, info.height) || samples < 1 || samples > 16 || bits < 1 || bits > 64)
            throw Error("{}: expected a whole TIFF picture, found: {} x {} pixels of {} times {} bits", where_,
                        info.width, info.height, samples, bits);
        constexpr std::size_t kMostShrunk = 3000, kSmall = std::size_t{64} << 20;
        const std::size_t whole = static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.height) *
                                  static_cast<std::size_t>(samples * bits) / 8;
        if (whole > kSmall && whole / kMostShrunk > source_.bytes.size())
            throw Error("{}: expected a whole TIFF picture, found: a size that the file cannot hold, {} x {}", where_,
                        info.width, info.height);
    }

    Source source_;
    std::string where_;
    std::unique_ptr<TIFF, void (*)(TIFF*)> file_;
};

}  // namespace

PictureInfo tiff_info(const fs::path& path, std::string_view bytes) { return Tiff(bytes, path.string()).info; }

ImageRgb8 decode_tiff_rgb8(std::string_view bytes, const std::string& where) {
    Tiff tiff(bytes, where);
    if (tiff.info.light) throw Error("{}: expected a color picture, found a TIFF of floats", where);
    const std::vector<std::uint32_t> colors = tiff.colors();
    ImageRgb8 image(tiff.info.width, tiff.info.height);
    for (std::size_t i = 0; i < image.size(); ++i)
        image.pixels[i] = {static_cast<std::uint8_t>(TIFFGetR(colors[i])),
                           static_cast<std::uint8_t>(TIFFGetG(colors[i])),
                           static_cast<std::uint8_t>(TIFFGetB(colors[i]))};
    return image;
}

ImageMask tiff_alpha(std::string_view bytes, const std::string& where) {
    Tiff tiff(bytes, where);
    if (tiff.info.light || tiff.samples == 1 || tiff.samples == 3) return {};
    const std::vector<std::uint32_t> colors = tiff.colors();
    ImageMask image(tiff.info.width, tiff.info.height);
    for (std::size_t i = 0; i < image.size(); ++i) image.pixels[i] = static_cast<std::uint8_t>(TIFFGetA(colors[i]));
    return image;
}

ImageF decode_tiff_float(std::string_view bytes, const std::string& where, float unit) {
    Tiff tiff(bytes, where);
    ImageF image;
    image.width = tiff.info.width, image.height = tiff.info.height;
    if (tiff.samples == 1 && tiff.holds_floats()) {
        image.pixels = tiff.floats();
    } else if (tiff.samples == 1 && !tiff.info.light && tiff.bits == 16) {
        for (const std::uint16_t count : tiff.numbers<std::uint16_t>())
            image.pixels.push_back(unit * static_cast<float>(count));
    } else {
        throw Error(
            "{}: expected a map of one number a pixel (TIFF: floats, or 16 bits in millimetres), found {} a pixel, "
            "each of {} bits",
            where, tiff.samples, tiff.bits);
    }
    return image;
}

ImageColor decode_tiff_light(std::string_view bytes, const std::string& where) {
    Tiff tiff(bytes, where);
    if (!tiff.holds_floats() || tiff.samples > 4)
        throw Error(
            "{}: expected a picture of floats (16, 32 or 64 bits), gray or three colors, with or without alpha, found "
            "{} a pixel, each of {} bits",
            where, tiff.samples, tiff.bits);
    const std::vector<float> numbers = tiff.floats();
    const bool colors = tiff.samples >= 3, see_through = tiff.samples % 2 == 0 && tiff.has_loose_alpha();
    ImageColor image(tiff.info.width, tiff.info.height);
    for (std::size_t i = 0; i < image.size(); ++i) {
        const float* p = &numbers[i * static_cast<std::size_t>(tiff.samples)];
        const float opaque = see_through ? p[tiff.samples - 1] : 1;  // blended over black
        image.pixels[i] = (colors ? Vec3f{p[0], p[1], p[2]} : Vec3f{p[0], p[0], p[0]}) * opaque;
    }
    return image;
}

}  // namespace fastscene
