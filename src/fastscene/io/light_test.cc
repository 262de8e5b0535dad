// Pictures from cameras and light probes: EXIF orientation, Radiance, three-channel floats.
#include <ImfRgbaFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/image/orientation.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/test_scratch.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// A TIFF block with one entry, the orientation.
std::string exif_block(int orientation, bool little) {
    const auto n = [&](unsigned value, int bytes) {
        std::string out;
        for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> 8 * (little ? i : bytes - 1 - i));
        return out;
    };
    return (little ? std::string("II") : std::string("MM")) + n(42, 2) + n(8, 4) + n(1, 2) + n(0x0112, 2) + n(3, 2) +
           n(1, 4) + n(static_cast<unsigned>(orientation), 2) + n(0, 2) + n(0, 4);
}
std::string jpeg_with_exif(const std::string& jpeg, const std::string& block) {
    const std::string data = std::string("Exif\0\0", 6) + block;
    const std::size_t length = data.size() + 2;
    return jpeg.substr(0, 2) + "\xff\xe1" + static_cast<char>(length >> 8) + static_cast<char>(length & 255) + data +
           jpeg.substr(2);
}

TEST(Orientation, EveryOneOfEightIsUndone) {
    // a b c      as displayed; each orientation is a way in which a camera may have stored it. d e f
    const auto picture = [](int w, int h, const std::string& text) {
        ImageMask out(w, h);
        for (std::size_t i = 0; i < out.size(); ++i) out.pixels[i] = static_cast<std::uint8_t>(text.at(i));
        return out;
    };
    const ImageMask shown = picture(3, 2, "abcdef");
    EXPECT_EQ(upright(picture(3, 2, "abcdef"), 1), shown);
    EXPECT_EQ(upright(picture(3, 2, "cbafed"), 2), shown);
    EXPECT_EQ(upright(picture(3, 2, "fedcba"), 3), shown);
    EXPECT_EQ(upright(picture(3, 2, "defabc"), 4), shown);
    EXPECT_EQ(upright(picture(2, 3, "adbecf"), 5), shown);
    EXPECT_EQ(upright(picture(2, 3, "cfbead"), 6),
              shown);  // rotated clockwise for display: the stored left column is the top row
    EXPECT_EQ(upright(picture(2, 3, "fcebda"), 7), shown);
    EXPECT_EQ(upright(picture(2, 3, "daebfc"), 8), shown);
}

TEST(Exif, OrientationIsFoundOrOne) {
    const std::string jpeg = encode_jpeg(ImageRgb8(16, 8));
    const auto orientation = [](const std::string& bytes) {
        write_file(scratch("o.jpg"), bytes);
        return picture_info(scratch("o.jpg")).orientation;
    };
    EXPECT_EQ(orientation(jpeg), 1);
    for (int value = 1; value <= 8; ++value)
        for (const bool little : {false, true})
            EXPECT_EQ(orientation(jpeg_with_exif(jpeg, exif_block(value, little))), value);
    EXPECT_EQ(orientation(jpeg_with_exif(jpeg, exif_block(9, true))), 1);
    // Every byte damaged in turn: the picture must stay readable.
    const std::string whole = jpeg_with_exif(jpeg, exif_block(6, true));
    for (std::size_t i = 6; i < 6 + 32; ++i) {
        std::string broken = whole;
        broken[i] = static_cast<char>(~broken[i]);
        const int found = orientation(broken);
        EXPECT_TRUE(found >= 1 && found <= 8);
    }
}

TEST(Exif, PngSaysItInAChunk) {
    save_png(scratch("o.png"), ImageRgb8(16, 8));
    const std::string png = read_file(scratch("o.png")), block = exif_block(8, false);
    std::string chunk = std::string("\0\0\0", 3) + static_cast<char>(block.size()) + "eXIf" + block +
                        "\x01\x02\x03\x04";  // the checksum is not verified
    write_file(scratch("o.png"), png.substr(0, 33) + chunk + png.substr(33));
    EXPECT_EQ(picture_info(scratch("o.png")).orientation, 8);
}

constexpr int kLightWidth = 40, kLightHeight = 6;

Vec3f light_at(int x, int y) {
    return y == 2 ? Vec3f{0.5f, 0.25f, 8.f} : Vec3f{std::ldexp(1.f, x % 9 - 4), 0.7f * static_cast<float>(y), 3.f};
}

std::array<std::uint8_t, 4> rgbe(Vec3f c) {
    int exponent = 0;
    std::frexp(std::max({c.x, c.y, c.z}), &exponent);
    const float scale = std::ldexp(256.f, -exponent);
    return {static_cast<std::uint8_t>(c.x * scale), static_cast<std::uint8_t>(c.y * scale),
            static_cast<std::uint8_t>(c.z * scale), static_cast<std::uint8_t>(exponent + 128)};
}

enum class Packing { bare, pixels, channels };

