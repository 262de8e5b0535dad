#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "fastscene/base/file.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/panorama.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

fs::path temporary(const std::string& name) { return fs::path(::testing::TempDir()) / ("fastscene-panorama-" + name); }

fs::path write_picture(const std::string& name, int width, int height) {
    ImageRgb8 picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) picture.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 7};
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
void expect_in(const std::string& text, const std::string& part) { EXPECT_NE(text.find(part), std::string::npos) << text << " lacks " << part; }

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

// Only the header of a huge picture is looked at: here there is nothing behind it.
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
    const ImageF range = range_from_file(write_map("good.pfm", 128, 64, [](int x, int) { return 1.f + static_cast<float>(x); }), {128, 64});
    EXPECT_EQ(range.at(100, 3), 101.f);
}

TEST(RangeMap, WrongMapsAreRefused) {
    const auto try_map = [](const std::string& name, int w, int h, float bad) {
        return complaint([&] { range_from_file(write_map(name, w, h, [&](int x, int y) { return x == 5 && y == 6 ? bad : 2.f; }), {128, 64}); });
    };
    expect_in(try_map("size.pfm", 64, 32, 2.f), "expected a range map of the panorama's size, 128 x 64, found 64 x 32");
    expect_in(try_map("nan.pfm", 128, 64, std::nanf("")), "column 5, row 6");
    expect_in(try_map("negative.pfm", 128, 64, -1.f), "found -1");
    expect_in(complaint([] { range_from_file(write_map("zero.pfm", 128, 64, [](int, int) { return 0.f; }), {128, 64}); }), "no finite value above zero");
    expect_in(complaint([] { range_from_file(write_map("inf.pfm", 128, 64, [](int, int) { return std::numeric_limits<float>::infinity(); }), {128, 64}); }),
              "no finite value above zero");
}

TEST(RangeMap, UnmeasuredPixelsTakeTheirNearestNeighbourAcrossTheSeam) {
    const ImageF range = range_from_file(write_map("holes.pfm", 128, 64,
                                                   [](int x, int y) { return y == 9 ? 0.f : x < 2 || x == 50 ? 0.f : static_cast<float>(x); }),
                                         {128, 64});
    EXPECT_EQ(range.at(0, 0), 127.f);  // over the seam: nearer than column 2
    EXPECT_EQ(range.at(1, 0), 2.f);
    EXPECT_EQ(range.at(50, 0), 49.f);
    EXPECT_EQ(range.at(70, 0), 70.f);
    EXPECT_TRUE(std::isinf(range.at(3, 9)));  // a row without any is sky
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

}  // namespace
}  // namespace fastscene
