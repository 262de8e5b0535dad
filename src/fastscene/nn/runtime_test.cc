#include "fastscene/nn/runtime.h"

#include <ATen/ATen.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <new>

#include "fastscene/base/error.h"
#include "fastscene/base/failure.h"

namespace fastscene {
namespace {

TEST(TorchErrors, AreOneLineAndLackOfMemoryIsKnown) {
    const auto caught = [](const std::function<void()>& act) {
        try {
            act();
        } catch (const std::exception& e) {
            return std::pair{short_message(e), is_lack_of_memory(e)};
        }
        return std::pair{std::string("none"), false};
    };
    const auto sizes = caught([] { (void)at::add(at::zeros({2}), at::zeros({3})); });
    EXPECT_NE(sizes.first.find("must match the size"), std::string::npos) << sizes.first;
    EXPECT_EQ(sizes.first.find('\n'), std::string::npos) << sizes.first;
    EXPECT_EQ(sizes.first.find("frame #"), std::string::npos) << sizes.first;
    EXPECT_FALSE(sizes.second);
    EXPECT_TRUE(caught([] { (void)at::empty({std::int64_t{1} << 48}, at::kFloat); }).second);
    EXPECT_TRUE(caught([] { throw std::bad_alloc(); }).second);
    EXPECT_EQ(caught([] { throw Error("a file: expected this, found that"); }).first,
              "a file: expected this, found that");
}

// Exits with 1 and the message on stderr, like the program.
[[noreturn]] void run_with_little_address_space(std::size_t spare) {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t limit = pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + spare;
    const rlimit limits{limit, limit};
    ::setrlimit(RLIMIT_AS, &limits);
    try {
        use_our_threads();
    } catch (const std::exception& error) {
        std::fputs(error.what(), stderr);
        std::_Exit(1);
    }
    std::_Exit(0);
}

TEST(RuntimeDeathTest, NoRoomToMultiplyIsSaidInPlaceOfAskingForEver) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(run_with_little_address_space(60 << 20), testing::ExitedWithCode(1), "address space");
    EXPECT_EXIT(run_with_little_address_space(std::size_t{4} << 30), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace fastscene
