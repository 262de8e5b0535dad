#include <gtest/gtest.h>

#include <filesystem>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/gpano.h"
#include "fastscene/io/gpano_mark.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/spherical_mp4.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

ImageRgb8 picture() {
    ImageRgb8 image(64, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            image.at(x, y) = {static_cast<std::uint8_t>(4 * x), static_cast<std::uint8_t>(8 * y), 7};
    return image;
}

TEST(GPano, APictureIsMarkedOnceAndStaysTheSamePicture) {
    for (const char* ending : {".jpg", ".png"}) {
        SCOPED_TRACE(ending);
        const fs::path plain = fs::path(::testing::TempDir()) / (std::string("plain") + ending),
                       marked = fs::path(::testing::TempDir()) / (std::string("marked") + ending);
        std::string(ending) == ".png" ? save_png(plain, picture()) : save_jpeg(plain, picture());
        save_panorama(marked, picture());
        EXPECT_EQ(load_rgb8(plain), load_rgb8(marked));
        EXPECT_FALSE(gpano_of(read_file(plain)));
        const std::string bytes = read_file(marked);
        const auto pano = gpano_of(bytes);
        ASSERT_TRUE(pano);
        EXPECT_EQ(pano->full_width, 64);
        EXPECT_EQ(pano->cropped_height, 32);
        SphereMark other = whole_sphere(64, 64);
        other.top = 16, other.height = 32, other.heading_deg = 90;
        const std::string again = with_gpano(bytes, other, "file");
        EXPECT_EQ(again.find("GPano:FullPanoWidthPixels"), again.rfind("GPano:FullPanoWidthPixels"));
        EXPECT_EQ(gpano_of(again)->top, 16);
        EXPECT_NE(again.find("GPano:PoseHeadingDegrees=\"90.0\""), again.npos);
        EXPECT_EQ(decode_rgb8(again, "file"), load_rgb8(plain));
        for (std::size_t size = 0; size < bytes.size(); size += 7) gpano_of(std::string_view(bytes).substr(0, size));
    }
    EXPECT_THROW(with_gpano("RIFF", whole_sphere(2, 1), "file"), Error);
}

std::string number(std::uint64_t value, std::size_t size) {
    std::string out;
    for (std::size_t i = size; i-- > 0;) out += static_cast<char>(value >> (8 * i) & 0xff);
    return out;
}
std::string box(const std::string& name, const std::string& content) {
    return number(content.size() + 8, 4) + name + content;
}

// The boxes that matter, in the order of a film made for streaming: positions first. One sample, "DATA".
std::string small_film(std::size_t offset) {
    const std::string entry = box("avc1", std::string(78, '\1') + box("avcC", "x"));
    const auto track = [&](const char* kind, const std::string& of) {
        return box("trak", box("tkhd", "t") +
                               box("mdia", box("hdlr", number(0, 8) + kind + number(0, 13)) +
                                               box("minf", box("stbl", box("stsd", number(0, 4) + number(1, 4) + of) +
                                                                           box("stco", number(0, 4) + number(1, 4) +
                                                                                           number(offset, 4))))));
    };
    return box("ftyp", "isom") + box("moov", track("soun", box("mp4a", "y")) + track("vide", entry)) +
           box("mdat", "DATA");
}

TEST(SphericalFilm, BoxesAreWrittenAndSamplesStayWhereTheyAreSaid) {
    const std::string first = small_film(0);
    const std::string film = small_film(first.find("DATA"));
    EXPECT_FALSE(spherical_boxes_of(film));
    for (const SphericalFilm& want : {SphericalFilm{}, SphericalFilm{StereoLayout::top_bottom, false},
                                      SphericalFilm{StereoLayout::left_right, true}}) {
        std::string marked = with_spherical_boxes(film, want, "film.mp4");
        const auto found = spherical_boxes_of(marked);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->stereo, want.stereo);
        EXPECT_EQ(found->half, want.half);
        EXPECT_EQ(marked.find("GSpherical:Spherical") != marked.npos, !want.half);
        // Both tracks' positions moved with the data.
        for (std::size_t at = 0, n = 0; n < 2; ++n) {
            at = marked.find("stco", at) + 12;
            EXPECT_EQ(marked.substr(at, 4), number(marked.find("DATA"), 4));
        }
        // Marking again replaces.
        EXPECT_EQ(with_spherical_boxes(marked, want, "film.mp4"), marked);
    }
    for (const std::string& bad : {std::string("no film"), film.substr(0, 60), box("ftyp", "isom") + box("mdat", "x")})
        EXPECT_THROW(with_spherical_boxes(bad, {}, "film.mp4"), Error);
}

}  // namespace
}  // namespace fastscene
