// WebP and TIFF as other programs write them: encoded by libwebp and libtiff, decoded exactly, in any layout.
#include <gtest/gtest.h>
#include <tiffio.h>
#include <webp/encode.h>

#include <cstring>
#include <filesystem>
#include <functional>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

fs::path scratch(const std::string& name) {
    const fs::path dir = fs::path(::testing::TempDir()) / "fastscene_webp_tiff_test";
    fs::create_directories(dir);
    return dir / name;
}

std::vector<std::uint8_t> noise(std::size_t count) {
    Random random(1, "noise");
    std::vector<std::uint8_t> out(count);
    for (std::uint8_t& v : out) v = static_cast<std::uint8_t>(random.index(256));
    return out;
}

std::string webp(const std::vector<std::uint8_t>& rgba, int width, int height) {
    std::uint8_t* bytes = nullptr;
    WebPConfig config;
    WebPPicture picture;
    WebPMemoryWriter writer;
    EXPECT_TRUE(WebPConfigInit(&config) && WebPPictureInit(&picture));
    config.lossless = config.exact = 1;
    picture.use_argb = 1, picture.width = width, picture.height = height;
    EXPECT_TRUE(WebPPictureImportRGBA(&picture, rgba.data(), 4 * width));
    WebPMemoryWriterInit(&writer);
    picture.writer = WebPMemoryWrite, picture.custom_ptr = &writer;
    EXPECT_TRUE(WebPEncode(&config, &picture));
    bytes = writer.mem;
    const std::string out(reinterpret_cast<const char*>(bytes), writer.size);
    WebPMemoryWriterClear(&writer);
    WebPPictureFree(&picture);
    return out;
}

std::string number(std::uint32_t value, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> 8 * i);
    return out;
}
// The same picture in the extended layout: chunk flags, picture data, EXIF.
std::string extended(const std::string& simple, int width, int height, std::uint32_t flags, const std::string& exif) {
    const std::string chunks = "VP8X" + number(10, 4) + number(flags, 4) +
                               number(static_cast<std::uint32_t>(width - 1), 3) +
                               number(static_cast<std::uint32_t>(height - 1), 3) + simple.substr(12) + "EXIF" +
                               number(static_cast<std::uint32_t>(exif.size()), 4) + exif;
    return "RIFF" + number(static_cast<std::uint32_t>(chunks.size() + 4), 4) + "WEBP" + chunks;
}

TEST(WebP, IsReadExactlyAndAlphaLiesOverBlack) {
    std::vector<std::uint8_t> rgba = noise(4 * 17 * 9);
    write_file(scratch("a.webp"), webp(rgba, 17, 9));
    const ImageRgb8 color = load_rgb8(scratch("a.webp"));
    const ImageMask alpha = load_alpha(scratch("a.webp"));
    ASSERT_TRUE(color.width == 17 && color.height == 9 && alpha.same_size(color));
    for (std::size_t i = 0; i < color.size(); ++i) {
        EXPECT_EQ(alpha.pixels[i], rgba[4 * i + 3]);
        EXPECT_NEAR(color.pixels[i].g, rgba[4 * i + 1] * rgba[4 * i + 3] / 255.0, 0.51);
    }
    for (std::size_t i = 0; i < color.size(); ++i) rgba[4 * i + 3] = 255;
    write_file(scratch("b.png"), webp(rgba, 17, 9));  // the extension does not matter
    EXPECT_EQ(std::memcmp(&load_rgb8(scratch("b.png")).pixels[5], &rgba[20], 3), 0);
    EXPECT_TRUE(load_alpha(scratch("b.png")).empty());
    EXPECT_EQ(load_mask(scratch("b.png")).width, 17);
    EXPECT_EQ(picture_info(scratch("b.png")).width, 17);
    EXPECT_FALSE(picture_info(scratch("b.png")).light);
    EXPECT_THROW(load_float(scratch("b.png")), Error);
}

