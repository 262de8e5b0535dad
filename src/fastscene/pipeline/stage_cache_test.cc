#include "fastscene/pipeline/stage_cache.h"

#include <gtest/gtest.h>

#include "fastscene/base/file.h"
#include "fastscene/pipeline/stage_code.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

class StageCache : public ::testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::path(::testing::TempDir()) /
                (std::string("fastscene-cache-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(root_);
        make_directories(root_);
    }
    void TearDown() override { fs::remove_all(root_); }
    // Runs a stage that writes `text`; counts actual executions.
    StageRecord make(const std::string& key, const std::string& text) {
        return run_stage(root_, "walk", key, run_, [&](const fs::path& out) {
            ++made_;
            make_directories(out / "000");
            write_file(out / "000" / "a.txt", text);
        });
    }
    std::string content() const { return read_file(root_ / "walk" / "000" / "a.txt"); }
    fs::path root_;
    fastscene::Run run_;
    int made_ = 0;
};

TEST_F(StageCache, TheSameKeyIsMadeOnce) {
    const StageRecord first = make("k", "one"), second = make("k", "two");
    EXPECT_EQ(made_, 1);
    EXPECT_FALSE(first.skipped);
    EXPECT_TRUE(second.skipped);
    EXPECT_EQ(first.result, second.result);
    EXPECT_EQ(content(), "one");
    EXPECT_EQ(second.cost.seconds, first.cost.seconds);
}

TEST_F(StageCache, AnotherKeyReplacesTheWholeDirectory) {
    make("k", "one");
    write_file(root_ / "walk" / "stale.txt", "x");
    const StageRecord other = make("l", "two");
    EXPECT_EQ(made_, 2);
    EXPECT_EQ(content(), "two");
    EXPECT_FALSE(fs::exists(root_ / "walk" / "stale.txt"));
    EXPECT_NE(other.result, "");
}

TEST_F(StageCache, EqualFilesHaveEqualResultsWhateverTheKey) {
    EXPECT_EQ(make("k", "one").result, make("l", "one").result);
}

TEST_F(StageCache, AMissingOrShortenedFileIsMadeAgain) {
    make("k", "one");
    fs::remove(root_ / "walk" / "000" / "a.txt");
    make("k", "one");
    EXPECT_EQ(made_, 2);
    write_file(root_ / "walk" / "000" / "a.txt", "o");
    make("k", "one");
    EXPECT_EQ(made_, 3);
    EXPECT_EQ(content(), "one");
}

TEST_F(StageCache, AFailureKeepsWhatWasThere) {
    make("k", "one");
    const auto fail = [&] {
        run_stage(root_, "walk", "l", run_, [&](const fs::path& out) {
            write_file(out / "half.txt", "x");
            throw Error("no more");
        });
    };
    EXPECT_THROW(fail(), Error);
    EXPECT_EQ(content(), "one");
    EXPECT_TRUE(make("k", "one").skipped);
    std::size_t entries = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(root_)) ++entries;
    EXPECT_EQ(entries, 1u);
}

TEST_F(StageCache, AnUnreadableRecordMeansNotMade) {
    make("k", "one");
    write_file(root_ / "walk" / "stage.json", "{}");
    EXPECT_FALSE(finished_stage(root_, "walk"));
    make("k", "one");
    EXPECT_EQ(made_, 2);
    EXPECT_TRUE(finished_stage(root_, "walk"));
}

TEST_F(StageCache, WhatAKilledRunLeftIsSweptAway) {
    make_directories(root_ / ".walk.part" / "007");
    write_file(root_ / ".walk.part" / "007" / "half.png", "x");
    make("k", "one");
    EXPECT_FALSE(fs::exists(root_ / "walk" / "007"));
    EXPECT_FALSE(fs::exists(root_ / ".walk.part"));
}

TEST_F(StageCache, AStopRequestComesBeforeTheWork) {
    std::stop_source stop;
    run_.stop = stop.get_token();
    stop.request_stop();
    EXPECT_THROW(make("k", "one"), Stopped);
    EXPECT_EQ(made_, 0);
}

TEST(StageKey, HangsOnEverythingTheFilesDependOn) {
    const auto key = [](const char* stage, int width, const char* input, std::uint64_t seed) {
        return stage_key(stage, {{"width", width}}, {input}, seed);
    };
    const std::string base = key("walk", 8, "a", 1);
    EXPECT_EQ(base, key("walk", 8, "a", 1));
    EXPECT_NE(base, key("views", 8, "a", 1));
    EXPECT_NE(base, key("walk", 9, "a", 1));
    EXPECT_NE(base, key("walk", 8, "b", 1));
    EXPECT_NE(base, key("walk", 8, "a", 2));
    EXPECT_NE(code_version("panorama"), code_version("splat"));
    EXPECT_NE(code_version("metrics"), code_version("scores"))
        << "scores hang on the code of the metrics, true pictures do not";
}

TEST(RunFolder, SlugsAreShortAndPlain) {
    EXPECT_EQ(slug_of("A cozy bedroom, 3 chairs!"), "a-cozy-bedroom-3-chairs");
    EXPECT_EQ(slug_of("  ../../etc/passwd "), "etc-passwd");
    EXPECT_EQ(slug_of("\xe5\xaf\x9d\xe5\xae\xa4"), "scene");
    EXPECT_EQ(slug_of(""), "scene");
    EXPECT_LE(slug_of(std::string(5000, 'x')).size(), 60u);
}

TEST_F(StageCache, AFolderIsLockedForOneProgram) {
    const FolderLock lock(root_);
    EXPECT_THROW(FolderLock{root_}, Error);
}

TEST_F(StageCache, TheLockIsReleased) {
    { const FolderLock lock(root_); }
    EXPECT_NO_THROW(FolderLock{root_});
}

}  // namespace
}  // namespace fastscene
