#include "fastscene/depth/examples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/depth/photo_look.h"
#include "fastscene/depth/repaint.h"
#include "fastscene/depth/train.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

fs::path fresh(const std::string& name) {
    const fs::path folder = fs::path(::testing::TempDir()) / ("fastscene-examples-" + name);
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

void make_pair(const fs::path& color, const fs::path& range) {
    fs::create_directories(color.parent_path());
    save_png(color, ImageRgb8(64, 32, {90, 100, 110}));
    if (range.extension() == ".exr") save_exr(range, ImageF(64, 32, 2.5f));
    else save_png16(range, Image<std::uint16_t>(64, 32, 2500));
}

void make_room_picture(const fs::path& folder, int picture, int room, const std::string& model) {
    const fs::path shard = folder / "shard-00000";
    const std::string stem = fmt::format("{:08}", picture);
    make_pair(shard / (stem + ".color.png"), shard / (stem + ".range.png"));
    write_json(shard / (stem + ".json"), {{"picture", picture},
                                          {"room", room},
                                          {"color", stem + ".color.png"},
                                          {"range", stem + ".range.png"},
                                          {"camera", {{"model", model}}}});
}

TEST(Examples, RoomsAreHeldOutAsAWhole) {
    const fs::path folder = fresh("rooms");
    for (int i = 0; i < 200; ++i) make_room_picture(folder, i, i / 2, "EQUIRECTANGULAR");
    make_room_picture(folder, 900, 900, "PINHOLE");
    write_file(folder / "shard-00000" / "00000950.color.png", std::string_view("not yet finished"));
    const std::vector<DepthFiles> all = find_depth_files(folder);
    ASSERT_EQ(all.size(), 200u);
    int held_out = 0;
    for (std::size_t i = 0; i < all.size(); i += 2) {
        EXPECT_EQ(all[i].held_out, all[i + 1].held_out);
        EXPECT_EQ(all[i].place, all[i + 1].place);
        EXPECT_EQ(all[i].held_out, i / 2 % 10 == 9);
        held_out += all[i].held_out;
    }
    EXPECT_EQ(held_out, 10);
    const DepthExample example = load_example(all[0], {32, 16});
    EXPECT_EQ(example.color.at(5, 5), (Rgb8{90, 100, 110}));
    EXPECT_FLOAT_EQ(example.range.at(5, 5), 2.5f);
    EXPECT_TRUE(example.surfaces.empty());
}

TEST(Examples, SurfacesOfOurRooms) {
    const fs::path folder = fresh("surfaces"), shard = folder / "shard-00000";
    make_room_picture(folder, 0, 0, "EQUIRECTANGULAR");
    Image<std::uint16_t> pieces(64, 32);
    ImageRgb8 normals(64, 32, {128, 0, 128});  // a floor
    for (int y = 0; y < 32; ++y) pieces.at(40, y) = 300, normals.at(40, y) = {40, 128, 200};
    save_png16(shard / "00000000.instance.png", pieces);
    save_png(shard / "00000000.normal.png", normals);
    Json json = read_json(shard / "00000000.json");
    json["normal"] = "00000000.normal.png", json["instance"] = "00000000.instance.png";
    write_json(shard / "00000000.json", json);
    const DepthExample example = load_example(find_depth_files(folder).at(0), {64, 32}, true);
    EXPECT_EQ(example.surfaces.at(3, 9), surface_id(0, 1));
    EXPECT_EQ(example.surfaces.at(40, 9), surface_id(300, 0));
}

TEST(Examples, Structured3dAndPano3d) {
    const fs::path s3d = fresh("s3d");
    for (const char* scene : {"scene_00012", "scene_03100"})
        make_pair(s3d / scene / "2D_rendering" / "485142" / "panorama" / "full" / "rgb_rawlight.png",
                  s3d / scene / "2D_rendering" / "485142" / "panorama" / "full" / "depth.png");
    const std::vector<DepthFiles> rooms = find_depth_files(s3d);
    ASSERT_EQ(rooms.size(), 2u);
    EXPECT_FALSE(rooms[0].held_out);
    EXPECT_TRUE(rooms[1].held_out);
    EXPECT_FLOAT_EQ(load_example(rooms[0], {32, 16}).range.at(1, 1), 2.5f);
    // As the archives unpack, and a single scene.
    const fs::path downloads = fresh("downloads");
    for (const char* archive : {"Structured3D_panorama_00", "Structured3D_panorama_01"})
        make_pair(downloads / archive / "Structured3D/scene_00012/2D_rendering/1/panorama/full/rgb_rawlight.png",
                  downloads / archive / "Structured3D/scene_00012/2D_rendering/1/panorama/full/depth.png");
    EXPECT_EQ(find_depth_files(downloads).size(), 2u);
    EXPECT_EQ(find_depth_files(s3d / "scene_00012").size(), 1u);
    const fs::path pano3d = fresh("pano3d");
    make_pair(pano3d / "0_ab12_color_0_Left_Down_0.0.png", pano3d / "0_ab12_depth_0_Left_Down_0.0.exr");
    make_pair(pano3d / "0_cd34_color_0_Left_Down_0.0.png", pano3d / "elsewhere.exr");
    ASSERT_EQ(find_depth_files(pano3d).size(), 1u);
    EXPECT_FLOAT_EQ(load_example(find_depth_files(pano3d)[0], {32, 16}).range.at(1, 1), 2.5f);
}

TEST(Examples, BadFoldersAndPictures) {
    EXPECT_THROW(find_depth_files("/nowhere"), Error);
    EXPECT_THROW(find_depth_files(fresh("empty")), Error);
    const fs::path folder = fresh("bad");
    for (int i = 0; i < 3; ++i) make_room_picture(folder, i, i, "EQUIRECTANGULAR");
    write_file(folder / "shard-00000" / "00000001.color.png", std::string_view("damaged"));
    save_png16(folder / "shard-00000" / "00000002.range.png", Image<std::uint16_t>(50, 50, 1));
    std::vector<DepthFiles> files = find_depth_files(folder);
    for (DepthFiles& f : files) f.held_out = false;
    EXPECT_EQ(load_examples(files, false, {32, 16}, {}).size(), 1u);
    EXPECT_THROW(load_example(files[2], {32, 16}), Error);
    // Useless ranges: none measured, or all far beyond any room, like millimetres stored as floats.
    for (const float range : {0.f, 2500.f}) {
        files[0].range = folder / "far.exr";
        save_exr(files[0].range, ImageF(64, 32, range));
        EXPECT_THROW(load_example(files[0], {32, 16}), Error) << range;
    }
}

// The first archives of Structured3D contain no scene from 3000 on.
TEST(Examples, WithoutHeldOutPicturesTheFiguresSayWhatTheyAre) {
    const fs::path s3d = fresh("s3d-first"), scene = s3d / "scene_00012/2D_rendering/1/panorama/full";
    make_pair(scene / "rgb_rawlight.png", scene / "depth.png");
    Image<std::uint16_t> range(64, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) range.at(x, y) = static_cast<std::uint16_t>(2000 + 10 * x + 30 * y);
    save_png16(scene / "depth.png", range);
    struct : EventSink {
        std::string warnings;
        void tell(const Event& event) override {
            if (const auto* warning = std::get_if<WarningEvent>(&event)) warnings += warning->text;
        }
    } heard;
    DepthTraining training{{s3d}, {}, {}};
    training.params.height = 32;
    training.params.channels = 4;
    training.params.training.steps = training.params.training.batch = 1;
    const EgformerTrained trained = train_depth(training, fresh("s3d-trained"), {0, &heard, {}});
    EXPECT_GT(trained.abs_rel, 0);
    EXPECT_GT(trained.delta1, 0);
    EXPECT_NE(heard.warnings.find("expected held-out pictures, found none"), std::string::npos) << heard.warnings;
}

TEST(Examples, MeanRangeFillsWhatNobodyKnows) {
    DepthExample a{ImageRgb8(8, 4), ImageF(8, 4, 2.f)}, b{ImageRgb8(8, 4), ImageF(8, 4, 4.f)};
    for (int x = 0; x < 8; ++x) a.range.at(x, 0) = b.range.at(x, 0) = 0;
    b.range.at(0, 2) = 0;
    const std::vector<float> mean = mean_range_by_latitude({a, b});
    EXPECT_FLOAT_EQ(mean[0], 3.f);
    EXPECT_FLOAT_EQ(mean[1], 3.f);
    EXPECT_NEAR(mean[2], (8 * 2 + 7 * 4) / 15., 1e-5);
}

// Color and range are transformed together: a marked column stays next to its range.
TEST(PhotoLook, TurnsColorAndRangeTogether) {
    DepthExample example{ImageRgb8(64, 32), ImageF(64, 32, 1.f)};
    for (int y = 0; y < 32; ++y) example.color.at(10, y) = {255, 255, 255}, example.range.at(10, y) = 7.f;
    Random rng(1, "test");
    for (const bool mirrored : {false, true}) {
        const DepthExample seen = seen_as(example, {.turn = 0.3f, .mirrored = mirrored}, rng);
        int marked = 0;
        for (int x = 0; x < 64; ++x) {
            EXPECT_EQ(seen.color.at(x, 9).r == 255, seen.range.at(x, 9) == 7.f);
            marked += seen.range.at(x, 9) == 7.f;
        }
        EXPECT_EQ(marked, 1);
    }
}

TEST(PhotoLook, ChangesWhatItSays) {
    DepthExample example{ImageRgb8(64, 32, {120, 90, 60}), ImageF(64, 32, 1.f)};
    Random rng(2, "test");
    EXPECT_EQ(seen_as(example, {}, rng).color, example.color);
    EXPECT_GT(seen_as(example, {.exposure_ev = 1}, rng).color.at(3, 3).r, 150);
    const Rgb8 gray = seen_as(example, {.saturation = 0}, rng).color.at(3, 3);
    EXPECT_TRUE(gray.r == gray.g && gray.g == gray.b);
    EXPECT_GT(seen_as(example, {.white = {1, 1, 2}}, rng).color.at(3, 3).b, 75);
    const ImageRgb8 noisy = seen_as(example, {.noise = 0.05f}, rng).color;
    double square = 0;
    for (const Rgb8 c : noisy.pixels) square += std::pow((c.r - 120) / 255., 2);
    EXPECT_NEAR(std::sqrt(square / static_cast<double>(noisy.size())), 0.05, 0.01);
    DepthExample edge = example;
    for (int y = 0; y < 32; ++y) edge.color.at(20, y) = {255, 255, 255};
    EXPECT_GT(seen_as(edge, {.blur_px = 0.8f}, rng).color.at(21, 9).g, 110);
    EXPECT_NE(seen_as(edge, {.jpeg_quality = 45}, rng).color, edge.color);
    EXPECT_EQ(seen_as(edge, {.jpeg_quality = 45}, rng).range, edge.range);
}

TEST(PhotoLook, RandomLooksAreWithinReasonAndRepeat) {
    for (std::uint64_t i = 0; i < 300; ++i) {
        Random a(4, "look", i), b(4, "look", i);
        const PhotoLook look = random_photo_look(a), same = random_photo_look(b);
        EXPECT_EQ(look.exposure_ev, same.exposure_ev);
        EXPECT_TRUE(std::abs(look.exposure_ev) < 4 && look.turn >= 0 && look.turn < 1 && look.jpeg_quality >= 45 &&
                    look.white.x > 0.3f && look.white.x < 3.f);
    }
}

// A gray room with a window (no range) and two objects of the same gray.
DepthExample gray_room() {
    DepthExample room{ImageRgb8(64, 32, {120, 120, 120}), ImageF(64, 32, 2.f), SurfaceMap(64, 32)};
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            room.surfaces.at(x, y) = surface_id(y > 18 && x < 20   ? 1
                                                : y > 18 && x < 40 ? 2
                                                                   : 0,
                                                y < 8 || y > 24 ? 1 : 2);
            if (x > 50 && y > 10 && y < 16) room.range.at(x, y) = 0;
        }
    return room;
}

