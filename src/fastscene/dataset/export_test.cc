// The contract of every export format, verify, splits and statistics.
#include "fastscene/dataset/export.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <map>
#include <set>

#include "fastscene/base/file.h"
#include "fastscene/base/parallel.h"
#include "fastscene/dataset/card.h"
#include "fastscene/dataset/statistics.h"
#include "fastscene/dataset/verify.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/image_io.h"

namespace fastscene::dataset {
namespace {

namespace fs = std::filesystem;

fs::path tests_folder() { return fs::temp_directory_path() / fmt::format("fastscene-export-{}", ::getpid()); }

std::map<std::string, std::string> files_below(const fs::path& folder) {
    std::map<std::string, std::string> out;
    for (const auto& e : fs::recursive_directory_iterator(folder))
        if (e.is_regular_file()) out[fs::relative(e.path(), folder).string()] = read_file(e.path());
    return out;
}

DatasetRequest small_request(const char* camera) {
    DatasetRequest r{8, 64, 32, {}};
    r.params.camera = camera;
    r.params.views = 2;
    r.params.shard = 3;
    r.params.channels = "intrinsics,flow";
    r.params.trace = {.cell_m = 0.3f, .cell_samples = 4, .pixel_samples = 1, .outside_detail = 0};
    return r;
}

// Two sets, made once for all tests here; a test that damages one copies it.
class Exports : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        fs::remove_all(tests_folder());
        for (const char* camera : {"panorama", "perspective"})
            make_dataset(small_request(camera), tests_folder() / camera, {.seed = 5, .events = nullptr, .stop = {}});
    }
    static void TearDownTestSuite() { fs::remove_all(tests_folder()); }

    static fs::path set(bool panorama) { return tests_folder() / (panorama ? "panorama" : "perspective"); }
    static fs::path place(const std::string& name) { return tests_folder() / name; }
    static ExportSettings halves() {
        ExportSettings settings;
        settings.splits = {0.5, 0.25, 0.25};
        settings.shard_samples = 3;
        return settings;
    }
};

TEST_F(Exports, AreTheSameForAnyNumberOfThreadsAndWhenMadeAgain) {
    for (const DatasetFormat& format : registered<DatasetFormat>())
        for (const bool panorama : {true, false}) {
            if (!(panorama ? format.panoramas : format.perspective)) continue;
            const fs::path one = place(format.name + "-one"), several = place(format.name + "-several");
            fs::remove_all(one);
            fs::remove_all(several);
            set_threads(1);
            const Json done = export_dataset(set(panorama), format.name, halves(), one, {});
            EXPECT_EQ(done.at("pictures"), 8);
            set_threads(4);
            export_dataset(set(panorama), format.name, halves(), several, {});
            set_threads(0);
            const auto expected = files_below(one);
            EXPECT_EQ(expected, files_below(several)) << format.name;
            EXPECT_EQ(expected.size(), done.at("files").get<std::size_t>() + 2) << "and export.json, files.tsv";
            export_dataset(set(panorama), format.name, halves(), several, {});
            EXPECT_EQ(expected, files_below(several)) << format.name << ", again";
            ExportSettings others = halves();
            others.splits = {1, 0, 0};
            EXPECT_THROW(export_dataset(set(panorama), format.name, others, several, {}), UsageError);
        }
}

