#include "fastscene/nn/runtime.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace fastscene {
namespace {

// Ends with 1 and the message on stderr, as the program does.
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
