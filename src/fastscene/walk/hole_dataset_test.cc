// The inpainting dataset: counts and holes as in the paper, no duplicates, robust against a broken picture.
#include "fastscene/walk/hole_dataset.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/walk/published_inpaint.h"
#include "fastscene/walk/published_warp.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

struct Folder {
    fs::path path = fs::temp_directory_path() / ("fastscene-holes-" + std::to_string(::getpid()));
    Folder() {
        fs::remove_all(path);
        make_directories(path / "in");
    }
    ~Folder() { fs::remove_all(path); }
};

// At the center of a box of 4 m; a post 1 m ahead.
void save_post(const fs::path& stem, int width) {
    const EquirectSize size{width, width / 2};
    ImageRgb8 color(size.width, size.height);
    Image<std::uint16_t> range(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec3f d = direction_of_pixel(x, y, size);
            const bool post = std::fabs(d.x) < 0.2f && d.z > 0.5f;
            const float wall = 2.f / std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)}), r = post ? 1.f : wall;
            color.at(x, y) = post ? Rgb8{200, 40, 40}
                                  : Rgb8{static_cast<std::uint8_t>(x * 255 / width), 120, static_cast<std::uint8_t>(y)};
            range.at(x, y) = static_cast<std::uint16_t>(r * 1000);
        }
    save_png(fs::path(stem).concat(".png"), color);
    save_png16(fs::path(stem).concat(".range.png"), range);
}

HoleDatasetParams small() {
    HoleDatasetParams params;
    params.size = 32;
    params.held_out = 0;
    return params;
}

std::int64_t files_in(const fs::path& folder) {
    std::int64_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) count += entry.is_regular_file();
    return count;
}

TEST(HoleDataset, SixFacesAndSixteenMasksOfEach) {
    const Folder folder;
    save_post(folder.path / "in/a", 128);
    save_post(folder.path / "in/b", 128);
    const auto panoramas = find_panoramas(folder.path / "in");
    ASSERT_EQ(panoramas.size(), 2u);
    const HoleDatasetState state = make_hole_dataset(panoramas, small(), folder.path / "out", {});
    EXPECT_EQ(state.made, 2);
    EXPECT_EQ(state.faces, 12);
    EXPECT_EQ(state.masks, 2 * 6 * 16);  // the paper: 14k panoramas, 84k faces, 1344k masks
    EXPECT_EQ(files_in(folder.path / "out/train/images"), state.faces);
    EXPECT_EQ(files_in(folder.path / "out/train/masks"), state.masks);

    // Mask 2 is the step of 0.02 towards +z, as the walk makes it.
    const Panorama panorama = load_panorama(panoramas[0]);
    Image<double> range(128, 64);
    std::copy(panorama.range.pixels.begin(), panorama.range.pixels.end(), range.pixels.begin());
    const PublishedWarp warp = published_warp(load_rgb8(panoramas[0].color), published_units(range), {0, 0, 0.02});
    ImageMask hole(128, 64);
    for (std::size_t i = 0; i < hole.size(); ++i) hole.pixels[i] = warp.source.pixels[i] == kNoSource ? 255 : 0;
    const auto faces = published_faces(warp.color, hole, 32);
    std::ptrdiff_t open = 0;
    for (std::size_t f = 0; f < 6; ++f) {
        EXPECT_EQ(load_mask_png(folder.path / fmt::format("out/train/masks/shard-00000/00000000-{}-02.png",
                                                          name_of(kPublishedFaces[f]))),
                  faces[f].hole);
        open += std::count(faces[f].hole.pixels.begin(), faces[f].hole.pixels.end(), 255);
    }
    EXPECT_GT(open, 20);

    const HoleDatasetState again = make_hole_dataset(panoramas, small(), folder.path / "out", {});
    EXPECT_EQ(again.made, 0);
    EXPECT_EQ(again.masks, state.masks);
    HoleDatasetParams other = small();
    other.shares = "0.02,0.05";
    EXPECT_THROW(make_hole_dataset(panoramas, other, folder.path / "out", {}), UsageError);
}

TEST(HoleDataset, BothWarps) {
    const Folder folder;
    save_post(folder.path / "in/a", 128);
    HoleDatasetParams params = small();
    params.warp = "both";
    params.shares = "0.03";
    params.metres = "0.3";
    const auto holes = walk_holes(load_panorama(find_panoramas(folder.path / "in")[0]), params);
    ASSERT_EQ(holes.size(), 16u);
    for (const ImageMask& hole : holes)
        EXPECT_LT(std::count(hole.pixels.begin(), hole.pixels.end(), 255),
                  static_cast<std::ptrdiff_t>(hole.size() / 2));
    // A step sideways reveals what was behind the post.
    EXPECT_GT(std::count(holes[10].pixels.begin(), holes[10].pixels.end(), 255), 20);
    params.metres = "0.3,x";
    EXPECT_THROW(walk_holes(load_panorama(find_panoramas(folder.path / "in")[0]), params), UsageError);
}

