#include <webp/decode.h>

#include <string>
#include <vector>

#include "fastscene/io/formats.h"
#include "fastscene/io/webp_lossless.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

const char* what_went_wrong(VP8StatusCode code) {
    switch (code) {
        case VP8_STATUS_OUT_OF_MEMORY: return "more pixels than there is memory for";
        case VP8_STATUS_NOT_ENOUGH_DATA: return "the file ends too early";
        case VP8_STATUS_UNSUPPORTED_FEATURE: return "a kind that libwebp does not know";
        default: return "damaged data";
    }
}

const std::uint8_t* data_of(std::string_view bytes) { return reinterpret_cast<const std::uint8_t*>(bytes.data()); }

WebPBitstreamFeatures features_of(std::string_view bytes, const std::string& where) {
    WebPBitstreamFeatures features{};
    const VP8StatusCode code = WebPGetFeatures(data_of(bytes), bytes.size(), &features);
    if (code != VP8_STATUS_OK) throw Error("{}: expected a WebP header, found: {}", where, what_went_wrong(code));
    return features;
}

// `channels` bytes per pixel; transparency is not blended.
std::vector<std::uint8_t> pixels_of(std::string_view bytes, const std::string& where, std::size_t channels,
                                    WebPBitstreamFeatures& features) {
    features = features_of(bytes, where);
    if (features.has_animation) throw Error("{}: expected a picture, found an animated WebP", where);
    if (!plausible_size(features.width, features.height))
        throw Error("{}: expected a whole WebP picture, found: {} x {} pixels", where, features.width, features.height);
    // Length according to the header: truncated files are refused before memory is allocated.
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
        length |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[4 + i])) << (8 * i);
    if (length + 8 > bytes.size())
        throw Error("{}: expected a whole WebP picture, found: the file ends too early", where);
    const std::size_t stride = channels * static_cast<std::size_t>(features.width);
    std::vector<std::uint8_t> pixels(stride * static_cast<std::size_t>(features.height));
    const auto decode = channels == 4 ? WebPDecodeRGBAInto : WebPDecodeRGBInto;
    if (!decode(data_of(bytes), bytes.size(), pixels.data(), pixels.size(), static_cast<int>(stride)))
        throw Error("{}: expected a whole WebP picture, found: damaged data", where);
    return pixels;
}

}  // namespace

PictureInfo webp_info(const fs::path& path, std::string_view bytes) {
    const WebPBitstreamFeatures features = features_of(bytes, path.string());
    return {features.width, features.height};
}

ImageRgb8 decode_webp_rgb8(std::string_view bytes, const std::string& where) {
    WebPBitstreamFeatures features = features_of(bytes, where);
    const std::size_t channels = features.has_alpha ? 4 : 3;
    const std::vector<std::uint8_t> pixels = pixels_of(bytes, where, channels, features);
    ImageRgb8 image(features.width, features.height);
    for (std::size_t i = 0; i < image.size(); ++i) {
        const std::uint8_t* p = &pixels[channels * i];
        const int alpha = channels == 4 ? p[3] : 255;
        const auto over_black = [&](int v) { return static_cast<std::uint8_t>((v * alpha + 127) / 255); };
        image.pixels[i] = {over_black(p[0]), over_black(p[1]), over_black(p[2])};
    }
    return image;
}

RgbaBytes decode_webp_rgba(std::string_view bytes, const std::string& where) {
    WebPBitstreamFeatures features{};
    std::vector<std::uint8_t> pixels = pixels_of(bytes, where, 4, features);
    return {features.width, features.height, std::move(pixels)};
}

ImageMask webp_alpha(std::string_view bytes, const std::string& where) {
    WebPBitstreamFeatures features = features_of(bytes, where);
    if (!features.has_alpha) return {};
    const std::vector<std::uint8_t> pixels = pixels_of(bytes, where, 4, features);
    ImageMask image(features.width, features.height);
    for (std::size_t i = 0; i < image.size(); ++i) image.pixels[i] = pixels[4 * i + 3];
    return image;
}

ColorAndAlpha decode_webp_color_and_alpha(std::string_view bytes, const std::string& where) {
    WebPBitstreamFeatures features = features_of(bytes, where);
    if (!features.has_alpha) return {decode_webp_rgb8(bytes, where), {}};
    const std::vector<std::uint8_t> pixels = pixels_of(bytes, where, 4, features);
    return split_rgba(features.width, features.height, pixels.data());
}

}  // namespace fastscene