TEST(Repaint, ChangesColorsOfWholeSurfacesAndNothingElse) {
    const DepthExample room = gray_room();
    Random none(5, "repaint"), rng(5, "repaint"), again(5, "repaint");
    EXPECT_EQ(repainted(room, 0, none).color, room.color);
    const DepthExample other = repainted(room, 1, rng);
    EXPECT_EQ(other.color, repainted(room, 1, again).color);
    EXPECT_EQ(other.range, room.range);
    EXPECT_EQ(other.color.at(55, 12), room.color.at(55, 12)) << "a window";
    for (const auto& [x, y] : {std::pair{5, 20}, {30, 20}, {60, 20}, {5, 3}, {60, 30}})
        EXPECT_NE(other.color.at(x, y), room.color.at(x, y));
    EXPECT_NE(other.color.at(19, 22), other.color.at(20, 22)) << "two things, two paints";
    EXPECT_NE(other.color.at(45, 22), other.color.at(39, 22)) << "thing and wall";
    DepthExample bare = room;
    bare.surfaces = {};
    EXPECT_EQ(repainted(bare, 1, rng).color, room.color);
}

// Shaded parts of a surface stay darker than the rest, whatever the color.
TEST(Repaint, KeepsShade) {
    int plain = 0;
    for (std::uint64_t i = 0; i < 40; ++i) {
        DepthExample room = gray_room();
        for (int y = 18; y < 25; ++y)
            for (int x = 10; x < 20; ++x) room.color.at(x, y) = {60, 60, 60};
        Random rng(i, "shade");
        const ImageRgb8 color = repainted(room, 1, rng).color;
        if (color.at(2, 20) != color.at(7, 23)) continue;  // has a pattern
        ++plain;
        EXPECT_LT(color.at(15, 21).g, color.at(5, 21).g);
    }
    EXPECT_GT(plain, 5);
}

}  // namespace
}  // namespace fastscene
