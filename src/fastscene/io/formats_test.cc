// Pictures as other programs write them: gray, alpha, CMYK, half floats, false headers; and damaged splats and models.
#include <ImfArray.h>
#include <ImfRgbaFile.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>
#include <jpeglib.h>

#include <filesystem>
#include <functional>
#include <limits>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/test_scratch.h"
#include "fastscene/io/view_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

void write_png(const fs::path& path, png_uint_32 format, const void* pixels) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = 1;
    image.format = format;
    ASSERT_TRUE(png_image_write_to_file(&image, path.c_str(), 0, pixels, 0, nullptr));
}

std::string jpeg_of(J_COLOR_SPACE space, int channels, JSAMPLE value) {
    jpeg_compress_struct info;
    jpeg_error_mgr errors;
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &memory, &size);
    info.image_width = info.image_height = 8;
    info.input_components = channels;
    info.in_color_space = space;
    jpeg_set_defaults(&info);
    jpeg_start_compress(&info, TRUE);
    std::vector<JSAMPLE> line(8 * static_cast<std::size_t>(channels), value);
    JSAMPLE* row = line.data();
    while (info.next_scanline < 8) jpeg_write_scanlines(&info, &row, 1);
    jpeg_finish_compress(&info);
    std::string out(reinterpret_cast<const char*>(memory), size);
    jpeg_destroy_compress(&info);
    std::free(memory);
    return out;
}

// Flips random bytes: must give an Error or a result.
void damage(const fs::path& file, int times, const std::function<void()>& load) {
    const std::string whole = read_file(file);
    Random random(5, "damage");
    int refused = 0;
    for (int i = 0; i < times; ++i) {
        std::string bytes = whole;
        bytes[static_cast<std::size_t>(random.index(static_cast<int>(bytes.size())))] ^= static_cast<char>(
            1 + random.index(255));
        write_file(file, bytes);
        try {
            load();
        } catch (const Error& e) {
            ++refused;
            EXPECT_FALSE(std::string(e.what()).empty());
        }
    }
    write_file(file, whole);
    EXPECT_NO_THROW(load());
    EXPECT_GT(refused, 0) << file;
}

TEST(Png, AlphaLiesOverBlackAndGrayIsGray) {
    const png_byte half_white[] = {255, 255, 255, 128}, gray_alpha[] = {200, 0};
    write_png(scratch("a.png"), PNG_FORMAT_RGBA, half_white);
    EXPECT_NEAR(load_rgb8(scratch("a.png")).at(0, 0).g, 128, 1);
    write_png(scratch("ga.png"), PNG_FORMAT_GA, gray_alpha);
    EXPECT_EQ(load_rgb8(scratch("ga.png")).at(0, 0), (Rgb8{0, 0, 0}));
}

TEST(Png, EightBitsOrColorsAreNoRange) {
    const auto said_of = [](auto&& save) {
        save(scratch("m.png"));
        try {
            load_float(scratch("m.png"));
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    const std::string gray = said_of([](const fs::path& path) { save_png(path, ImageMask(4, 4, 9)); });
    EXPECT_NE(gray.find("m.png: expected a map"), std::string::npos) << gray;
    EXPECT_NE(gray.find("found 8 bits of gray"), std::string::npos) << gray;
    EXPECT_EQ(gray.find("whole"), std::string::npos) << "it is whole: " << gray;
    const std::string color = said_of([](const fs::path& path) { save_png(path, ImageRgb8(4, 4)); });
    EXPECT_NE(color.find("found 8 bits of color"), std::string::npos) << color;
}

TEST(Png, AShortFileThatClaimsAHugePictureIsRefused) {
    save_png(scratch("h.png"), ImageMask(1, 1, 9));
    std::string bytes = read_file(scratch("h.png"));
    // 16000 x 16000 in the header, with a correct checksum, so that only the size can be refused.
    for (const std::size_t at : {16u, 20u}) bytes.replace(at, 4, std::string("\0\0\x3e\x80", 4));
    std::uint32_t crc = 0xffffffff;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= static_cast<unsigned char>(bytes[i]);
        for (int k = 0; k < 8; ++k) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
    }
    crc = ~crc;
    for (std::size_t i = 0; i < 4; ++i) bytes[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
    write_file(scratch("h.png"), bytes);
    EXPECT_EQ(picture_info(scratch("h.png")).width, 16000);
    try {
        load_rgb8(scratch("h.png"));
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("cannot hold"), std::string::npos) << e.what();
    }
}

TEST(Jpeg, GrayAndInksBecomeColor) {
    write_file(scratch("g.jpg"), jpeg_of(JCS_GRAYSCALE, 1, 77));
    EXPECT_NEAR(load_rgb8(scratch("g.jpg")).at(3, 3).b, 77, 2);
    write_file(scratch("k.jpg"), jpeg_of(JCS_CMYK, 4, 255));  // Adobe's inverted CMYK: 255 is no ink
    EXPECT_NEAR(load_rgb8(scratch("k.jpg")).at(3, 3).r, 255, 2);
}

// 4 x 2 half floats: column + 0.5, with the given blue value at one pixel.
fs::path half_floats(Imf::RgbaChannels channels, float odd_blue) {
    Imf::Array2D<Imf::Rgba> pixels(2, 4);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) {
            const float v = static_cast<float>(x) + 0.5f;
            pixels[y][x] = Imf::Rgba(v, v, x == 1 && y == 1 ? odd_blue : v);
        }
    Imf::RgbaOutputFile file(scratch("half.exr").c_str(), 4, 2, channels);
    file.setFrameBuffer(&pixels[0][0], 1, 4);
    file.writePixels(2);
    return scratch("half.exr");
}

