#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "fastscene/base/file.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/panorama/picture_file.h"

namespace fastscene {
namespace {

std::vector<std::string> remarks_on(const std::filesystem::path& file) {
    return picture_file_from(read_file(file), file).remarks;
}

namespace fs = std::filesystem;

fs::path temporary(const std::string& name) { return fs::path(::testing::TempDir()) / ("fastscene-panorama-" + name); }

fs::path write_picture(const std::string& name, int width, int height) {
    ImageRgb8 picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 7};
    save_png(temporary(name), picture);
    return temporary(name);
}
fs::path write_map(const std::string& name, int width, int height, const std::function<float(int, int)>& range) {
    ImageF map(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) map.at(x, y) = range(x, y);
    save_pfm(temporary(name), map);
    return temporary(name);
}
template <class F>
std::string complaint(F&& act) {
    try {
        act();
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}
void expect_in(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text << " lacks " << part;
}

TEST(ImagePanorama, ComesInAsItIs) {
    const Panorama panorama = panorama_from_image(write_picture("good.png", 128, 64));
    ASSERT_EQ(panorama.color.width, 128);
    EXPECT_EQ(srgb8_from_linear(panorama.color.at(100, 50)), (Rgb8{100, 50, 7}));
    EXPECT_TRUE(panorama.range.empty());
}

TEST(ImagePanorama, OtherShapesAreRefusedWithTheirSize) {
    expect_in(complaint([] { panorama_from_image(write_picture("square.png", 128, 128)); }), "found 128 x 128");
    expect_in(complaint([] { panorama_from_image(write_picture("one.png", 1, 1)); }), "found 1 x 1");
    expect_in(complaint([] { panorama_from_image(write_picture("small.png", 32, 16)); }), "found 32 x 16");
    expect_in(complaint([] { panorama_from_image(temporary("absent.png")); }), "absent.png");
}

// A huge picture is rejected by its header alone: there is nothing behind it here.
TEST(ImagePanorama, AHugePictureIsRefusedBeforeItIsDecoded) {
    std::string bytes = read_file(write_picture("huge.png", 128, 64));
    const auto put = [&](std::size_t at, std::uint32_t v) {
        for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(v >> (24 - 8 * i));
    };
    put(16, 20000);
    put(20, 10000);
    write_file(temporary("huge.png"), bytes.substr(0, 200));
    const std::string text = complaint([] { panorama_from_image(temporary("huge.png")); });
    expect_in(text, "huge.png");
}

TEST(ImagePanorama, ATruncatedPictureIsRefused) {
    const std::string bytes = read_file(write_picture("short.png", 256, 128));
    write_file(temporary("short.png"), bytes.substr(0, bytes.size() / 2));
    expect_in(complaint([] { panorama_from_image(temporary("short.png")); }), "short.png");
}

TEST(RangeMap, ComesInAsItIs) {
    const ImageF range = range_from_file(
        write_map("good.pfm", 128, 64, [](int x, int) { return 1.f + static_cast<float>(x); }), {128, 64});
    EXPECT_EQ(range.at(100, 3), 101.f);
}

TEST(RangeMap, WrongMapsAreRefused) {
    const auto try_map = [](const std::string& name, int w, int h, float bad) {
        return complaint([&] {
            range_from_file(write_map(name, w, h, [&](int x, int y) { return x == 5 && y == 6 ? bad : 2.f; }),
                            {128, 64});
        });
    };
    expect_in(try_map("size.pfm", 64, 32, 2.f), "expected a range map of the panorama's size, 128 x 64, found 64 x 32");
    expect_in(try_map("negative.pfm", 128, 64, -1.f), "column 5, row 6");
    expect_in(try_map("negative.pfm", 128, 64, -1.f), "found -1");
    expect_in(complaint([] {
                  range_from_file(write_map("zero.pfm", 128, 64, [](int, int) { return 0.f; }), {128, 64});
              }),
              "no finite value above zero");
    expect_in(complaint([] {
                  range_from_file(
                      write_map("inf.pfm", 128, 64, [](int, int) { return std::numeric_limits<float>::infinity(); }),
                      {128, 64});
              }),
              "no finite value above zero");
}

TEST(ReducedPanorama, KeepsTheMeanColorAndPicksRanges) {
    Panorama panorama;
    panorama.color = ImageColor(96, 48);
    panorama.range = ImageF(96, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 96; ++x) {
            panorama.color.at(x, y) = {static_cast<float>((x * 7 + y * 3) % 11), 1.f, 0.f};
            panorama.range.at(x, y) = x < 48 ? 1.f : 5.f;
        }
    for (const int width : {48, 64, 32}) {
        const Panorama small = reduced_panorama(panorama, width);
        ASSERT_EQ(small.color.width, width);
        ASSERT_EQ(small.color.height, width / 2);
        Vec3f before{}, after{};
        for (const Vec3f c : panorama.color.pixels) before += c;
        for (const Vec3f c : small.color.pixels) after += c;
        before = before / static_cast<float>(panorama.color.size());
        after = after / static_cast<float>(small.color.size());
        EXPECT_NEAR(before.x, after.x, 1e-3f) << width;
        EXPECT_NEAR(after.y, 1.f, 1e-4f) << width;
        for (const float r : small.range.pixels) EXPECT_TRUE(r == 1.f || r == 5.f);
    }
    EXPECT_EQ(reduced_panorama(panorama, 200).color, panorama.color);
}

// A camera held sideways stores 64 x 128 with an orientation tag.
TEST(ImagePanorama, IsTurnedUprightAsExifSays) {
    ImageRgb8 stored(64, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 64; ++x) stored.at(x, y) = y < 64 ? Rgb8{250, 250, 250} : Rgb8{20, 20, 20};
    const std::string jpeg = encode_jpeg(stored);
    // Orientation 6: the stored top is the right side.
    const std::string exif(
        "\xff\xe1\x00\x22"
        "Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0",
        36);
    write_file(temporary("side.jpg"), jpeg.substr(0, 2) + exif + jpeg.substr(2));
    EXPECT_EQ(panorama_size(temporary("side.jpg")).width, 128);
    const Panorama panorama = panorama_from_image(temporary("side.jpg"));
    ASSERT_EQ(panorama.color.width, 128);
    EXPECT_GT(panorama.color.at(100, 30).x, 0.9f);
    EXPECT_LT(panorama.color.at(20, 30).x, 0.05f);
    ASSERT_EQ(remarks_on(temporary("side.jpg")).size(), 1u);
    expect_in(remarks_on(temporary("side.jpg"))[0], "EXIF orientation 6");
    // Without applying the orientation it is not 2:1.
    write_file(temporary("lies.jpg"), jpeg);
    expect_in(complaint([] { panorama_from_image(temporary("lies.jpg")); }), "found 64 x 128");
}

TEST(ImagePanorama, LightIsExposedWhateverItsUnit) {
    for (const float unit : {0.002f, 1.f, 700.f}) {
        std::string bytes = "PF\n128 64\n-1.0\n";
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 128; ++x)
                for (const float c : {1.f, 0.9f, 0.8f}) {
                    // A window a hundred times as bright as the walls, and a NaN pixel.
                    const float v = unit * c *
                                    (x > 60 && x < 70 && y > 25 && y < 40 ? 100.f
                                     : x == 3 && y == 3                   ? std::nanf("")
                                                                          : 1.f);
                    bytes.append(reinterpret_cast<const char*>(&v), 4);
                }
        write_file(temporary("probe.pfm"), bytes);
        const ImageColor color = panorama_from_image(temporary("probe.pfm")).color;
        for (const Vec3f c : color.pixels) ASSERT_TRUE(c.x >= 0 && c.x <= 1 && c.y >= 0 && c.z <= 1);
        const Vec3f wall = color.at(100, 32);
        // Middle gray of photographs of rooms.
        EXPECT_NEAR(luminance(wall), 0.2f, 0.06f) << unit;
        EXPECT_GT(wall.x, wall.z);  // white balance is kept
        EXPECT_GT(luminance(color.at(65, 32)), 0.9f);
        expect_in(remarks_on(temporary("probe.pfm")).at(0), "exposed");
    }
    save_pfm(temporary("dark.pfm"), ImageF(128, 64, 0.f));
    expect_in(complaint([] { panorama_from_image(temporary("dark.pfm")); }), "found none");
}

TEST(ImagePanorama, GrayDeepAndSeeThroughPictures) {
    save_png16(temporary("deep.png"), Image<std::uint16_t>(128, 64, 0x8080));
    EXPECT_NEAR(srgb8_from_linear(panorama_from_image(temporary("deep.png")).color.at(5, 5)).g, 0x80, 1);
    save_png(temporary("gray.png"), ImageMask(128, 64, 90));
    EXPECT_EQ(srgb8_from_linear(panorama_from_image(temporary("gray.png")).color.at(5, 5)), (Rgb8{90, 90, 90}));
    EXPECT_TRUE(remarks_on(temporary("gray.png")).empty());
}

}  // namespace
}  // namespace fastscene