TEST(WebP, SaysHowItLiesAndDoesNotMove) {
    const std::string simple = webp(noise(4 * 6 * 4), 6, 4);
    const std::string block = std::string("II\x2a\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0", 26);
    for (const std::string& exif : {block, std::string("Exif\0\0", 6) + block}) {
        write_file(scratch("o.webp"), extended(simple, 6, 4, 0x18, exif));
        EXPECT_EQ(picture_info(scratch("o.webp")).orientation, 6);
        EXPECT_EQ(load_rgb8(scratch("o.webp")).width, 6);
    }
    write_file(scratch("o.webp"), extended(simple, 6, 4, 0x02, block));  // flagged as an animation
    EXPECT_THROW(load_rgb8(scratch("o.webp")), Error);
}

struct Layout {
    int samples = 3, bits = 8, compression = COMPRESSION_NONE, photometric = PHOTOMETRIC_RGB, orientation = 1;
    bool tiles = false, floats = false;
    const char* mode = "w";
};

// Values are bytes, 16-bit numbers or floats according to the layout, interleaved.
void save_tiff(const fs::path& path, const void* values, int width, int height, const Layout& layout) {
    TIFF* file = TIFFOpen(path.c_str(), layout.mode);
    ASSERT_NE(file, nullptr);
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, layout.samples);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, layout.bits);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, layout.photometric);
    TIFFSetField(file, TIFFTAG_COMPRESSION, layout.compression);
    TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(file, TIFFTAG_ORIENTATION, layout.orientation);
    if (layout.floats) TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    const std::uint16_t unassociated = EXTRASAMPLE_UNASSALPHA;
    if (layout.samples == 4) TIFFSetField(file, TIFFTAG_EXTRASAMPLES, 1, &unassociated);
    const std::size_t pixel = static_cast<std::size_t>(layout.samples * layout.bits / 8),
                      row = pixel * static_cast<std::size_t>(width);
    std::vector<std::uint8_t> bytes(static_cast<const std::uint8_t*>(values),
                                    static_cast<const std::uint8_t*>(values) + row * static_cast<std::size_t>(height));
    if (layout.tiles) {
        TIFFSetField(file, TIFFTAG_TILEWIDTH, 16);
        TIFFSetField(file, TIFFTAG_TILELENGTH, 16);
        for (int y = 0; y < height; y += 16)
            for (int x = 0; x < width; x += 16) {
                std::vector<std::uint8_t> tile(256 * pixel);
                for (int j = 0; j < std::min(16, height - y); ++j)
                    std::memcpy(&tile[static_cast<std::size_t>(16 * j) * pixel],
                                &bytes[static_cast<std::size_t>(y + j) * row + static_cast<std::size_t>(x) * pixel],
                                static_cast<std::size_t>(std::min(16, width - x)) * pixel);
                TIFFWriteTile(file, tile.data(), static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0);
            }
    } else {
        TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 5);
        for (int y = 0; y < height; ++y)
            TIFFWriteScanline(file, &bytes[static_cast<std::size_t>(y) * row], static_cast<std::uint32_t>(y), 0);
    }
    TIFFClose(file);
}

TEST(TiffColors, OfEveryLayoutAreTheSame) {
    const std::vector<std::uint8_t> rgb = noise(3 * 37 * 21);
    for (const Layout& layout : {Layout{}, Layout{.compression = COMPRESSION_LZW},
                                 Layout{.compression = COMPRESSION_ADOBE_DEFLATE, .tiles = true}, Layout{.mode = "wb"},
                                 Layout{.mode = "w8"}, Layout{.compression = COMPRESSION_PACKBITS, .orientation = 6}}) {
        save_tiff(scratch("a.tif"), rgb.data(), 37, 21, layout);
        const ImageRgb8 color = load_rgb8(scratch("a.tif"));
        ASSERT_TRUE(color.width == 37 && color.height == 21);
        EXPECT_EQ(std::memcmp(color.pixels.data(), rgb.data(), rgb.size()), 0) << layout.compression << layout.mode;
        EXPECT_EQ(picture_info(scratch("a.tif")).orientation, layout.orientation);
        EXPECT_FALSE(picture_info(scratch("a.tif")).light);
        EXPECT_TRUE(load_alpha(scratch("a.tif")).empty());
    }
    save_tiff(scratch("g.tif"), rgb.data(), 37, 21, {.samples = 1, .photometric = PHOTOMETRIC_MINISBLACK});
    EXPECT_EQ(load_rgb8(scratch("g.tif")).at(4, 1), (Rgb8{rgb[41], rgb[41], rgb[41]}));
    EXPECT_EQ(load_mask(scratch("g.tif")).at(4, 1), rgb[41]);
    std::vector<std::uint16_t> deep(3 * 37 * 21);
    for (std::size_t i = 0; i < deep.size(); ++i) deep[i] = static_cast<std::uint16_t>(257 * rgb[i]);
    save_tiff(scratch("d.tif"), deep.data(), 37, 21, {.bits = 16});
    EXPECT_EQ(std::memcmp(load_rgb8(scratch("d.tif")).pixels.data(), rgb.data(), rgb.size()), 0);
}

