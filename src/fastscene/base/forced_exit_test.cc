#include "fastscene/base/forced_exit.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "fastscene/base/file.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// A forced exit ends the process, so each runs in one of its own.
class ForcedExit : public testing::Test {
  protected:
    void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(ForcedExit, WaitsWhileItIsHeld) {
    const ExitHold hold;
    EXPECT_FALSE(begin_forced_exit());
    const ExitHold another;
    EXPECT_FALSE(begin_forced_exit());
}

TEST_F(ForcedExit, DutiesAreDoneTheNewestFirst) {
    const auto play = [] {
        const ExitDuty one([] { std::fputs("one ", stderr); });
        const ExitDuty failing([] { throw 1; });
        ExitDuty dismissed([] { std::fputs("never ", stderr); });
        dismissed.dismiss();
        { const ExitDuty over([] { std::fputs("never ", stderr); }); }
        const ExitDuty two([] { std::fputs("two ", stderr); });
        { const ExitHold hold; }
        if (begin_forced_exit()) ::_exit(7);
    };
    EXPECT_EXIT(play(), testing::ExitedWithCode(7), "^two one $");
}

// Who is about to rename a file, or to change what a duty saves, does not get to it any more.
TEST_F(ForcedExit, NothingIsFinishedOnceItHasBegun) {
    const auto play = [] {
        ExitDuty duty([] { std::this_thread::sleep_for(100ms); });
        const std::jthread work([&] {
            std::this_thread::sleep_for(30ms);
            duty.dismiss();
            std::fputs("renamed", stderr);
        });
        const std::jthread other([&] {
            std::this_thread::sleep_for(30ms);
            const ExitHold hold;
            std::fputs("changed", stderr);
        });
        if (begin_forced_exit()) {
            std::this_thread::sleep_for(100ms);
            std::fputs("gone", stderr);
            ::_exit(0);
        }
    };
    EXPECT_EXIT(play(), testing::ExitedWithCode(0), "^gone$");
}

TEST_F(ForcedExit, LeavesNoTemporaryFile) {
    const fs::path folder = fs::temp_directory_path() / ("fastscene-forced-exit-" + std::to_string(::getpid()));
    fs::remove_all(folder);
    make_directories(folder);
    write_file(folder / "file", std::string_view("old"));
    const auto play = [&] {
        write_pieces(folder / "file", [](const auto& put) {
            put("new");
            if (begin_forced_exit()) ::_exit(0);
        });
    };
    EXPECT_EXIT(play(), testing::ExitedWithCode(0), "");
    EXPECT_EQ(read_file(folder / "file"), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace fastscene