std::string radiance_file(Packing packing) {
    std::string out = "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1\n\n-Y 6 +X 40\n";
    const auto put = [&](int v) { out += static_cast<char>(v); };
    for (int y = 0; y < kLightHeight; ++y) {
        if (packing == Packing::channels) {
            put(2), put(2), put(0), put(kLightWidth);
            for (std::size_t c = 0; c < 4; ++c) {
                if (y == 2) put(128 + kLightWidth), put(rgbe(light_at(0, y))[c]);
                else {
                    put(kLightWidth);
                    for (int x = 0; x < kLightWidth; ++x) put(rgbe(light_at(x, y))[c]);
                }
            }
        } else if (packing == Packing::pixels && y == 2) {
            for (const std::uint8_t v : rgbe(light_at(0, y))) put(v);
            put(1), put(1), put(1), put(kLightWidth - 1);
        } else {
            for (int x = 0; x < kLightWidth; ++x)
                for (const std::uint8_t v : rgbe(light_at(x, y))) put(v);
        }
    }
    return out;
}

TEST(Radiance, AllThreePackingsSayTheSame) {
    for (const Packing packing : {Packing::bare, Packing::pixels, Packing::channels}) {
        write_file(scratch("a.hdr"), radiance_file(packing));
        const PictureInfo info = picture_info(scratch("a.hdr"));
        EXPECT_TRUE(info.light && info.width == kLightWidth && info.height == kLightHeight);
        const ImageColor image = load_light(scratch("a.hdr"));
        for (int y = 0; y < kLightHeight; ++y)
            for (int x = 0; x < kLightWidth; ++x) {
                const Vec3f expected = light_at(x, y);
                const float step = std::max({expected.x, expected.y, expected.z}) / 128.f;
                for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(image.at(x, y)[c], expected[c], step) << x << "," << y;
            }
    }
}

TEST(Radiance, DamagedFilesAreErrors) {
    Random random(7, "radiance");
    for (const Packing packing : {Packing::bare, Packing::pixels, Packing::channels}) {
        const std::string whole = radiance_file(packing);
        for (std::size_t keep = 2; keep < whole.size(); keep += 7) {
            write_file(scratch("cut.hdr"), whole.substr(0, keep));
            EXPECT_THROW(load_light(scratch("cut.hdr")), Error) << keep;
        }
        for (int i = 0; i < 200; ++i) {
            std::string bytes = whole;
            bytes[static_cast<std::size_t>(random.index(static_cast<int>(bytes.size())))] ^= static_cast<char>(
                1 + random.index(255));
            write_file(scratch("bad.hdr"), bytes);
            try {
                load_light(scratch("bad.hdr"));
            } catch (const Error&) {
            }
        }
    }
    write_file(scratch("big.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 30000 +X 30000\n");
    EXPECT_THROW(load_light(scratch("big.hdr")), Error);
    write_file(scratch("turned.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n+X 30 -Y 60\n");
    EXPECT_THROW(picture_info(scratch("turned.hdr")), Error);
}

TEST(Light, OpenExrInColorAndGray) {
    {
        Imf::RgbaOutputFile file(scratch("c.exr").c_str(), 4, 2, Imf::WRITE_RGBA);
        std::vector<Imf::Rgba> pixels(8, Imf::Rgba(0.25f, 2.f, 16.f, 1.f));
        pixels[5] = Imf::Rgba(1.f, 0.f, 0.5f, 1.f);
        file.setFrameBuffer(pixels.data(), 1, 4);
        file.writePixels(2);
    }
    const ImageColor color = load_light(scratch("c.exr"));
    EXPECT_EQ(color.at(3, 0), (Vec3f{0.25f, 2.f, 16.f}));
    EXPECT_EQ(color.at(1, 1), (Vec3f{1.f, 0.f, 0.5f}));
    save_exr(scratch("g.exr"), ImageF(4, 2, 3.f));
    EXPECT_EQ(load_light(scratch("g.exr")).at(2, 1), (Vec3f{3.f, 3.f, 3.f}));
}

TEST(Light, FloatMapsInColorFromTheLowestRow) {
    std::string bytes = "PF\n2 2\n-1.0\n";
    for (int i = 0; i < 12; ++i) {
        const float v = static_cast<float>(i);
        bytes.append(reinterpret_cast<const char*>(&v), 4);
    }
    write_file(scratch("c.pfm"), bytes);
    EXPECT_EQ(load_light(scratch("c.pfm")).at(0, 1), (Vec3f{0, 1, 2}));
    EXPECT_EQ(load_light(scratch("c.pfm")).at(1, 0), (Vec3f{9, 10, 11}));
    EXPECT_THROW(load_float(scratch("c.pfm")), Error);
    write_file(scratch("c.pfm"), bytes.substr(0, bytes.size() - 1));
    EXPECT_THROW(load_light(scratch("c.pfm")), Error);
    save_pfm(scratch("g.pfm"), ImageF(2, 2, 5.f));
    EXPECT_EQ(load_light(scratch("g.pfm")).at(1, 1), (Vec3f{5, 5, 5}));
    save_png(scratch("p.png"), ImageRgb8(2, 2));
    EXPECT_THROW(load_light(scratch("p.png")), Error);
}

}  // namespace
}  // namespace fastscene