TEST(TiffColors, AlphaLiesOverBlack) {
    const std::vector<std::uint8_t> rgba = noise(4 * 8 * 8);
    save_tiff(scratch("a.tif"), rgba.data(), 8, 8, {.samples = 4});
    const ImageRgb8 color = load_rgb8(scratch("a.tif"));
    const ImageMask alpha = load_alpha(scratch("a.tif"));
    for (std::size_t i = 0; i < 64; ++i) {
        EXPECT_EQ(alpha.pixels.at(i), rgba[4 * i + 3]);
        EXPECT_NEAR(color.pixels[i].b, rgba[4 * i + 2] * rgba[4 * i + 3] / 255.0, 1.01);
    }
}

TEST(TiffNumbers, AreReadAsTheyStand) {
    const std::vector<float> range = [] {
        Random random(2, "range");
        std::vector<float> out(3 * 40 * 20);
        for (float& v : out) v = random.uniform(0, 30);
        return out;
    }();
    for (const bool tiles : {false, true}) {
        save_tiff(scratch("r.tif"), range.data(), 40, 20,
                  {.samples = 1, .bits = 32, .photometric = PHOTOMETRIC_MINISBLACK, .tiles = tiles, .floats = true});
        EXPECT_EQ(std::memcmp(load_float(scratch("r.tif")).pixels.data(), range.data(), 4 * 40 * 20), 0);
        EXPECT_EQ(load_light(scratch("r.tif")).at(3, 2).y, range[83]);
    }
    save_tiff(scratch("l.tif"), range.data(), 40, 20, {.bits = 32, .compression = COMPRESSION_LZW, .floats = true});
    EXPECT_EQ(std::memcmp(load_light(scratch("l.tif")).pixels.data(), range.data(), 12 * 40 * 20), 0);
    EXPECT_TRUE(picture_info(scratch("l.tif")).light);
    EXPECT_THROW(load_rgb8(scratch("l.tif")), Error);
    EXPECT_THROW(load_float(scratch("l.tif")), Error);
    const std::vector<std::uint16_t> millimetres(40 * 20, 2500);
    save_tiff(scratch("m.tif"), millimetres.data(), 40, 20,
              {.samples = 1, .bits = 16, .photometric = PHOTOMETRIC_MINISBLACK});
    EXPECT_FLOAT_EQ(load_float(scratch("m.tif")).at(39, 19), 2.5f);
}

// numpy's doubles, a renderer's half floats, and radiance with alpha, blended over black as for any picture.
TEST(TiffNumbers, OfAnyWidthAreFloats) {
    const std::vector<double> wide{0.1, 2.5, 1e-3, 30};
    save_tiff(scratch("w.tif"), wide.data(), 4, 1,
              {.samples = 1, .bits = 64, .photometric = PHOTOMETRIC_MINISBLACK, .floats = true});
    const std::vector<std::uint16_t> half{0x2e66, 0x4100, 0x1419, 0x4f80};  // 0.1, 2.5, 0.001, 30
    save_tiff(scratch("s.tif"), half.data(), 4, 1,
              {.samples = 1, .bits = 16, .photometric = PHOTOMETRIC_MINISBLACK, .floats = true});
    for (int x = 0; x < 4; ++x) {
        const auto expected = static_cast<float>(wide[static_cast<std::size_t>(x)]);
        EXPECT_EQ(load_float(scratch("w.tif")).at(x, 0), expected);
        EXPECT_NEAR(load_float(scratch("s.tif")).at(x, 0), expected, 1e-3f * expected);
        EXPECT_NEAR(load_light(scratch("s.tif")).at(x, 0).z, expected, 1e-3f * expected);
    }
    const std::vector<float> rgba{1, 2, 3, 0.5f, 4, 5, 6, 1};
    save_tiff(scratch("c.tif"), rgba.data(), 2, 1, {.samples = 4, .bits = 32, .floats = true});
    const ImageColor light = load_light(scratch("c.tif"));
    EXPECT_EQ(length(light.at(0, 0) - Vec3f{0.5f, 1, 1.5f}), 0);
    EXPECT_EQ(length(light.at(1, 0) - Vec3f{4, 5, 6}), 0);
}