TEST_F(Exports, DamageIsFoundInEveryFormat) {
    for (const DatasetFormat& format : registered<DatasetFormat>()) {
        const fs::path out = place(format.name + "-damaged");
        export_dataset(set(!format.perspective), format.name, halves(), out, {});
        const VerifyReport whole = verify(out, false, {});
        EXPECT_TRUE(whole.is_export);
        EXPECT_TRUE(whole.faults.empty()) << format.name;
        const std::vector<ExportedFile> files = exported_files(out);
        ASSERT_GE(files.size(), 3u);
        const auto file = [&](std::size_t i) { return out / files[i].name; };
        const std::string first = read_file(file(0)), second = read_file(file(1));
        write_file(file(0), first.substr(0, first.size() / 2));
        std::string flipped = second;
        flipped[flipped.size() / 2] ^= 1;
        write_file(file(1), flipped);
        fs::remove(file(2));
        const VerifyReport found = verify(out, false, {});
        ASSERT_EQ(found.faults.size(), 3u) << format.name;
        EXPECT_EQ(found.faults[0].file, files[0].name);
        EXPECT_TRUE(found.faults[0].fault.starts_with("truncated")) << found.faults[0].fault;
        EXPECT_TRUE(found.faults[1].fault.starts_with("damaged")) << found.faults[1].fault;
        EXPECT_EQ(found.faults[2].fault, "missing");
        EXPECT_EQ(verify(out, true, {}).faults.size(), 2u) << "a changed byte keeps its size";
        export_dataset(set(!format.perspective), format.name, halves(), out, {});
        EXPECT_TRUE(verify(out, false, {}).faults.empty()) << format.name;
        write_file(out / "files.tsv", std::string_view("nothing"));
        EXPECT_THROW(verify(out, false, {}), Error);
    }
}

TEST_F(Exports, WhatCannotBeIsRefused) {
    EXPECT_THROW(export_dataset(set(true), "colmap", {}, place("no"), {}), UsageError) << "panoramas";
    EXPECT_THROW(export_dataset(set(true), "webdatset", {}, place("no"), {}), UsageError);
    EXPECT_THROW(export_dataset(place("nowhere"), "coco", {}, place("no"), {}), UsageError);
    EXPECT_FALSE(fs::exists(place("no")));
    make_directories(place("full"));
    write_file(place("full") / "mine.txt", std::string_view("of the user"));
    EXPECT_THROW(export_dataset(set(true), "coco", {}, place("full"), {}), UsageError);
    EXPECT_THROW(export_dataset(set(true), "coco", {}, set(true), {}), UsageError);
    EXPECT_THROW(verify(place("full"), false, {}), UsageError);
    for (const char* shares : {"1", "0.5,0.5", "0.5,0.4,0.2", "1,0,0,0", "a,b,c", "2,-1,0", ""})
        EXPECT_THROW(split_shares(shares), UsageError) << shares;
}

TEST_F(Exports, ArchivesAreNoLargerThanAsked) {
    for (const std::uint64_t most : {200000u, 100000u, 1u}) {
        ExportSettings settings;
        settings.splits = {1, 0, 0};
        settings.shard_bytes = most;
        const fs::path out = place(fmt::format("archives-{}", most));
        export_dataset(set(true), "webdataset", settings, out, {});
        std::uint64_t largest = 0, archives = 0;
        for (const ExportedFile& file : exported_files(out)) largest = std::max(largest, file.sum.bytes), ++archives;
        if (most > 1) EXPECT_LE(largest, most);
        if (most == 1) EXPECT_EQ(archives, 8u) << "a picture is never cut";
        EXPECT_GT(archives, 1u);
    }
}

TEST_F(Exports, SetsThatLackOrDamagedAreNotExported) {
    const fs::path copy = place("lacking");
    fs::copy(set(true), copy, fs::copy_options::recursive);
    write_file(copy / "shard-00000/00000001.color.jpg", std::string_view("no picture"));
    EXPECT_THROW(export_dataset(copy, "huggingface", halves(), place("lacking-out"), {}), Error);
    EXPECT_THROW(verify(place("lacking-out"), false, {}), Error) << "not finished";
    fs::remove(copy / "shard-00000/00000001.json");
    EXPECT_THROW(export_dataset(copy, "huggingface", halves(), place("lacking-out"), {}), Error);
    Json settings = read_json(copy / "dataset.json");
    settings["settings"]["shard"] = 0;
    make_directories(place("nonsense"));
    write_json(place("nonsense") / "dataset.json", settings);
    EXPECT_THROW(DataSet(place("nonsense"), false), UsageError);
    EXPECT_EQ(statistics_of(DataSet(copy, false)).pictures, 7) << "a set in work can be counted";
}

