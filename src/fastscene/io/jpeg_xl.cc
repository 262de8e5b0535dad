// JPEG XL by libjxl, if the build found it.
#include <memory>
#include <vector>

#include "fastscene/io/formats.h"

#ifdef FASTSCENE_JPEG_XL
#include <jxl/decode.h>
#endif

namespace fastscene {

bool is_jpeg_xl(std::string_view bytes) {
    return bytes.starts_with("\xff\x0a") || bytes.starts_with(std::string_view("\0\0\0\x0cJXL \r\n\x87\n", 12));
}

#ifdef FASTSCENE_JPEG_XL

namespace {

struct DecodedXl {
    PictureInfo info;  // upright: libjxl applies the orientation
    bool has_alpha = false;
    std::vector<std::uint8_t> rgba;  // empty: only the header was wanted
};

[[noreturn]] void refuse_xl(const std::string& where, const char* found) {
    throw Error("{}: expected a whole JPEG XL picture, found {}", where, found);
}

DecodedXl decode_xl(std::string_view bytes, const std::string& where, bool header_only) {
    const std::unique_ptr<JxlDecoder, void (*)(JxlDecoder*)> decoder(JxlDecoderCreate(nullptr), JxlDecoderDestroy);
    if (!decoder) throw std::bad_alloc();
    JxlDecoderSubscribeEvents(decoder.get(), JXL_DEC_BASIC_INFO | (header_only ? 0 : JXL_DEC_FULL_IMAGE));
    JxlDecoderSetInput(decoder.get(), reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    JxlDecoderCloseInput(decoder.get());
    constexpr JxlPixelFormat kRgba{4, JXL_TYPE_UINT8, JXL_NATIVE_ENDIAN, 0};
    DecodedXl out;
    for (;;) switch (JxlDecoderProcessInput(decoder.get())) {
            case JXL_DEC_BASIC_INFO: {
                JxlBasicInfo info;
                if (JxlDecoderGetBasicInfo(decoder.get(), &info) != JXL_DEC_SUCCESS)
                    refuse_xl(where, "a damaged header");
                out.info.width = static_cast<int>(std::min<std::uint32_t>(info.xsize, 0x7fffffff));
                out.info.height = static_cast<int>(std::min<std::uint32_t>(info.ysize, 0x7fffffff));
                out.has_alpha = info.alpha_bits > 0;
                if (header_only) return out;
                break;
            }
            case JXL_DEC_NEED_IMAGE_OUT_BUFFER: {
                std::size_t size = 0;
                if (!plausible_size(out.info.width, out.info.height)) refuse_xl(where, "too many pixels");
                if (JxlDecoderImageOutBufferSize(decoder.get(), &kRgba, &size) != JXL_DEC_SUCCESS)
                    refuse_xl(where, "pixels of an unusual kind");
                out.rgba.resize(size);
                JxlDecoderSetImageOutBuffer(decoder.get(), &kRgba, out.rgba.data(), size);
                break;
            }
            case JXL_DEC_FULL_IMAGE: return out;  // of a film, the first picture
            case JXL_DEC_NEED_MORE_INPUT: refuse_xl(where, "its end");
            default: refuse_xl(where, "damaged data");
        }
}

}  // namespace

PictureInfo jpeg_xl_info(std::string_view bytes, const std::string& where) {
    return decode_xl(bytes, where, true).info;
}

ImageRgb8 decode_jpeg_xl_rgb8(std::string_view bytes, const std::string& where) {
    const DecodedXl d = decode_xl(bytes, where, false);
    ImageRgb8 out(d.info.width, d.info.height);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::uint8_t* p = d.rgba.data() + 4 * i;
        const auto over_black = [&](std::uint8_t v) { return static_cast<std::uint8_t>((v * p[3] + 127) / 255); };
        out.pixels[i] = {over_black(p[0]), over_black(p[1]), over_black(p[2])};
    }
    return out;
}

ImageMask jpeg_xl_alpha(std::string_view bytes, const std::string& where) {
    if (!decode_xl(bytes, where, true).has_alpha) return {};
    const DecodedXl d = decode_xl(bytes, where, false);
    ImageMask out(d.info.width, d.info.height);
    for (std::size_t i = 0; i < out.size(); ++i) out.pixels[i] = d.rgba[4 * i + 3];
    return out;
}

#else

namespace {
[[noreturn]] void refuse_jpeg_xl(const std::string& where) {
    throw Error(
        "{}: expected PNG, JPEG, WebP or TIFF, found JPEG XL, which this build cannot read (it was configured "
        "without libjxl-dev): save it as PNG or JPEG",
        where);
}
}  // namespace

PictureInfo jpeg_xl_info(std::string_view, const std::string& where) { refuse_jpeg_xl(where); }
ImageRgb8 decode_jpeg_xl_rgb8(std::string_view, const std::string& where) { refuse_jpeg_xl(where); }
ImageMask jpeg_xl_alpha(std::string_view, const std::string& where) { refuse_jpeg_xl(where); }

#endif

}  // namespace fastscene
