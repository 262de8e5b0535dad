// HEIC (phones) and AVIF by libheif, if the build found it.
#include <memory>

#include "fastscene/io/formats.h"

#ifdef FASTSCENE_HEIF
#include <libheif/heif.h>
#endif

namespace fastscene {

bool is_heif(std::string_view bytes) {
    if (bytes.size() < 12 || bytes.substr(4, 4) != "ftyp") return false;
    for (const std::string_view brand : {"avif", "avis", "heic", "heix", "heim", "heis", "hevc", "mif1", "msf1"})
        if (bytes.substr(8, 4) == brand) return true;
    return false;
}

#ifdef FASTSCENE_HEIF

namespace {

void check_heif(const heif_error& error, const std::string& where) {
    if (error.code != heif_error_Ok)
        throw Error("{}: expected a whole HEIC or AVIF picture, found: {}", where, error.message);
}

// The file's main picture. Its size is upright: libheif applies the rotation that the file asks for.
class MainPicture {
  public:
    MainPicture(std::string_view bytes, const std::string& where)
        : where_(where), context_(heif_context_alloc(), heif_context_free) {
        if (!context_) throw std::bad_alloc();
        check_heif(heif_context_read_from_memory_without_copy(context_.get(), bytes.data(), bytes.size(), nullptr),
                   where);
        heif_image_handle* handle = nullptr;
        check_heif(heif_context_get_primary_image_handle(context_.get(), &handle), where);
        handle_.reset(handle);
    }
    PictureInfo info() const {
        PictureInfo info;
        info.width = heif_image_handle_get_width(handle_.get());
        info.height = heif_image_handle_get_height(handle_.get());
        return info;
    }
    // Calls pixel(x, y, r, g, b, opacity) for each.
    template <class Pixel>
    void decode(const Pixel& pixel) const {
        const PictureInfo size = info();
        if (!plausible_size(size.width, size.height))
            throw Error("{}: expected a picture of at most {} pixels a side, found {} x {}", where_, kMaxPictureSide,
                        size.width, size.height);
        const std::unique_ptr<heif_decoding_options, void (*)(heif_decoding_options*)> options(
            heif_decoding_options_alloc(), heif_decoding_options_free);
        options->convert_hdr_to_8bit = 1;
        heif_image* decoded = nullptr;
        check_heif(heif_decode_image(handle_.get(), &decoded, heif_colorspace_RGB, heif_chroma_interleaved_RGBA,
                                     options.get()),
                   where_);
        const std::unique_ptr<heif_image, void (*)(const heif_image*)> image(decoded, heif_image_release);
        int stride = 0;
        const std::uint8_t* rows = heif_image_get_plane_readonly(decoded, heif_channel_interleaved, &stride);
        if (!rows || heif_image_get_width(decoded, heif_channel_interleaved) != size.width ||
            heif_image_get_height(decoded, heif_channel_interleaved) != size.height)
            throw Error("{}: expected {} x {} pixels, found another number", where_, size.width, size.height);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const std::uint8_t* p = rows + static_cast<std::ptrdiff_t>(y) * stride + 4 * x;
                pixel(x, y, p[0], p[1], p[2], p[3]);
            }
    }

  private:
    std::string where_;
    std::unique_ptr<heif_context, void (*)(heif_context*)> context_;
    std::unique_ptr<heif_image_handle, void (*)(const heif_image_handle*)> handle_{nullptr, heif_image_handle_release};
};

}  // namespace

PictureInfo heif_info(std::string_view bytes, const std::string& where) { return MainPicture(bytes, where).info(); }

ImageRgb8 decode_heif_rgb8(std::string_view bytes, const std::string& where) {
    const MainPicture picture(bytes, where);
    const PictureInfo size = picture.info();
    ImageRgb8 out(plausible_size(size.width, size.height) ? size.width : 0, size.height);
    picture.decode([&](int x, int y, std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a) {
        const auto over_black = [&](std::uint8_t v) { return static_cast<std::uint8_t>((v * a + 127) / 255); };
        out.at(x, y) = {over_black(r), over_black(g), over_black(b)};
    });
    return out;
}

ImageMask heif_alpha(std::string_view bytes, const std::string& where) {
    const MainPicture picture(bytes, where);
    const PictureInfo size = picture.info();
    ImageMask out(plausible_size(size.width, size.height) ? size.width : 0, size.height);
    picture.decode([&](int x, int y, std::uint8_t, std::uint8_t, std::uint8_t, std::uint8_t a) { out.at(x, y) = a; });
    return out;
}

#else

namespace {
[[noreturn]] void refuse_heif(const std::string& where) {
    throw Error(
        "{}: expected PNG, JPEG, WebP or TIFF, found HEIC or AVIF, which this build cannot read (it was "
        "configured without libheif-dev): save it as JPEG",
        where);
}
}  // namespace

PictureInfo heif_info(std::string_view, const std::string& where) { refuse_heif(where); }
ImageRgb8 decode_heif_rgb8(std::string_view, const std::string& where) { refuse_heif(where); }
ImageMask heif_alpha(std::string_view, const std::string& where) { refuse_heif(where); }

#endif

}  // namespace fastscene
