// Maps of three numbers a pixel, and tar archives.
#include "fastscene/io/color_maps.h"

#include <gtest/gtest.h>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/tar.h"
#include "fastscene/io/test_scratch.h"

namespace fastscene {
namespace {

TEST(ColorMaps, CountsOf16BitsComeBack) {
    Image3x16 map(5, 3);
    for (std::size_t i = 0; i < map.size(); ++i)
        map.pixels[i] = {static_cast<std::uint16_t>(4096 * i + 1), static_cast<std::uint16_t>(65535 - i),
                         static_cast<std::uint16_t>(i & 1)};
    const auto file = scratch("counts.png");
    save_png16(file, map);
    EXPECT_EQ(load_png16(file), map);
    save_png(file, ImageRgb8(4, 4));
    EXPECT_THROW(load_png16(file), Error) << "8 bits";
    write_file(file, read_file(file).substr(0, 40));
    EXPECT_THROW(load_png16(file), Error) << "cut off";
}

TEST(ColorMaps, LightKeepsElevenBits) {
    ImageColor light(7, 4);
    for (std::size_t i = 0; i < light.size(); ++i) {
        const auto v = static_cast<float>(i + 1);
        light.pixels[i] = {0.01f * v, 3.f * v, 70000.f * v};
    }
    const auto file = scratch("light.exr");
    save_exr_light(file, light);
    const ImageColor found = load_light(file);
    ASSERT_TRUE(found.same_size(light));
    for (std::size_t i = 0; i < light.size(); ++i) {
        EXPECT_NEAR(found.pixels[i].x, light.pixels[i].x, light.pixels[i].x / 1024);
        EXPECT_NEAR(found.pixels[i].y, light.pixels[i].y, light.pixels[i].y / 1024);
        EXPECT_EQ(found.pixels[i].z, 65504.f) << "the largest there is";
    }
}

TEST(Tar, IsWholeRecordsWithoutDates) {
    std::string bytes;
    TarWriter tar([&](std::string_view piece) { bytes += piece; });
    tar.add("a.txt", "hello");
    tar.add("folder/b.bin", std::string(512, 'x'));
    EXPECT_EQ(bytes.size(), tar_entry_size(5) + tar_entry_size(512));
    EXPECT_EQ(tar_entry_size(0), 512u);
    tar.finish();
    EXPECT_EQ(bytes.size(), 10240u);
    EXPECT_EQ(bytes.substr(0, 6), std::string("a.txt\0", 6));
    EXPECT_EQ(bytes.substr(257, 8), std::string("ustar\0"
                                                "00",
                                                8));
    EXPECT_EQ(bytes.substr(136, 11), "00000000000") << "no date";
    EXPECT_EQ(bytes.substr(512, 5), "hello");
    EXPECT_THROW(tar.add(std::string(101, 'n'), ""), Error);
    EXPECT_THROW(tar.add("", ""), Error);
}

}  // namespace
}  // namespace fastscene
