#include "fastscene/dataset/dataset.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <map>
#include <thread>

#include "fastscene/base/file.h"
#include "fastscene/base/parallel.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/io/image_io.h"
#include "fastscene/dataset/parts.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

class Dataset : public testing::Test {
  protected:
    fs::path folder_ = fs::temp_directory_path() / fmt::format("fastscene-dataset-{}", ::getpid());
    void SetUp() override { fs::remove_all(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    static DatasetRequest small(int count) {
        DatasetRequest r{count, 64, 32, {}};
        r.params.views = 2;
        r.params.shard = 3;
        r.params.trace = {.cell_m = 0.25f, .cell_samples = 8, .pixel_samples = 1, .outside_detail = 0};
        return r;
    }
    static std::map<std::string, std::string> files(const fs::path& folder) {
        std::map<std::string, std::string> out;
        for (const auto& e : fs::recursive_directory_iterator(folder))
            if (e.is_regular_file()) out[fs::relative(e.path(), folder).string()] = read_file(e.path());
        return out;
    }
};

TEST_F(Dataset, ResumedAndLengthenedIsTheSameBytes) {
    fastscene::Run run;
    run.seed = 4;
    const DatasetState whole = make_dataset(small(5), folder_ / "whole", run);
    EXPECT_EQ(whole.made, 5);
    EXPECT_EQ(whole.there, 5);
    make_dataset(small(2), folder_ / "parts", run);
    // An unfinished picture: its JSON, which is written last, is missing.
    fs::remove(folder_ / "parts/shard-00000/00000001.json");
    fs::remove(folder_ / "parts/shard-00000/00000001.range.png");
    EXPECT_EQ(make_dataset(small(5), folder_ / "parts", run).made, 4);
    EXPECT_EQ(make_dataset(small(5), folder_ / "parts", run).made, 0);
    EXPECT_EQ(files(folder_ / "whole"), files(folder_ / "parts"));
}

// Two at a time, in any order, with further maps; and the last room grows.
TEST_F(Dataset, AnyNumberOfWorkersGivesTheSameBytes) {
    fastscene::Run run;
    run.seed = 6;
    DatasetRequest request = small(4);
    request.params.channels = "flow,intrinsics";
    set_threads(1);
    make_dataset(request, folder_ / "one", run);
    set_threads(0);
    DatasetRequest shorter = request;
    shorter.count = 3;
    make_dataset(shorter, folder_ / "several", run);
    std::vector<std::thread> workers;
    for (int i = 0; i < 2; ++i) workers.emplace_back([&] { make_dataset(request, folder_ / "several", run); });
    for (std::thread& worker : workers) worker.join();
    make_dataset(request, folder_ / "several", run);  // what was claimed and left
    const auto one = files(folder_ / "one"), several = files(folder_ / "several");
    EXPECT_EQ(one.size(), 4 * 9 + 2 + 3u) << "pictures, rooms, settings, index and card";
    for (const auto& [name, bytes] : one) EXPECT_TRUE(several.contains(name) && several.at(name) == bytes) << name;
    EXPECT_EQ(one.size(), several.size());
}

TEST_F(Dataset, OtherSettingsAreRefused) {
    make_dataset(small(1), folder_, {});
    DatasetRequest other = small(1);
    other.height = other.width = 48;
    EXPECT_THROW(make_dataset(other, folder_, {}), UsageError);
    fastscene::Run run;
    run.seed = 9;
    EXPECT_THROW(make_dataset(small(1), folder_, run), UsageError);
    other = small(0);
    EXPECT_THROW(make_dataset(other, folder_, {}), UsageError);
    other = small(1);
    other.params.channels = "flow";
    EXPECT_THROW(make_dataset(other, folder_, {}), UsageError);
    other.params.channels = "flo";
    EXPECT_THROW(make_dataset(other, folder_ / "another", {}), UsageError);
}

// Neighbouring ranges as 3D points must span a plane with the normal of the normal map: verifies frames, units and
// signs.
TEST_F(Dataset, RangeNormalsAndClassesAgree) {
    DatasetRequest request = small(2);
    request.width = 256;
    request.height = 128;
    request.params.film = "clean";
    make_dataset(request, folder_, {});
    const EquirectSize size{256, 128};
    for (int picture = 0; picture < 2; ++picture) {
        const std::string stem = (folder_ / fmt::format("shard-00000/{:08}", picture)).string();
        const ImageF range = load_float(stem + ".range.png", 0.001f);
        const ImageRgb8 normals = load_rgb8(stem + ".normal.png"), color = load_rgb8(stem + ".color.png");
        const ImageMask classes = load_mask_png(stem + ".class.png");
        ASSERT_EQ(color.width, 256);
        int flat = 0, agree = 0, shell = 0;
        for (int y = 20; y < 108; ++y)
            for (int x = 1; x < 255; ++x) {
                if (range.at(x, y) <= 0 || range.at(x + 1, y) <= 0 || range.at(x, y + 1) <= 0) continue;
                const auto point = [&](int px, int py) { return direction_of_pixel(px, py, size) * range.at(px, py); };
                const Vec3f p = point(x, y), n = normalize(cross(point(x, y + 1) - p, point(x + 1, y) - p));
                const Rgb8 c = normals.at(x, y);
                const Vec3f m = normalize(Vec3f{static_cast<float>(c.r) - 127.5f, static_cast<float>(c.g) - 127.5f,
                                                static_cast<float>(c.b) - 127.5f});
                const int k = classes.at(x, y);
                if (k != 1 && k != 2 && k != 22) continue;
                EXPECT_LT(dot(m, p), 0.02f * length(p)) << "normals look at the camera";
                EXPECT_TRUE(k != 2 || m.y < -0.5f) << "floors look up";
                ++shell;
                ++flat;
                agree += std::abs(dot(n, m)) > 0.97f ? 1 : 0;
            }
        EXPECT_GT(shell, 1000);
        EXPECT_GT(agree, 0.85 * flat);
    }
}

// Straight below the camera there is furniture if positions over furniture are requested.
TEST_F(Dataset, PlacesOverFurniture) {
    const auto over_furniture = [&](double share, const char* name) {
        DatasetRequest request = small(16);
        request.params.views = 4;
        request.params.shard = 100;
        request.params.over_things = share;
        make_dataset(request, folder_ / name, {});
        int found = 0;
        for (int i = 0; i < request.count; ++i) {
            if (i % request.params.views == 0) continue;  // the room's own camera position
            const ImageMask classes = load_mask_png(folder_ / name / fmt::format("shard-00000/{:08}.class.png", i));
            const int nadir = classes.at(5, classes.height - 1);
            constexpr int kFloor = 2, kRug = 20;
            found += nadir != kFloor && nadir != kRug;
        }
        return found;
    };
    EXPECT_GE(over_furniture(1, "over"), 8);
    EXPECT_LE(over_furniture(0, "anywhere"), 5);
}

TEST_F(Dataset, AClaimIsHeldByOneAndInheritedFromTheDead) {
    make_directories(folder_);
    {
        const auto mine = dataset::Claim::take(folder_, "a", 10);
        ASSERT_TRUE(mine);
        EXPECT_FALSE(dataset::Claim::take(folder_, "a", 10));
        EXPECT_TRUE(dataset::Claim::take(folder_, "b", 10));
    }
    EXPECT_TRUE(dataset::Claim::take(folder_, "a", 10)) << "released";
    const pid_t child = ::fork();
    if (child == 0) {
        const auto held = dataset::Claim::take(folder_, "a", 10);
        ::_exit(held ? 0 : 1);  // no destructors: simulates a kill
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_EQ(WEXITSTATUS(status), 0);
    ASSERT_TRUE(fs::exists(folder_ / "a.claim"));
    EXPECT_TRUE(dataset::Claim::take(folder_, "a", 10));
}

TEST(DatasetRooms, DifferAndCanBeDrawnAgain) {
    const dataset::RandomRoom a = dataset::random_room(1, 0), again = dataset::random_room(1, 0),
                              b = dataset::random_room(1, 1);
    EXPECT_EQ(a.prompt, again.prompt);
    ASSERT_EQ(a.room.meshes.size(), again.room.meshes.size());
    EXPECT_EQ(a.room.meshes[0].positions, again.room.meshes[0].positions);
    EXPECT_NE(a.prompt, b.prompt);
}

TEST(DatasetClasses, OfOurPieces) {
    for (const auto& [kind, id] :
         std::map<std::string, int>{{"bed_single", 4},    {"nightstand", 32},   {"bookshelf", 10},
                                    {"armchair", 5},      {"sofa", 6},          {"dining_table_round", 7},
                                    {"door", 8},          {"window", 9},        {"kitchen_counter", 12},
                                    {"rug", 20},          {"tv", 25},           {"tv_stand", 39},
                                    {"washbasin", 34},    {"floor_lamp", 35},   {"grand piano", 39},
                                    {"zebra", 40},        {"bunk_bed", 4},      {"loft_bed", 4},
                                    {"canopy_bed", 4},    {"daybed", 4},        {"bean_bag", 5},
                                    {"hanging_chair", 5}, {"chaise_longue", 6}, {"window_seat", 5}})
        EXPECT_EQ(nyu40_label(kind), id) << kind;
}

}  // namespace
}  // namespace fastscene
