// Pictures of phones and of stitchers: HEIC, AVIF and JPEG XL (where the build has their libraries), progressive JPEG,
// palettes, interlacing, 16 bits; and what XMP says about panoramas.
#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>
#include <jpeglib.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/io/formats.h"
#include "fastscene/io/gpano.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/test_scratch.h"

#ifdef FASTSCENE_HEIF
#include <libheif/heif.h>
#endif
#ifdef FASTSCENE_JPEG_XL
#include <jxl/encode.h>
#endif

namespace fastscene {
namespace {

constexpr int kWide = 64, kHigh = 48;
ImageRgb8 smooth_picture() {
    ImageRgb8 out(kWide, kHigh);
    for (int y = 0; y < kHigh; ++y)
        for (int x = 0; x < kWide; ++x)
            out.at(x, y) = {static_cast<std::uint8_t>(40 + 3 * x), static_cast<std::uint8_t>(30 + 4 * y), 120};
    return out;
}
void expect_same(const ImageRgb8& a, const ImageRgb8& b, double within, const char* what) {
    ASSERT_EQ(a.width, b.width) << what;
    ASSERT_EQ(a.height, b.height) << what;
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(a.pixels[i].r - b.pixels[i].r) + std::abs(a.pixels[i].g - b.pixels[i].g) +
               std::abs(a.pixels[i].b - b.pixels[i].b);
    EXPECT_LT(sum / static_cast<double>(3 * a.size()), within) << what;
}

// Damaged files are errors that name the file, or pictures; never a crash.
void damage(const std::string& whole, const std::string& name) {
    Random random(3, name);
    for (int n = 0; n < 60; ++n) {
        std::string bytes = n % 3 ? whole
                                  : whole.substr(
                                        0, static_cast<std::size_t>(random.index(static_cast<int>(whole.size()))));
        if (!bytes.empty() && n % 3)
            bytes[static_cast<std::size_t>(random.index(static_cast<int>(bytes.size())))] ^= static_cast<char>(
                1 + random.index(255));
        try {
            (void)picture_info(bytes, name);
            (void)decode_rgb8(bytes, name);
            (void)decode_alpha(bytes, name);
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(name), std::string::npos) << e.what();
        }
    }
}

#ifdef FASTSCENE_HEIF
// Empty: this machine's libheif has no such encoder.
std::string heif_of(const ImageRgb8& picture, heif_compression_format format) {
    const std::unique_ptr<heif_context, void (*)(heif_context*)> context(heif_context_alloc(), heif_context_free);
    heif_encoder* encoder = nullptr;
    if (heif_context_get_encoder_for_format(context.get(), format, &encoder).code != heif_error_Ok) return "";
    heif_encoder_set_lossy_quality(encoder, 90);
    heif_image* image = nullptr;
    heif_image_create(picture.width, picture.height, heif_colorspace_RGB, heif_chroma_interleaved_RGB, &image);
    heif_image_add_plane(image, heif_channel_interleaved, picture.width, picture.height, 24);
    int stride = 0;
    std::uint8_t* rows = heif_image_get_plane(image, heif_channel_interleaved, &stride);
    for (int y = 0; y < picture.height; ++y) std::copy_n(&picture.at(0, y).r, 3 * picture.width, rows + y * stride);
    heif_image_handle* handle = nullptr;
    const bool encoded = heif_context_encode_image(context.get(), image, encoder, nullptr, &handle).code ==
                         heif_error_Ok;
    std::string out;
    heif_writer writer{1, [](heif_context*, const void* data, std::size_t size, void* to) {
                           static_cast<std::string*>(to)->append(static_cast<const char*>(data), size);
                           return heif_error{heif_error_Ok, heif_suberror_Unspecified, ""};
                       }};
    if (encoded) heif_context_write(context.get(), &writer, &out);
    heif_image_handle_release(handle);
    heif_image_release(image);
    heif_encoder_release(encoder);
    return out;
}

TEST(PhonePictures, HeicAndAvif) {
    for (const auto& [format, name] : {std::pair{heif_compression_HEVC, "a.heic"}, {heif_compression_AV1, "a.avif"}}) {
        const std::string bytes = heif_of(smooth_picture(), format);
        if (bytes.empty()) continue;
        EXPECT_EQ(picture_info(bytes, name).width, kWide);
        expect_same(decode_rgb8(bytes, name), smooth_picture(), 4, name);
        EXPECT_TRUE(decode_alpha(bytes, name).empty());
        damage(bytes, name);
    }
}
#endif

#ifdef FASTSCENE_JPEG_XL
TEST(PhonePictures, JpegXl) {
    const ImageRgb8 picture = smooth_picture();
    const std::unique_ptr<JxlEncoder, void (*)(JxlEncoder*)> encoder(JxlEncoderCreate(nullptr), JxlEncoderDestroy);
    JxlBasicInfo info;
    JxlEncoderInitBasicInfo(&info);
    info.xsize = kWide, info.ysize = kHigh, info.bits_per_sample = 8, info.num_color_channels = 3;
    info.uses_original_profile = JXL_FALSE;
    ASSERT_EQ(JxlEncoderSetBasicInfo(encoder.get(), &info), JXL_ENC_SUCCESS);
    JxlColorEncoding srgb;
    JxlColorEncodingSetToSRGB(&srgb, JXL_FALSE);
    JxlEncoderSetColorEncoding(encoder.get(), &srgb);
    const JxlPixelFormat format{3, JXL_TYPE_UINT8, JXL_NATIVE_ENDIAN, 0};
    JxlEncoderAddImageFrame(JxlEncoderFrameSettingsCreate(encoder.get(), nullptr), &format, picture.pixels.data(),
                            3 * picture.size());
    JxlEncoderCloseInput(encoder.get());
    std::string bytes(1 << 16, '\0');
    auto* next = reinterpret_cast<std::uint8_t*>(bytes.data());
    std::size_t left = bytes.size();
    ASSERT_EQ(JxlEncoderProcessOutput(encoder.get(), &next, &left), JXL_ENC_SUCCESS);
    bytes.resize(bytes.size() - left);
    EXPECT_EQ(picture_info(bytes, "a.jxl").height, kHigh);
    expect_same(decode_rgb8(bytes, "a.jxl"), picture, 3, "a.jxl");
    EXPECT_TRUE(decode_alpha(bytes, "a.jxl").empty());
    damage(bytes, "a.jxl");
}
#endif

TEST(PhonePictures, ProgressiveAndGrayJpeg) {
    for (const bool gray : {false, true}) {
        jpeg_compress_struct info;
        jpeg_error_mgr errors;
        info.err = jpeg_std_error(&errors);
        jpeg_create_compress(&info);
        unsigned char* memory = nullptr;
        unsigned long size = 0;
        jpeg_mem_dest(&info, &memory, &size);
        info.image_width = kWide, info.image_height = kHigh;
        info.input_components = gray ? 1 : 3;
        info.in_color_space = gray ? JCS_GRAYSCALE : JCS_RGB;
        jpeg_set_defaults(&info);
        jpeg_set_quality(&info, 95, TRUE);
        jpeg_simple_progression(&info);
        jpeg_start_compress(&info, TRUE);
        ImageRgb8 picture = smooth_picture();
        for (int y = 0; y < kHigh; ++y) {
            std::vector<JSAMPLE> line;
            for (int x = 0; x < kWide; ++x) {
                if (gray) picture.at(x, y) = {picture.at(x, y).r, picture.at(x, y).r, picture.at(x, y).r};
                const Rgb8 p = picture.at(x, y);
                line.push_back(p.r);
                if (!gray) line.push_back(p.g), line.push_back(p.b);
            }
            JSAMPLE* row = line.data();
            jpeg_write_scanlines(&info, &row, 1);
        }
        jpeg_finish_compress(&info);
        const std::string bytes(reinterpret_cast<const char*>(memory), size);
        jpeg_destroy_compress(&info);
        std::free(memory);
        expect_same(decode_rgb8(bytes, "p.jpg"), picture, 3, gray ? "gray" : "progressive");
    }
}

TEST(PhonePictures, PalettesInterlacingAndSixteenBits) {
    struct Kind {
        int type, depth, interlace;
    };
    for (const Kind kind :
         {Kind{PNG_COLOR_TYPE_PALETTE, 8, PNG_INTERLACE_NONE}, Kind{PNG_COLOR_TYPE_PALETTE, 4, PNG_INTERLACE_ADAM7},
          Kind{PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_ADAM7}, Kind{PNG_COLOR_TYPE_RGB, 16, PNG_INTERLACE_ADAM7}}) {
        std::string bytes;
        png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
        png_infop info = png_create_info_struct(png);
        png_set_write_fn(
            png, &bytes,
            [](png_structp p, png_bytep data, png_size_t size) {
                static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(data), size);
            },
            [](png_structp) {});
        png_set_IHDR(png, info, kWide, kHigh, kind.depth, kind.type, kind.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        const png_color palette[] = {{200, 10, 20}, {30, 40, 210}, {50, 220, 60}};
        const bool indexed = kind.type == PNG_COLOR_TYPE_PALETTE;
        if (indexed) png_set_PLTE(png, info, palette, 3);
        png_write_info(png, info);
        ImageRgb8 picture = smooth_picture();
        std::vector<std::vector<png_byte>> rows(kHigh);
        std::vector<png_bytep> pointers;
        for (int y = 0; y < kHigh; ++y) {
            for (int x = 0; x < kWide; ++x) {
                Rgb8& p = picture.at(x, y);
                const auto index = static_cast<std::size_t>((x / 5 + y / 7) % 3);
                if (indexed) p = {palette[index].red, palette[index].green, palette[index].blue};
                auto& row = rows[static_cast<std::size_t>(y)];
                if (indexed && kind.depth == 8) row.push_back(static_cast<png_byte>(index));
                else if (indexed && x % 2 == 0) row.push_back(static_cast<png_byte>(index << 4));
                else if (indexed) row.back() = static_cast<png_byte>(row.back() | index);
                else
                    for (const std::uint8_t v : {p.r, p.g, p.b})
                        for (int b = 0; b < kind.depth; b += 8) row.push_back(v);
            }
            pointers.push_back(rows[static_cast<std::size_t>(y)].data());
        }
        png_write_image(png, pointers.data());
        png_write_end(png, info);
        png_destroy_write_struct(&png, &info);
        expect_same(decode_rgb8(bytes, "p.png"), picture, 0.01, "png");
    }
}

std::string xmp(const std::string& attributes, const std::string& elements, const std::string& prefix = "GPano") {
    return fmt::format(
        "junk<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF "
        "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"><rdf:Description "
        "xmlns:{}=\"http://ns.google.com/photos/1.0/panorama/\" {}>{}</rdf:Description></rdf:RDF></x:xmpmeta>junk",
        prefix, attributes, elements);
}

TEST(GPanoXmp, AttributesElementsAndOtherPrefixes) {
    std::string attributes, elements, others;
    for (const auto& [name, value] : {std::pair{"FullPanoWidthPixels", "256"},
                                      {"FullPanoHeightPixels", "128"},
                                      {"CroppedAreaLeftPixels", "64"},
                                      {"CroppedAreaTopPixels", "32.5"},
                                      {"CroppedAreaImageWidthPixels", "128"},
                                      {"CroppedAreaImageHeightPixels", "64"},
                                      {"PosePitchDegrees", "-4.5"},
                                      {"ProjectionType", "equirectangular"}}) {
        attributes += fmt::format("GPano:{}=\"{}\" ", name, value);
        elements += fmt::format("<GPano:{0}>{1}</GPano:{0}>", name, value);
        others += fmt::format("<p:{0}>{1}</p:{0}>", name, value);
    }
    for (const std::string& text : {xmp(attributes, ""), xmp("", elements), xmp("", others, "p")}) {
        const auto g = gpano_of(text);
        ASSERT_TRUE(g) << text;
        EXPECT_TRUE(g->has_crop());
        EXPECT_EQ(*g->full_width, 256);
        EXPECT_EQ(*g->top, 32.5);
        EXPECT_EQ(g->pitch_deg, -4.5);
        EXPECT_EQ(g->projection, "equirectangular");
    }
    EXPECT_FALSE(gpano_of(xmp("", "")));
    EXPECT_FALSE(gpano_of("no packet"));
    EXPECT_FALSE(gpano_of(xmp("", "<unclosed")));
    EXPECT_FALSE(gpano_of(xmp("GPano:FullPanoWidthPixels=\"wide\"", ""))->full_width);
}

}  // namespace
}  // namespace fastscene