TEST_F(Exports, DamageInASetIsFoundAndMadeAgain) {
    const fs::path copy = place("repaired");
    fs::copy(set(true), copy, fs::copy_options::recursive);
    const auto expected = files_below(copy);
    EXPECT_TRUE(verify(copy, false, {}).faults.empty());
    const auto change = [&](const char* name, const auto& by) {
        std::string bytes = read_file(copy / name);
        by(bytes);
        write_file(copy / name, bytes);
    };
    change("shard-00000/00000000.color.jpg", [](std::string& b) { b[b.size() / 2] ^= 4; });
    change("shard-00000/00000001.range.png", [](std::string& b) { b.resize(b.size() - 1); });
    change("shard-00001/00000004.json", [](std::string& b) { b.replace(b.find("\"room\": 2"), 9, "\"room\": 3"); });
    change("rooms-00000/0000002.json", [](std::string& b) { b += " "; });
    fs::remove(copy / "shard-00001/00000005.flow.png");
    const VerifyReport found = verify(copy, false, {});
    std::map<std::string, std::string> faults;
    for (const FoundFault& f : found.faults) faults[f.file] = f.fault.substr(0, f.fault.find(':'));
    EXPECT_EQ(faults, (std::map<std::string, std::string>{{"shard-00000/00000000.color.jpg", "damaged"},
                                                          {"shard-00000/00000001.range.png", "truncated"},
                                                          {"shard-00001/00000004.json", "damaged"},
                                                          {"shard-00001/00000005.flow.png", "missing"},
                                                          {"rooms-00000/0000002.json", "damaged"}}));
    forget_damaged(copy, found);
    const MadeFrom from = made_from(read_set_settings(copy), copy);
    EXPECT_EQ(make_dataset(from.request, copy, {.seed = from.seed, .events = nullptr, .stop = {}}).made, 4);
    EXPECT_TRUE(verify(copy, false, {}).faults.empty());
    EXPECT_EQ(files_below(copy), expected);
    fs::remove(copy / "index.txt");
    ASSERT_EQ(verify(copy, false, {}).faults.size(), 1u);
    make_dataset(from.request, copy, {.seed = from.seed, .events = nullptr, .stop = {}});
    EXPECT_EQ(files_below(copy), expected);
}

TEST_F(Exports, ARoomIsInOneSplitAndStaysThere) {
    const SplitShares shares{0.7, 0.2, 0.1};
    std::array<int, 3> counts{};
    for (int room = 0; room < 10000; ++room) ++counts[split_of(1, room, shares)];
    EXPECT_NEAR(counts[0], 7000, 200);
    EXPECT_NEAR(counts[1], 2000, 150);
    EXPECT_NEAR(counts[2], 1000, 120);
    const SplitShares two{0.9, 0.1, 0};
    for (int room = 0; room < 1000; ++room) EXPECT_NE(split_of(7, room, two), 2u);
    const DataSet all(set(true), true);
    std::map<int, std::set<std::size_t>> splits_of_room;
    const auto splits = split_pictures(all, {0.4, 0.3, 0.3});
    std::size_t pictures = 0;
    for (std::size_t s = 0; s < splits.size(); ++s)
        for (const SetPicture* picture : splits[s]) splits_of_room[picture->room].insert(s), ++pictures;
    EXPECT_EQ(pictures, all.pictures().size());
    for (const auto& [room, in] : splits_of_room) EXPECT_EQ(in.size(), 1u) << room;
}

// Against the maps themselves.
TEST_F(Exports, StatisticsCountThePixels) {
    const DataSet all(set(true), true);
    const Statistics statistics = statistics_of(all);
    std::vector<std::int64_t> classes(41), bins(kRangeBins);
    std::uint64_t bytes = 0;
    for (const SetPicture& picture : all.pictures()) {
        for (const std::uint8_t c : load_mask_png(all.file(picture, "class")).pixels) ++classes[c];
        for (const float r : load_float(all.file(picture, "range"), 1.f).pixels)
            if (r > 0) ++bins[static_cast<std::size_t>(std::min(kRangeBins - 1, static_cast<int>(r) / 500))];
        bytes += fs::file_size(all.file(picture, "color"));
    }
    EXPECT_EQ(statistics.rooms, 4);
    for (std::size_t c = 0; c < classes.size(); ++c) EXPECT_EQ(statistics.classes[c].pixels, classes[c]) << c;
    for (std::size_t i = 0; i < bins.size(); ++i)
        EXPECT_NEAR(static_cast<double>(statistics.range_bins[i]), static_cast<double>(bins[i]), 16) << i;  // rounding
    EXPECT_EQ(statistics.bytes.at("color"), bytes);
    EXPECT_EQ(to_json(statistics).at("pictures"), 8);
    EXPECT_NE(to_text(statistics).find("8 pictures of 4 rooms"), std::string::npos);
}