// A directory of a few bytes that claims 2^28 pixels; a truncated WebP of maximum size.
TEST(HostileSizes, AreRefusedBeforeMemoryIsAskedFor) {
    const std::vector<std::uint8_t> gray(8 * 8, 7);
    save_tiff(scratch("h.tif"), gray.data(), 8, 8,
              {.samples = 1, .compression = COMPRESSION_ADOBE_DEFLATE, .photometric = PHOTOMETRIC_MINISBLACK});
    std::string bytes = read_file(scratch("h.tif"));
    std::size_t found = 0;
    for (const char tag : {'\0', '\1'}) {  // width and height: tag, type short, count 1, value
        const std::string entry = std::string{tag, '\1', '\3', '\0', '\1', '\0', '\0', '\0', '\x08', '\0'};
        const std::size_t at = bytes.find(entry);
        if (at == std::string::npos) continue;
        bytes[at + 2] = 4, bytes[at + 8] = 0, bytes[at + 9] = tag ? 0x20 : static_cast<char>(0x80),
                   ++found;  // 32768 x 8192
    }
    ASSERT_EQ(found, 2u);
    write_file(scratch("h.tif"), bytes);
    EXPECT_EQ(picture_info(scratch("h.tif")).width, 32768);
    try {
        (void)load_rgb8(scratch("h.tif"));
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("a size that the file cannot hold"), std::string::npos) << e.what();
    }
    std::string large = webp(noise(4 * 8 * 8), 8, 8);
    large[21] = large[22] = large[23] = '\xff';  // VP8L: 14 bits of width, 14 of height
    large.resize(large.size() - 9);
    write_file(scratch("h.webp"), large);
    EXPECT_THROW(load_rgb8(scratch("h.webp")), Error);
}

TEST(DamagedPictures, OfWebPAndTiffAreErrors) {
    write_file(scratch("w"), webp(noise(4 * 16 * 8), 16, 8));
    const std::vector<std::uint8_t> rgb = noise(3 * 40 * 20);
    save_tiff(scratch("t"), rgb.data(), 40, 20, {.compression = COMPRESSION_LZW});
    save_tiff(scratch("u"), rgb.data(), 40, 20, {.tiles = true});
    const std::vector<float> range(40 * 20, 2.f);
    save_tiff(scratch("f"), range.data(), 40, 20,
              {.samples = 1, .bits = 32, .photometric = PHOTOMETRIC_MINISBLACK, .floats = true});
    const fs::path broken = scratch("broken");
    Random random(4, "damage");
    for (const char* name : {"w", "t", "u", "f"}) {
        const std::string whole = read_file(scratch(name));
        const auto load = [&] {
            if (name[0] == 'f') (void)load_float(broken);
            else (void)load_rgb8(broken), (void)load_alpha(broken);
        };
        for (std::size_t keep = 0; keep < whole.size(); keep += 1 + whole.size() / 60) {
            write_file(broken, whole.substr(0, keep));
            EXPECT_THROW(load(), Error) << name << " cut to " << keep;
        }
        for (int i = 0; i < 400; ++i) {
            std::string bytes = whole;
            const std::size_t near_the_ends = static_cast<std::size_t>(random.index(160)) % bytes.size();
            const std::size_t at = i % 3 == 0   ? static_cast<std::size_t>(random.index(static_cast<int>(bytes.size())))
                                   : i % 3 == 1 ? near_the_ends
                                                : bytes.size() - 1 - near_the_ends;
            bytes[at] = static_cast<char>(random.index(256));
            write_file(broken, bytes);
            try {
                load();
            } catch (const Error& e) {
                EXPECT_NE(std::string(e.what()).find(broken.string()), std::string::npos) << e.what();
            }
        }
    }
}

}  // namespace
}  // namespace fastscene
