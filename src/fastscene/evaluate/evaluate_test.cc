#include "fastscene/evaluate/evaluate.h"

#include <gtest/gtest.h>

#include "fastscene/base/file.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Scenes that cannot be made (their pictures are no panoramas), and a peer with pictures of them.
class TwoScenes : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder_);
        std::string text = "measures = [\"stills\"]\ncolumns = [\"niqe\", \"minutes\"]\n";
        for (const std::string name : {"a", "b"}) {
            make_directories(folder_ / "peer" / name);
            save_png(folder_ / (name + ".png"), ImageRgb8(30, 20, Rgb8{9, 9, 9}));
            save_png(folder_ / "peer" / name / "0.png", ImageRgb8(30, 20, Rgb8{9, 9, 9}));
            text += "[[scene]]\npanorama = \"" + name + ".png\"\n";
        }
        write_file(folder_ / "peer/a/minutes.txt", "10");
        write_file(folder_ / "peer/b/minutes.txt", "20");
        make_directories(folder_ / "weights");
        suite_ = read_suite(text, "two", folder_ / "two.toml");
    }
    void TearDown() override { fs::remove_all(folder_); }

    Json results(int scenes) const {
        return evaluate(suite_, {folder_ / "out", folder_ / "weights", scenes, {{"Peer", folder_ / "peer"}}}, {});
    }
    static const Json& row_of(const Json& results, const std::string& name) {
        for (const Json& row : results.at("rows"))
            if (row.at("name") == name) return row;
        throw Error("no row {}", name);
    }

    fs::path folder_ = fs::temp_directory_path() / "fastscene_evaluate_test";
    Suite suite_;
};

TEST_F(TwoScenes, APeerIsMeasuredOverTheScenesThatWereChosen) {
    const Json both = results(0), first = results(1);
    EXPECT_EQ(row_of(both, "Peer").at("cells").at("minutes").at("value"), 15.0);
    EXPECT_NEAR(row_of(both, "Peer").at("cells").at("minutes").at("sd").get<double>(), 7.0711, 1e-3);
    EXPECT_EQ(row_of(first, "Peer").at("cells").at("minutes").at("value"), 10.0) << "the other scene was not chosen";
    EXPECT_EQ(row_of(first, "Peer").at("of"), 1);
}

TEST_F(TwoScenes, FailedScenesKeepTheirRowAndTheirReasons) {
    const Json both = results(0);
    EXPECT_EQ(row_of(both, "ours").at("scenes"), 0);
    EXPECT_EQ(row_of(both, "ours").at("of"), 2);
    const std::string markdown = read_file(folder_ / "out/table.md");
    for (const char* scene : {"a", "b"})
        EXPECT_NE(markdown.find(std::string("- failed: ours, ") + scene + ", seed 0: "), std::string::npos) << markdown;
}

TEST_F(TwoScenes, WhatIsRefusedLeavesNothingBehind) {
    suite_.peers = {{"Nobody", folder_ / "none"}};
    EXPECT_THROW(results(0), UsageError);
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    suite_.peers = {{"peer", folder_ / "peer"}};
    EXPECT_THROW(results(0), UsageError) << "two rows of one name";
}

TEST_F(TwoScenes, APeersSphereNeedsOurPanorama) {
    suite_.measures = {"source"};
    suite_.columns = {"source_psnr"};
    save_png(folder_ / "peer/a/source.png", ImageRgb8(64, 32));
    const Json all = results(1);
    const Json& cell = row_of(all, "Peer").at("cells").at("source_psnr");
    ASSERT_TRUE(cell.contains("notes"));
    EXPECT_NE(cell.at("notes").dump().find("needs our own run"), std::string::npos) << cell;
}

}  // namespace
}  // namespace fastscene