TEST_F(Exports, TheCardSaysWhatMadeTheSet) {
    const fs::path copy = place("card");
    fs::copy(set(true), copy, fs::copy_options::recursive);
    const std::string card = read_file(copy / "README.md");
    for (const char* text : {"# 8 panoramas of 4 furnished rooms",
                             "fastscene rooms dataset --count 8 --size 64x32 --seed 5 --camera panorama",
                             "--channels intrinsics,flow", "--views 2", "--cell 0.3", "NYU40", "None chosen yet"})
        EXPECT_NE(card.find(text), std::string::npos) << text;
    EXPECT_EQ(card.find("trace-device"), std::string::npos) << "usual settings are left out";
    choose_license(copy, "cc-by-4.0");
    write_card(copy);
    EXPECT_NE(read_file(copy / "README.md").find("cc-by-4.0"), std::string::npos);
    DatasetRequest longer = small_request("panorama");
    longer.count = 9;
    make_dataset(longer, copy, {.seed = 5, .events = nullptr, .stop = {}});
    EXPECT_NE(read_file(copy / "README.md").find("cc-by-4.0"), std::string::npos) << "kept when the set grows";
    EXPECT_NE(read_file(copy / "README.md").find("# 9 panoramas"), std::string::npos);
}

void expect_same_camera(const Photo& photo, const Camera& camera) {
    const Rigid& pose = camera.world_from_camera;
    for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        EXPECT_NEAR(photo.world_from_camera.translation[axis], static_cast<double>(pose.translation[axis]), 1e-5);
        Vec3f unit{};
        unit[axis] = 1;
        const Vec3f turned = pose.rotation * unit;
        const Vec3d found = photo.world_from_camera.rotation * Vec3d{unit.x, unit.y, unit.z};
        EXPECT_NEAR(length(found - Vec3d{turned.x, turned.y, turned.z}), 0, 1e-5);
    }
    EXPECT_EQ(photo.lens.kind == LensKind::equirectangular, camera.panorama);
    if (!camera.panorama) {
        EXPECT_NEAR(static_cast<double>(photo.lens.pinhole().fx), static_cast<double>(camera.pinhole.fx), 1e-3);
    }
}

// Read by the readers of captures, which do not know of data sets.
TEST_F(Exports, RoomFoldersHaveTheSetsCameras) {
    for (const auto& [format, panorama] : {std::pair{"colmap", false}, {"nerfstudio", false}, {"nerfstudio", true}}) {
        const fs::path out = place(fmt::format("cameras-{}-{}", format, panorama));
        ExportSettings all;
        all.splits = {1, 0, 0};
        export_dataset(set(panorama), format, all, out, {});
        const DataSet source(set(panorama), true);
        std::size_t photos = 0;
        for (int room = 0; room < 4; ++room) {
            const fs::path folder = out / fmt::format("train/room-{:07}", room);
            EXPECT_TRUE(fs::exists(folder / "room.json"));
            const Capture capture = format == std::string("colmap") ? load_colmap_capture(folder, {})
                                                                    : load_nerfstudio_capture(folder, {});
            ASSERT_EQ(capture.photos.size(), 2u);
            for (const Photo& photo : capture.photos) {
                const auto number = std::stoul(fs::path(photo.name).stem().string());
                expect_same_camera(photo, source.camera(source.pictures().at(number)));
                ++photos;
            }
            EXPECT_GT(capture.points.size(), 1000u);
        }
        EXPECT_EQ(photos, 8u);
    }
}

}  // namespace
}  // namespace fastscene::dataset