TEST(HoleDataset, ABrokenPictureIsSkippedAndCounted) {
    const Folder folder;
    for (const char* name : {"a", "b", "c"}) save_post(folder.path / "in" / name, 64);
    const std::string whole = read_file(folder.path / "in/b.png");
    write_file(folder.path / "in/b.png", whole.substr(0, whole.size() / 2));
    const auto panoramas = find_panoramas(folder.path / "in");
    const HoleDatasetState state = make_hole_dataset(panoramas, small(), folder.path / "out", {});
    EXPECT_EQ(state.broken, 1);
    EXPECT_EQ(state.there, 2);
    write_file(folder.path / "in/b.png", whole);
    const HoleDatasetState mended = make_hole_dataset(panoramas, small(), folder.path / "out", {});
    EXPECT_EQ(mended.made, 1);
    EXPECT_EQ(mended.there, 3);
}

TEST(HoleDataset, TheSameFolderByAnotherNameGoesOnAndAnotherOneDoesNot) {
    const Folder folder;
    for (const char* name : {"a", "b"}) save_post(folder.path / "in" / name, 64);
    make_hole_dataset(find_panoramas(folder.path / "in"), small(), folder.path / "out", {});
    const HoleDatasetState again = make_hole_dataset(find_panoramas(folder.path / "." / "in" / ""), small(),
                                                     folder.path / "out", {});
    EXPECT_EQ(again.there, 2);
    EXPECT_EQ(again.made, 0);
    fs::rename(folder.path / "in", folder.path / "moved");
    EXPECT_EQ(make_hole_dataset(find_panoramas(folder.path / "moved"), small(), folder.path / "out", {}).there, 2);
    save_post(folder.path / "moved/0", 64);
    EXPECT_THROW(make_hole_dataset(find_panoramas(folder.path / "moved"), small(), folder.path / "out", {}), UsageError)
        << "another list";
}

TEST(HoleDataset, NothingLeftToTrainOnIsTold) {
    struct : EventSink {
        std::string warnings;
        void tell(const Event& event) override {
            if (const auto* warning = std::get_if<WarningEvent>(&event)) warnings += warning->text;
        }
    } heard;
    const Folder folder;
    save_post(folder.path / "in/a", 64);
    HoleDatasetParams params = small();
    make_hole_dataset(find_panoramas(folder.path / "in"), params, folder.path / "out", {0, &heard, {}});
    EXPECT_EQ(heard.warnings, "");
    params.held_out = 100;
    make_hole_dataset(find_panoramas(folder.path / "in"), params, folder.path / "other", {0, &heard, {}});
    EXPECT_NE(heard.warnings.find("none is left to train on"), std::string::npos) << heard.warnings;
}

TEST(HoleDataset, NothingReadableIsAnErrorAndEachFileIsNamedOnce) {
    struct Warnings : EventSink {
        void tell(const Event& event) override {
            if (const auto* warning = std::get_if<WarningEvent>(&event)) texts.push_back(warning->text);
        }
        std::vector<std::string> texts;
    } warnings;
    fastscene::Run run;
    run.events = &warnings;
    const Folder folder;
    save_post(folder.path / "in/a", 64);
    save_post(folder.path / "in/b", 64);
    const std::string color = (folder.path / "in/a.png").string();
    write_file(color, read_file(color).substr(0, 99));
    write_file(folder.path / "in/b.range.png", std::string_view("no range"));
    EXPECT_THROW(make_hole_dataset(find_panoramas(folder.path / "in"), small(), folder.path / "out", run), Error);
    ASSERT_EQ(warnings.texts.size(), 2u);
    EXPECT_NE(warnings.texts[0].find(color), std::string::npos);
    EXPECT_EQ(warnings.texts[0].find(color), warnings.texts[0].rfind(color)) << warnings.texts[0];
    EXPECT_NE(warnings.texts[1].find("b.png"), std::string::npos) << warnings.texts[1];
    EXPECT_NE(warnings.texts[1].find("b.range.png"), std::string::npos) << warnings.texts[1];
}

TEST(HoleDataset, Structured3DAsDownloaded) {
    const Folder folder;
    const fs::path room = folder.path / "in/Structured3D/scene_00042/2D_rendering/485142/panorama/full";
    make_directories(room);
    save_post(folder.path / "in/x", 64);
    fs::rename(folder.path / "in/x.png", room / "rgb_rawlight.png");
    fs::rename(folder.path / "in/x.range.png", room / "depth.png");
    const auto found = find_panoramas(folder.path / "in");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].place, "scene_00042");
    EXPECT_NEAR(load_panorama(found[0]).range.at(32, 16), 1.f, 0.01f);
    EXPECT_THROW(find_panoramas(folder.path / "nowhere"), UsageError);
    make_directories(folder.path / "empty");
    EXPECT_THROW(find_panoramas(folder.path / "empty"), UsageError);
}

}  // namespace
}  // namespace fastscene