TEST(Exr, GrayInThreeChannelsIsAMap) {
    for (const auto channels : {Imf::WRITE_RGB, Imf::WRITE_RGBA}) {
        const ImageF map = load_float(half_floats(channels, 1.5f));
        ASSERT_EQ(map.width, 4);
        EXPECT_EQ(map.at(2, 1), 2.5f);
        EXPECT_EQ(map.at(1, 1), 1.5f);
    }
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(load_float(half_floats(Imf::WRITE_RGB, nan)), Error);
}

TEST(Exr, AnAttributeOfAWrongSizeIsRefusedBeforeItsMemoryIsTaken) {
    const std::string file = half_floats(Imf::WRITE_RGB, 1.5f);
    const std::string whole = read_file(file);
    struct Damage {
        std::string_view before, size, says;
    };
    using namespace std::string_view_literals;
    for (const Damage& d : {
             Damage{"compression\0compression\0"sv, "dene"sv, "an attribute of 1701733732 bytes"},
             Damage{"compression\0compression\0"sv, "\x02\0\0\0"sv, "type compression have 1 bytes, found one of 2"},
             Damage{"dataWindow\0box2i\0"sv, "\x08\0\0\0"sv, "type box2i have 16 bytes, found one of 8"},
             Damage{"channels\0chlist\0"sv, "\x13\0\0\0"sv, "a damaged list of channels"},
         }) {
        std::string bytes = whole;
        const std::size_t at = bytes.find(d.before);
        ASSERT_NE(at, std::string::npos);
        bytes.replace(at + d.before.size(), 4, d.size);
        write_file(file, bytes);
        try {
            load_float(file);
            ADD_FAILURE() << "expected an error: " << d.says;
        } catch (const Error& e) {
            EXPECT_NE(std::string_view(e.what()).find(d.says), std::string_view::npos) << e.what();
        }
    }
}

TEST(Exr, AColorPictureIsNoMap) {
    for (const auto channels : {Imf::WRITE_RGB, Imf::WRITE_RGBA, Imf::WRITE_YC}) try {
            load_float(half_floats(channels, 1.6f));
            ADD_FAILURE() << channels;
        } catch (const Error& e) {
            const std::string said = e.what();
            EXPECT_NE(said.find("half.exr: expected a map of one number a pixel"), std::string::npos) << said;
            EXPECT_NE(
                said.find(channels == Imf::WRITE_RGB    ? "found a color picture: channels B, G, R, with 1.5 1.5 1.5996"
                          : channels == Imf::WRITE_RGBA ? "channels A, B, G, R"
                                                        : "channels BY, RY, Y"),
                std::string::npos)
                << said;
        }
    EXPECT_NE(load_light(half_floats(Imf::WRITE_RGB, 1.6f)).at(1, 1).z, 1.5f) << "as a picture it is what it was";
}

TEST(SplatPly, FlippedBytesNeverCrash) {
    Splats splats;
    splats.sh_degree = 0;
    splats.resize(4);
    save_splat_ply(scratch("s.ply"), splats);
    damage(scratch("s.ply"), 1500, [] { (void)load_splat_ply(scratch("s.ply")); });
    // Zero-byte rows, in a number that exceeds memory.
    write_file(
        scratch("e.ply"),
        std::string_view("ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\nend_header\n"));
    EXPECT_THROW(load_splat_ply(scratch("e.ply")), Error);
}

TEST(Views, FlippedBytesNeverCrash) {
    ViewSet set;
    View view;
    view.name = "0.png";
    view.camera = Pinhole::with_fov(4, 4, 90);
    view.color = ImageRgb8(4, 4);
    set.views = {view};
    set.points = {{{1, 2, 3}, {0, 1, 0}, {1, 2, 3}, 0.1f}};
    const fs::path dir = scratch("views");
    fs::remove_all(dir);
    save_views(dir, set);
    for (const char* name : {"cameras.bin", "images.bin", "points3D.ply"})
        damage(dir / "sparse" / "0" / name, 250, [&] { (void)load_views(dir); });
}

}  // namespace
}  // namespace fastscene
